//! Profile polynomials in t = 2z - 1, highest power first.

use crate::scalar::Scalar;

/// A polynomial's value, by Horner's rule.
#[inline]
pub(crate) fn value<S: Scalar>(terms: &[S], t: S) -> S {
    terms.iter().fold(S::ZERO, |sum, &term| term.add_product(sum, t))
}

/// A polynomial's values at a block of arguments.
#[inline]
pub(crate) fn values<S: Scalar, const N: usize>(terms: &[S], t: &[S; N]) -> [S; N] {
    let Some((&first, rest)) = terms.split_first() else {
        return [S::ZERO; N];
    };
    let mut sums = [first; N];
    for &term in rest {
        for (sum, &t) in sums.iter_mut().zip(t) {
            *sum = term.add_product(*sum, t);
        }
    }
    sums
}
