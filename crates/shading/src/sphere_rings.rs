//! A sphere's normals ring by ring, with their density.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Normals of one slant, evenly spread over the turn.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// Polar angle about the optical axis, radians.
    pub slant: f64,
    /// Tilts, radians.
    pub tilts: Vec<f64>,
    /// The share of each of its normals: those of all rings sum to 1.
    pub weight: f64,
}

/// The golden section of the turn, by which each ring is turned against the one within.
const TURN: f64 = 0.618_033_988_749_895;

/// Rings that lie as far apart as their normals, `spacing` radians or a little less.
///
/// The midpoint rule in the slant, with the exact share of each ring under the density
/// cos(slant) / π.
#[must_use]
pub fn rings(spacing: f64) -> Vec<Ring> {
    let count = (FRAC_PI_2 / spacing).ceil().max(1.0);
    let edge = |k: f64| (FRAC_PI_2 * k / count).sin().powi(2);
    (0..count as usize)
        .map(|k| {
            let slant = FRAC_PI_2 * (k as f64 + 0.5) / count;
            let around = (TAU * slant.sin() / spacing).ceil().max(3.0);
            let tilt = |j: usize| TAU * (j as f64 + TURN * k as f64) / around;
            Ring {
                slant,
                tilts: (0..around as usize).map(tilt).collect(),
                weight: (edge(k as f64 + 1.0) - edge(k as f64)) / around,
            }
        })
        .collect()
}

impl Ring {
    /// Its unit normals.
    pub fn normals(&self) -> impl Iterator<Item = [f64; 3]> {
        let (sine, cosine) = self.slant.sin_cos();
        self.tilts.iter().map(move |tilt| [sine * tilt.cos(), sine * tilt.sin(), cosine])
    }
}
