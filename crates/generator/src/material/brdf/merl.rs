//! A BRDF tabulated in half-way and difference angles, as in the MERL database: W. Matusik, H.
//! Pfister, M. Brand and L. McMillan, "A Data-Driven Reflectance Model", SIGGRAPH 2003. The angles
//! are those of S. Rusinkiewicz, "A New Change of Variables for Efficient BRDF
//! Representation", 1998.

use crate::material::brdf::{Brdf, Geometry};
use std::f64::consts::{FRAC_PI_2, PI};

/// Number of bins in θ_h, θ_d and φ_d.
pub const BINS: [usize; 3] = [90, 90, 180];

/// One channel of a table. Bins are indexed by θ_h, then θ_d, then φ_d. They are equal in θ_d over
/// \[0, π/2\], in φ_d over \[0, π), and in √θ_h over \[0, √(π/2)\].
///
/// Between bin centers f is linear in each of the three. Beyond the outermost centers of θ_h and
/// θ_d it is constant; in φ_d it is periodic (φ_d + π exchanges light and view). Bins without a
/// value are below zero in the files and are skipped: those of the eight bins around a point that
/// have a value share the weight, and f is 0 if none has. An isotropic surface cannot distinguish
/// φ_d from -φ_d, so f is the mean of the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Merl {
    values: Vec<f64>,
}

/// The largest accepted value: sums of its squares are finite.
const LARGEST: f64 = 1e100;

impl Merl {
    /// From values in 1/sr, which are below zero for bins without a value. `None` if their number
    /// differs from the number of bins, or if one is not finite or beyond 1e100, where squares
    /// overflow.
    #[must_use]
    pub fn new(values: Vec<f64>) -> Option<Self> {
        let fits = values.len() == BINS.iter().product::<usize>();
        (fits && values.iter().all(|value| value.abs() <= LARGEST)).then_some(Self { values })
    }

    /// Fraction of bins without a value.
    #[must_use]
    pub fn missing(&self) -> f64 {
        let count = self.values.iter().filter(|value| **value < 0.0).count();
        count as f64 / self.values.len() as f64
    }

    fn interpolated(
        &self,
        half: [(usize, f64); 2],
        difference: [(usize, f64); 2],
        phi: f64,
    ) -> f64 {
        let (mut sum, mut weights) = (0.0, 0.0);
        let azimuth = around(phi / PI * BINS[2] as f64, BINS[2]);
        for (h, of_half) in half {
            for (d, of_difference) in difference {
                for (p, of_azimuth) in azimuth {
                    let value = self.values[(h * BINS[1] + d) * BINS[2] + p];
                    let weight = of_half * of_difference * of_azimuth;
                    if value >= 0.0 && weight > 0.0 {
                        sum += weight * value;
                        weights += weight;
                    }
                }
            }
        }
        if weights > 0.0 { sum / weights } else { 0.0 }
    }
}

impl Brdf for Merl {
    fn value(&self, at: Geometry) -> f64 {
        let (cos_half, sin_half) = at.half_squared();
        let theta_h = sin_half.sqrt().atan2(cos_half.sqrt());
        let cos_d = at.difference_cosine();
        let sin_d = ((1.0 - cos_d) * (1.0 + cos_d)).sqrt();
        // cos θ_r - cos θ_i = 2 sin θ_h sin θ_d cos φ_d.
        let sines = 2.0 * sin_half.sqrt() * sin_d;
        let cosine = if sines > 0.0 { (at.reflected - at.incident) / sines } else { 0.0 };
        let phi = cosine.clamp(-1.0, 1.0).acos();
        let half = between((theta_h / FRAC_PI_2).sqrt() * BINS[0] as f64, BINS[0]);
        let difference = between(cos_d.acos() / FRAC_PI_2 * BINS[1] as f64, BINS[1]);
        let of = |phi| self.interpolated(half, difference, phi);
        0.5 * (of(phi) + of(PI - phi))
    }

    /// The third bin of θ_h begins at 8e-4 rad; the lobes of the database are wider.
    fn width(&self) -> f64 {
        5e-3
    }
}

/// The two bins whose centers enclose a place, and their weights.
fn between(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).clamp(0.0, (count - 1) as f64);
    let low = (place as usize).min(count - 2);
    let share = place - low as f64;
    [(low, 1.0 - share), (low + 1, share)]
}

/// The same for a periodic coordinate, where the last bin is next to the first.
fn around(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).rem_euclid(count as f64);
    let low = (place as usize).min(count - 1);
    let share = place - low as f64;
    [(low, 1.0 - share), ((low + 1) % count, share)]
}
