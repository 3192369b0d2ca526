//! The canonical order and sign of the components: every run, thread count and instruction set
//! gives the same basis.
//!
//! Order: falling eigenvalue, then |m|, then +m before -m. Sign: h = u / sin^|m| is positive at the
//! pole.

use crate::basis::profile;

/// A profile with the values that determine its place in the order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// |m|.
    pub azimuth: usize,
    /// Index within the block of its |m|, by falling eigenvalue.
    pub number: usize,
    /// Eigenvalue; `None` for the constant image, which comes first.
    pub eigenvalue: Option<f64>,
}

/// Sorts profiles into canonical order.
pub fn sort(profiles: &mut [Ranked]) {
    let size = |ranked: &Ranked| ranked.eigenvalue.unwrap_or(f64::INFINITY);
    profiles.sort_by(|a, b| {
        size(b).total_cmp(&size(a)).then(a.azimuth.cmp(&b.azimuth)).then(a.number.cmp(&b.number))
    });
}

/// The signed orders of one profile, +m before -m.
#[must_use]
pub fn orders(azimuth: usize) -> &'static [i32] {
    if azimuth == 0 { &[1] } else { &[1, -1] }
}

/// The factor ±1 that makes h positive at the pole, z = 1.
#[must_use]
pub fn sign(chebyshev: &[f64]) -> f64 {
    if profile::evaluate(chebyshev, 1.0) < 0.0 { -1.0 } else { 1.0 }
}
