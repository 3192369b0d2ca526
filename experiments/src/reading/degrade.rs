//! Camera effects on an image of peak 1: noise, few bits, clipping, hidden parts.

use eigenshade_cli::picture;
use eigenshade_model::srgb::linear;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};

/// One kind of degradation.
#[derive(Clone, Copy, Debug)]
pub struct Degradation {
    /// The name of the degradation.
    pub name: &'static str,
    /// Standard deviation of normal noise on each pixel.
    pub noise: f64,
    /// How pixels are stored.
    pub storage: Storage,
    /// Whether the left half, n_x < 0, is hidden.
    pub is_half_hidden: bool,
    /// Whether the lights and materials of the images are absent from the statistics.
    pub is_unknown: bool,
}

/// How pixels are stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// As exact numbers.
    Exact,
    /// In 8 bits, linear, with the peak at 254.
    Bits,
    /// In 8 bits of sRGB, with the peak at 254.
    SrgbBits,
    /// Clipped halfway between the image's mean and its peak, with the clipped pixels left out.
    Clipped,
    /// The same, with the clipped pixels kept at their clipped values.
    ClippedAndKept,
}

const NONE: Degradation = Degradation {
    name: "as it is",
    noise: 0.0,
    storage: Storage::Exact,
    is_half_hidden: false,
    is_unknown: false,
};
const HALF: Degradation = Degradation { name: "half hidden", is_half_hidden: true, ..NONE };

/// Every degradation that is reported.
pub const ALL: [Degradation; 12] = [
    NONE,
    Degradation { name: "noise 1 %", noise: 0.01, ..NONE },
    Degradation { name: "noise 5 %", noise: 0.05, ..NONE },
    Degradation { name: "8 bits, linear", storage: Storage::Bits, ..NONE },
    Degradation { name: "8 bits, sRGB", storage: Storage::SrgbBits, ..NONE },
    Degradation { name: "clipped, left out", storage: Storage::Clipped, ..NONE },
    Degradation { name: "clipped, kept", storage: Storage::ClippedAndKept, ..NONE },
    HALF,
    Degradation { name: "half hidden, noise 1 %", noise: 0.01, ..HALF },
    Degradation { name: "half hidden, noise 5 %", noise: 0.05, ..HALF },
    Degradation { name: "unknown, noise 1 %", noise: 0.01, is_unknown: true, ..NONE },
    Degradation { name: "unknown, half hidden, noise 1 %", noise: 0.01, is_unknown: true, ..HALF },
];

impl Degradation {
    /// The degraded image and the weight of each pixel. `seed` selects the noise, which is the same
    /// on every host and run.
    #[must_use]
    pub fn apply(&self, image: &[f64], normals: &[[f64; 3]], seed: u64) -> (Vec<f64>, Vec<f64>) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mean = image.iter().sum::<f64>() / image.len() as f64;
        let clip = 0.5 * (1.0 + mean);
        let scale = 254.0 / 255.0;
        let pixel = |(value, normal): (&f64, &[f64; 3])| {
            let noise: f64 = StandardNormal.sample(&mut random);
            let value = value + self.noise * noise;
            let is_hidden = self.is_half_hidden && normal[0] < 0.0;
            let is_out = self.storage == Storage::Clipped && value >= clip;
            let stored = match self.storage {
                Storage::Exact => value,
                Storage::Bits => (254.0 * value).round().max(0.0) / 254.0,
                Storage::SrgbBits => {
                    linear(f64::from(picture::srgb(scale * value)) / 255.0) / scale
                }
                Storage::Clipped | Storage::ClippedAndKept => value.min(clip),
            };
            (stored, if is_hidden || is_out { 0.0 } else { 1.0 })
        };
        image.iter().zip(normals).map(pixel).unzip()
    }
}
