//! Polynomials in t = 2z - 1 that are orthogonal over a sphere's normals, azimuth by azimuth.
//!
//! Under the normals' density 2z dz times sin^2m = (1 - z²)^m. For m = 0 they are Jacobi's of
//! (0, 1), whose recurrence is known. From m to m + 1 the density takes the factor
//! (1 - t)(3 + t) / 4, and the recurrence one step of the Cholesky factors for each of the two,
//! turned round (Christoffel's transformation): both together take one from the terms that are
//! known.

use crate::index::layout::HALVES;
use crate::mathematics::{Libm, Mathematics};
use crate::scalar::Scalar;

/// Most terms of what is rewritten.
pub(super) const MOST: usize = HALVES;

/// Azimuths of which polynomials can be written in these.
const AZIMUTHS: usize = 64;

/// Most terms of the recurrence of m = 0: an azimuth has m fewer.
const TERMS: usize = AZIMUTHS + MOST;

/// Longest polynomial of an azimuth that can be written in these.
pub(super) const fn longest(azimuth: usize) -> usize {
    if azimuth < AZIMUTHS { MOST } else { 0 }
}

/// The orthogonal polynomials of one azimuth, p_k+1 = (2t - at_k) p_k - below_k p_k-1, p_0 = 1:
/// those of a [recurrence](crate::index::layout::Recurrence).
pub(super) struct Density<S> {
    azimuth: usize,
    terms: usize,
    /// at_k and below_k.
    recurrence: [[S; 2]; TERMS],
}

impl<S: Scalar> Density<S> {
    /// That of m = 0, good for polynomials of so many terms less their azimuth.
    pub(super) fn new(terms: usize) -> Self {
        let mut recurrence = [[S::ZERO; 2]; TERMS];
        let two = S::ONE + S::ONE;
        let (mut odd, mut left) = (S::ONE, S::ONE);
        // 2 / (2k + 1)(2k + 3) and 4 k (k + 1) / (2k + 1)².
        for [at, below] in recurrence.iter_mut().take(terms) {
            odd += two;
            let right = odd.reciprocal();
            (*at, *below) = (two * left * right, S::ONE - left * left);
            left = right;
        }
        Self { azimuth: 0, terms, recurrence }
    }

    /// at_k and below_k of the azimuth.
    pub(super) const fn recurrence(&self) -> &[[S; 2]; TERMS] {
        &self.recurrence
    }

    pub(super) fn below(&self) -> impl Iterator<Item = S> {
        self.recurrence.iter().map(|&[_, below]| below)
    }

    /// That of an azimuth beyond: the rows times 2 - 2t, then times 2t + 6. The last that is known
    /// takes part of one that is not.
    pub(super) fn turn_to(&mut self, azimuth: usize) {
        let (two, six) = (S::from_whole(2), S::from_whole(6));
        while self.azimuth < azimuth {
            let rows = self.recurrence.get_mut(..self.terms).unwrap_or_default();
            let Some((mut before, rows)) = rows.split_first_mut() else { return };
            // A pivot of the first factor, and what one of the second lacks.
            let (mut pivot, mut lack) = (two - before[0], S::ZERO);
            for row in rows {
                let share = row[1] * pivot.reciprocal();
                let second = two - pivot - share + six - lack;
                let below = lack * second;
                pivot = two - row[0] - share;
                lack = share * pivot * second.reciprocal();
                *before = [second + lack - six, below];
                before = row;
            }
            self.azimuth += 1;
            self.terms -= 1;
        }
    }
}

/// The roots of the mean squares of an azimuth's polynomials over a sphere, from their below_k.
pub(super) fn sizes<S: Scalar>(
    azimuth: usize,
    below: impl Iterator<Item = S>,
) -> impl Iterator<Item = S> {
    // Of sin^m cos mβ.
    let mut size =
        if azimuth == 0 { S::ONE } else { Libm::inverse_root(S::from_whole(2 * azimuth + 2)) };
    below.enumerate().map(move |(k, below)| {
        if k > 0 {
            size = size * Libm::square_root(below);
        }
        size
    })
}
