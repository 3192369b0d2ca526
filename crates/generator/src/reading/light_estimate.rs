//! The light of an image whose material is known: linear, d = T L.
//!
//! Before any pixel is seen, L is s times a light of the database's statistics, s
//! its exposure. Where light turns freely that is mean zero and variance (38) for
//! l > 0, and for L_0^0 the mean (39) and its variance; else the mean and covariance
//! of the lights, which have no more directions than there are lights. Degrees that the material damps below the noise come out near
//! zero rather than as noise.

use super::coefficients::{column, decompose};
use super::observation::Observation;
use super::prior::Prior;
use eigenshade_model::error::Result;
use faer::linalg::solvers::Svd;
use faer::{Col, Mat};

/// Exposures tried around that of the image's energy, from 1/100 to 100 times.
const TRIED: i32 = 80;

/// Halvings of a step of that grid: to 1e-13 of the exposure, which is all of a light
/// whose mean the database fixes.
const HALVINGS: i32 = 40;

/// One material, ready to be asked for the light.
#[derive(Debug)]
pub struct LightEstimate<'a> {
    observation: &'a Observation,
    prior: &'a Prior,
    /// √W E T.
    images: Mat<f64>,
    /// √W E T of the mean light.
    mean_image: Col<f64>,
    /// Of √W E T V, V the factor of the light's covariance.
    svd: Svd<f64>,
}

/// How well a material explains one channel, and with which light.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// The posterior mean of the light, in the order of [`eigenshade_index::light`],
    /// in radiance of the image's own exposure.
    pub light: Vec<f64>,
    /// The exposure s of the light, that of largest evidence.
    pub exposure: f64,
    /// Logarithm of the image's probability density given the material, up to a
    /// constant of the noise.
    pub evidence: f64,
    /// Weighted rms of what image this light leaves.
    pub residual_rms: f64,
}

impl<'a> LightEstimate<'a> {
    /// The material of this transfer.
    ///
    /// # Errors
    ///
    /// If singular values do not converge.
    pub fn new(
        observation: &'a Observation,
        prior: &'a Prior,
        transfer: &Mat<f64>,
    ) -> Result<Self> {
        let images = &observation.design * transfer;
        let mean_image = &images * &prior.light.mean;
        let svd = decompose(&(&images * &prior.light.centred))?;
        Ok(Self { observation, prior, images, mean_image, svd })
    }

    /// What the light has to explain: √W (I - m + E d_m), with d_m the mean image's
    /// components, which `project` subtracts.
    fn target(&self, channel: usize) -> Col<f64> {
        self.observation.centred(channel) + &self.observation.design * column(&self.prior.mean)
    }

    /// The best light for one channel, at this standard deviation of the noise of a
    /// pixel of weight 1.
    #[must_use]
    pub fn explain(&self, channel: usize, noise: f64) -> Explained {
        let target = self.target(channel);
        let split = Split::new(&self.svd, &self.mean_image, &target);
        let (exposure, evidence) = self.likeliest(&split, noise);
        let singular = self.svd.S().column_vector();
        let shrunk = Col::from_fn(singular.nrows(), |k| {
            let spread = exposure * singular[k];
            let along = split.target[k] - exposure * split.mean[k];
            match spread * spread + noise * noise {
                total if total > 0.0 => exposure * spread * along / total,
                _ => 0.0,
            }
        });
        let prior = &self.prior.light;
        let light = exposure * &prior.mean + &prior.centred * (self.svd.V() * shrunk);
        let left = target - &self.images * &light;
        let light = light.iter().copied().collect();
        let residual_rms = (left.squared_norm_l2() / self.observation.weight).sqrt();
        Explained { light, exposure, evidence, residual_rms }
    }

    /// The exposure of largest evidence, and that evidence: on a grid of a twentieth
    /// of a decade around the exposure of the image's energy, then by halving.
    fn likeliest(&self, split: &Split, noise: f64) -> (f64, f64) {
        let spread: f64 = self.svd.S().column_vector().iter().rev().map(|s| s * s).sum();
        let middle = (split.energy / (spread + self.mean_image.squared_norm_l2())).sqrt();
        if !(middle > 0.0 && middle.is_finite()) {
            // A black material, or a black image: no light is better than any other.
            return (0.0, self.evidence(split, 0.0, noise));
        }
        let at = |step: f64| {
            let exposure = middle * 10f64.powf(step / f64::from(TRIED / 4));
            (step, exposure, self.evidence(split, exposure, noise))
        };
        let grid = (-TRIED / 2..=TRIED / 2).map(|step| at(f64::from(step)));
        let later = |a: (f64, f64, f64), b: (f64, f64, f64)| if b.2 > a.2 { b } else { a };
        let mut best = grid.reduce(later).unwrap_or((0.0, middle, 0.0));
        for halving in 1..=HALVINGS {
            let width = 0.5f64.powi(halving);
            let step = best.0;
            best = later(later(best, at(step - width)), at(step + width));
        }
        (best.1, best.2)
    }

    /// log p(I | material, s, noise) without the factor of white noise,
    /// (√2π noise)^-pixels. All of it is a sum of squares: a difference of energies
    /// would leave s but half of its digits.
    fn evidence(&self, split: &Split, exposure: f64, noise: f64) -> f64 {
        let floor = noise * noise;
        if floor <= 0.0 {
            return 0.0;
        }
        let beside = split.apart[0] - exposure * split.apart[1];
        let (mut misfit, mut freedom) = (beside * beside, 0.0);
        for (k, singular) in self.svd.S().column_vector().iter().enumerate() {
            let spread = (exposure * singular).powi(2);
            let along = split.target[k] - exposure * split.mean[k];
            misfit += along * along * floor / (floor + spread);
            freedom += (spread / floor).ln_1p();
        }
        -0.5 * ((split.rest + misfit) / floor + freedom)
    }
}

/// A channel and the mean light's image, along the images of the light's
/// deviations and beside them.
struct Split {
    /// Along the left singular vectors: the channel, then the mean light's image.
    target: Col<f64>,
    mean: Col<f64>,
    /// Beside them, along what is left of the mean light's image: both again.
    apart: [f64; 2],
    /// Energy of the channel beside all of these.
    rest: f64,
    /// Energy of the channel.
    energy: f64,
}

impl Split {
    fn new(svd: &Svd<f64>, mean_image: &Col<f64>, channel: &Col<f64>) -> Self {
        let left = svd.U();
        let (target, mean) = (left.transpose() * channel, left.transpose() * mean_image);
        let beside = channel - left * &target;
        let mean_beside = mean_image - left * &mean;
        let length = mean_beside.norm_l2();
        let direction = if length > 0.0 { mean_beside / length } else { mean_beside };
        let along = direction.transpose() * &beside;
        let rest = (beside - along * direction).squared_norm_l2();
        Self { target, mean, apart: [along, length], rest, energy: channel.squared_norm_l2() }
    }
}
