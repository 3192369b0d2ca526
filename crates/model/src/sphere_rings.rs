//! The normals of a sphere in rings, with their density.

use std::f64::consts::{FRAC_PI_2, TAU};

/// Normals of one slant, evenly spaced in tilt.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// Polar angle about the optical axis, radians.
    pub slant: f64,
    /// The tilts of the normals, radians.
    pub tilts: Vec<f64>,
    /// The weight of each normal of the ring. The weights of all normals of all rings sum to 1.
    pub weight: f64,
}

/// The golden section. Each ring is rotated relative to the previous one by this fraction of its
/// spacing.
const TURN: f64 = 0.618_033_988_749_895;

/// Rings about as far apart as their normals: `spacing` radians or slightly less.
///
/// Uses the midpoint rule in the slant, with the exact share of each ring under the density
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
    /// The unit normals of the ring.
    pub fn normals(&self) -> impl Iterator<Item = [f64; 3]> {
        let (sine, cosine) = self.slant.sin_cos();
        self.tilts.iter().map(move |tilt| [sine * tilt.cos(), sine * tilt.sin(), cosine])
    }
}
