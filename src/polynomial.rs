//! Profile polynomials in t = 2z - 1, highest term first: powers, or Chebyshev series
//! if they are longer than [`POWERS`].

use crate::index::layout::POWERS;
use crate::scalar::Scalar;

/// A polynomial's value, by Horner's rule or Clenshaw's recurrence.
#[inline]
pub(crate) fn value<S: Scalar>(terms: &[S], t: S) -> S {
    if terms.len() <= POWERS {
        let Some((&first, rest)) = terms.split_first() else { return S::ZERO };
        return rest.iter().fold(first, |sum, &term| term.add_product(sum, t));
    }
    let [value] = series(terms, &[t]);
    value
}

/// A polynomial's values at a block of arguments. Unless `LONG` none is a series: then no
/// call stands in a loop over azimuths, around which all registers were to be saved.
#[inline(always)]
pub(crate) fn values<S: Scalar, const LONG: bool, const N: usize>(
    terms: &[S],
    t: &[S; N],
) -> [S; N] {
    if LONG && terms.len() > POWERS {
        return series(terms, t);
    }
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

/// Two polynomials' values, of as many terms, at a block of arguments; `LONG` as for [`values`].
#[inline(always)]
pub(crate) fn pairs<S: Scalar, const LONG: bool, const N: usize>(
    [one, other]: [&[S]; 2],
    t: &[S; N],
) -> [[S; N]; 2] {
    let (Some((&first, rest)), Some((&second, others))) = (one.split_first(), other.split_first())
    else {
        return [[S::ZERO; N]; 2];
    };
    if LONG && one.len() > POWERS {
        return [series(one, t), series(other, t)];
    }
    let (mut sums, mut more) = ([first; N], [second; N]);
    for (&term, &another) in rest.iter().zip(others) {
        for ((sum, more), &t) in sums.iter_mut().zip(&mut more).zip(t) {
            *sum = term.add_product(*sum, t);
            *more = another.add_product(*more, t);
        }
    }
    [sums, more]
}

/// A Chebyshev series at a block of arguments.
#[inline(never)]
fn series<S: Scalar, const N: usize>(terms: &[S], t: &[S; N]) -> [S; N] {
    let (mut next, mut after) = ([S::ZERO; N], [S::ZERO; N]);
    let Some((&last, higher)) = terms.split_last() else { return next };
    for &term in higher {
        for ((next, after), &t) in next.iter_mut().zip(&mut after).zip(t) {
            let sum = (term - *after).add_product(t + t, *next);
            (*after, *next) = (*next, sum);
        }
    }
    for ((next, after), &t) in next.iter_mut().zip(&after).zip(t) {
        *next = (last - *after).add_product(t, *next);
    }
    next
}
