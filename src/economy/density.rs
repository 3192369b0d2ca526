//! Polynomials in t = 2z - 1 that are orthogonal over a sphere's normals, azimuth by azimuth.
//!
//! Their weight is the density 2z dz of the normals times sin^2m = (1 - z²)^m. For m = 0 they are
//! the Jacobi polynomials of (0, 1), whose recurrence is known. From m to m + 1 the density gains
//! the factor (1 - t)(3 + t) / 4. For each of the two linear factors the recurrence takes one step:
//! its Cholesky factors are multiplied in reverse order (Christoffel's transformation). Both steps
//! together reduce the number of known terms by one.

use crate::index::layout::EVEN_ODD_TERMS;
use crate::mathematics::{Libm, Mathematics};
use crate::scalar::Scalar;

/// The largest number of terms of a polynomial that is converted.
pub(super) const MOST: usize = EVEN_ODD_TERMS;

/// Number of azimuths whose polynomials can be converted.
const AZIMUTHS: usize = 64;

/// Terms of the recurrence of m = 0. Azimuth m has m terms fewer.
const TERMS: usize = AZIMUTHS + MOST;

/// The longest polynomial of an azimuth that can be converted.
pub(super) const fn longest(azimuth: usize) -> usize {
    if azimuth < AZIMUTHS { MOST } else { 0 }
}

/// The orthogonal polynomials of one azimuth, p_k+1 = (2t - at_k) p_k - below_k p_k-1, p_0 = 1: the
/// polynomials of a [recurrence](crate::index::layout::Recurrence).
pub(super) struct Density<S> {
    azimuth: usize,
    terms: usize,
    /// The coefficients at_k and below_k.
    recurrence: [[S; 2]; TERMS],
}

impl<S: Scalar> Density<S> {
    /// The density of m = 0. It serves polynomials of azimuth m with up to `terms` - m terms.
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

    /// The coefficients at_k and below_k of the current azimuth.
    pub(super) const fn recurrence(&self) -> &[[S; 2]; TERMS] {
        &self.recurrence
    }

    pub(super) fn below(&self) -> impl Iterator<Item = S> {
        self.recurrence.iter().map(|&[_, below]| below)
    }

    /// Advances to a higher azimuth: for each step, the density is multiplied by 2 - 2t, then by
    /// 2t + 6. The last known row needs part of an unknown one, so each step loses one row.
    pub(super) fn turn_to(&mut self, azimuth: usize) {
        let (two, six) = (S::from_whole(2), S::from_whole(6));
        while self.azimuth < azimuth {
            let rows = self.recurrence.get_mut(..self.terms).unwrap_or_default();
            let Some((mut before, rows)) = rows.split_first_mut() else { return };
            // A pivot of the first factor, and the difference of a pivot of the second.
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

/// The root mean squares of an azimuth's polynomials over a sphere, from their below_k.
pub(super) fn sizes<S: Scalar>(
    azimuth: usize,
    below: impl Iterator<Item = S>,
) -> impl Iterator<Item = S> {
    // The root mean square of sin^m cos mβ.
    let mut size =
        if azimuth == 0 { S::ONE } else { Libm::inverse_root(S::from_whole(2 * azimuth + 2)) };
    below.enumerate().map(move |(k, below)| {
        if k > 0 {
            size = size * Libm::square_root(below);
        }
        size
    })
}
