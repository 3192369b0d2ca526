//! Powers of t and Chebyshev series in t, in place. What is longer than [`POWERS`] is a series
//! already, and stays.

use crate::index::layout::POWERS;
use crate::scalar::Scalar;

/// Powers, highest first, to the Chebyshev series that is the same polynomial.
pub(super) fn to_chebyshev<S: Scalar>(terms: &mut [S]) {
    if terms.len() > POWERS {
        return;
    }
    let half = S::from_f64(0.5);
    // By Horner's rule, lowest first; 2 t T_k = T_k+1 + T_k-1.
    let mut series = [S::ZERO; POWERS];
    for &term in terms.iter() {
        let mut next = [S::ZERO; POWERS];
        for (k, &c) in series.iter().enumerate() {
            for (place, share) in
                if k == 0 { [(1, c), (0, S::ZERO)] } else { [(k + 1, half * c), (k - 1, half * c)] }
            {
                if let Some(place) = next.get_mut(place) {
                    *place += share;
                }
            }
        }
        next[0] += term;
        series = next;
    }
    for (term, c) in terms.iter_mut().rev().zip(series) {
        *term = c;
    }
}

/// The way back.
pub(super) fn to_powers<S: Scalar>(terms: &mut [S]) {
    if terms.len() > POWERS {
        return;
    }
    // By Clenshaw's recurrence on polynomials, b_k = c_k + 2 t b_k+1 - b_k+2, lowest first.
    let (mut next, mut after) = ([S::ZERO; POWERS], [S::ZERO; POWERS]);
    for (k, &c) in terms.iter().enumerate() {
        let last = k + 1 == terms.len();
        let mut sum = after.map(|one| -one);
        for (place, &one) in sum.iter_mut().skip(1).zip(&next) {
            *place += if last { one } else { one + one };
        }
        sum[0] += c;
        (after, next) = (next, sum);
    }
    for (term, power) in terms.iter_mut().rev().zip(next) {
        *term = power;
    }
}
