//! A tabulated BRDF in half-way and difference angles, as the MERL database has it:
//! W. Matusik, H. Pfister, M. Brand and L. McMillan, "A Data-Driven Reflectance Model",
//! SIGGRAPH 2003; angles of S. Rusinkiewicz, "A New Change of Variables for Efficient
//! BRDF Representation", 1998.

use crate::material::brdf::{Brdf, Geometry};
use std::f64::consts::{FRAC_PI_2, PI};

/// Bins of θ_h, θ_d and φ_d.
pub const BINS: [usize; 3] = [90, 90, 180];

/// One channel of a table: bins by θ_h, within it θ_d, within it φ_d, equal in θ_d
/// over \[0, π/2\] and φ_d over \[0, π), and in √θ_h over \[0, √(π/2)\].
///
/// Between the centres of bins f is linear in each of the three; beyond the outermost
/// centres of θ_h and θ_d it is constant, in φ_d it is periodic (φ_d + π exchanges
/// light and view). Bins without a value, below zero in the files, are left to their
/// neighbours: of the eight about a point those that have one share the weight; where
/// none has, f is 0. An isotropic surface cannot tell φ_d from -φ_d: f is the mean of
/// the two.
#[derive(Clone, Debug, PartialEq)]
pub struct Merl {
    values: Vec<f64>,
}

/// The largest value that means anything: sums of its squares are numbers.
const LARGEST: f64 = 1e100;

impl Merl {
    /// Of these values, 1/sr; below zero where there is none. None if they are not as
    /// many as there are bins, or one is not finite or beyond 1e100, whose squares are none.
    #[must_use]
    pub fn new(values: Vec<f64>) -> Option<Self> {
        let fits = values.len() == BINS.iter().product::<usize>();
        (fits && values.iter().all(|value| value.abs() <= LARGEST)).then_some(Self { values })
    }

    /// Bins without a value, as a share of all.
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

/// The two bins whose centres enclose a place, and their weights.
fn between(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).clamp(0.0, (count - 1) as f64);
    let low = (place as usize).min(count - 2);
    let share = place - low as f64;
    [(low, 1.0 - share), (low + 1, share)]
}

/// The same where the last bin and the first are neighbours.
fn around(place: f64, count: usize) -> [(usize, f64); 2] {
    let place = (place - 0.5).rem_euclid(count as f64);
    let low = (place as usize).min(count - 1);
    let share = place - low as f64;
    [(low, 1.0 - share), ((low + 1) % count, share)]
}
