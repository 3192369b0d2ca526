//! Polynomials in t = 2z - 1 that are orthogonal over a sphere's normals, azimuth by azimuth.
//!
//! Under the normals' density 2z dz times sin^2m = (1 - z²)^m. For m = 0 they are Jacobi's of
//! (0, 1), whose recurrence is known. From m to m + 1 the density takes the factor
//! (1 - t)(3 + t) / 4, and the recurrence one step of the Cholesky factors for each of the two,
//! turned round (Christoffel's transformation): a step takes one from the terms that are known.

use super::basis::{MOST, Recurrence};
use crate::mathematics::{Libm, Mathematics};
use crate::scalar::Scalar;

/// Most terms of the recurrence of m = 0: an azimuth has 2 m fewer.
const TERMS: usize = 128;

/// Longest polynomial of an azimuth that can be written in these.
pub(super) const fn longest(azimuth: usize) -> usize {
    let known = TERMS.saturating_sub(2 * azimuth);
    if known < MOST { known } else { MOST }
}

/// The orthogonal polynomials of one azimuth, of leading term (2 t)^k:
/// t π_k = π_k+1 / 2 + at_k π_k + 2 below_k π_k-1.
pub(super) struct Density<S> {
    azimuth: usize,
    terms: usize,
    at: [S; TERMS],
    below: [S; TERMS],
}

impl<S: Scalar> Density<S> {
    /// That of m = 0, good for polynomials of these lengths.
    pub(super) fn new(lengths: &[u16]) -> Self {
        let (mut at, mut below) = ([S::ZERO; TERMS], [S::ZERO; TERMS]);
        for (k, (at, below)) in at.iter_mut().zip(&mut below).enumerate() {
            let odd = S::from_whole(2 * k + 1).reciprocal();
            *at = odd * S::from_whole(2 * k + 3).reciprocal();
            *below = S::from_whole(k * (k + 1)) * odd * odd;
        }
        let of_azimuths = lengths.iter().zip((1..).step_by(2));
        let terms = of_azimuths.map(|(&length, lost)| usize::from(length) + lost).max();
        Self { azimuth: 0, terms: terms.unwrap_or_default(), at, below }
    }

    /// The mean over a sphere of sin^2m, times that of cos² mβ.
    pub(super) fn weight(&self) -> S {
        match self.azimuth {
            0 => S::ONE,
            m => S::from_whole(2 * m + 2).reciprocal(),
        }
    }

    /// That of m + 1.
    pub(super) fn next(&mut self) {
        self.azimuth += 1;
        self.times(-S::ONE, S::ONE);
        self.times(S::ONE, -S::from_whole(3));
    }

    /// The density times sign (t - root).
    fn times(&mut self, sign: S, root: S) {
        let mut pivot = None;
        let places = self.at.iter_mut().zip(self.below.iter_mut()).take(self.terms);
        let mut places = places.peekable();
        while let Some((at, below)) = places.next() {
            // The square of the factor left of the row's pivot, and of the one below that.
            let left = pivot.map_or(S::ZERO, |pivot: S| *below * pivot.reciprocal());
            let of_row = sign * (*at - root) - left;
            let next = places.peek().map_or(S::ZERO, |(_, below)| **below * of_row.reciprocal());
            (*at, *below) = (root + sign * (of_row + next), left * of_row);
            pivot = Some(of_row);
        }
    }

    /// The root of the mean of π_k² over a sphere, times that of cos² mβ, for each k.
    pub(super) fn sizes(&self) -> impl Iterator<Item = S> {
        let mut square = self.weight();
        let four = S::from_whole(4);
        core::iter::once(square)
            .chain(self.below.iter().skip(1).map(move |&below| {
                square = four * below * square;
                square
            }))
            .map(Libm::square_root)
    }
}

impl<S: Scalar> Recurrence<S> for Density<S> {
    fn term(&self, k: usize) -> [S; 3] {
        let of = |terms: &[S; TERMS]| terms.get(k).copied().unwrap_or_default();
        let below = of(&self.below);
        [S::from_f64(0.5), of(&self.at), below + below]
    }
}
