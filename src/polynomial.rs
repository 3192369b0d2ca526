//! Profile polynomials in t = 2z - 1, highest term first, in the form that their length
//! asks for: [`Form`](crate::index::layout::Form).

use crate::index::layout::{HALVES, POWERS};
use crate::scalar::Scalar;

/// A polynomial's value.
#[inline]
pub(crate) fn value<S: Scalar>(terms: &[S], t: S) -> S {
    if terms.len() <= POWERS {
        let Some((&first, rest)) = terms.split_first() else { return S::ZERO };
        return rest.iter().fold(first, |sum, &term| term.add_product(sum, t));
    }
    let [value] = long(terms, &[t]);
    value
}

/// A polynomial's values at a block of arguments t; u = 2t² - 1 is read where `LONGEST` is not
/// beyond halves.
///
/// None has more terms than `LONGEST`. Only where there may be series does the loop over
/// azimuths hold a call, around which all registers are saved.
#[inline(always)]
pub(crate) fn values<S: Scalar, const LONGEST: usize, const N: usize>(
    terms: &[S],
    [t, u]: [&[S; N]; 2],
) -> [S; N] {
    if LONGEST > HALVES && terms.len() > POWERS {
        return long(terms, t);
    }
    if LONGEST > POWERS && terms.len() > POWERS {
        return halves(terms, [t, u]);
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

/// Two polynomials' values, of as many terms, at a block of arguments; `LONGEST` as for
/// [`values`].
#[inline(always)]
pub(crate) fn pairs<S: Scalar, const LONGEST: usize, const N: usize>(
    [one, other]: [&[S]; 2],
    [t, u]: [&[S; N]; 2],
) -> [[S; N]; 2] {
    let (Some((&first, rest)), Some((&second, others))) = (one.split_first(), other.split_first())
    else {
        return [[S::ZERO; N]; 2];
    };
    if LONGEST > HALVES && one.len() > POWERS {
        return [long(one, t), long(other, t)];
    }
    if LONGEST > POWERS && one.len() > POWERS {
        return [halves(one, [t, u]), halves(other, [t, u])];
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

/// Of more than [`POWERS`] terms, apart from its caller.
#[inline(never)]
fn long<S: Scalar, const N: usize>(terms: &[S], t: &[S; N]) -> [S; N] {
    if terms.len() > HALVES { series(terms, t) } else { halves(terms, [t, &t.map(doubled)]) }
}

/// The argument u = 2t² - 1 = T_2(t).
#[inline(always)]
pub(crate) fn doubled<S: Scalar>(t: S) -> S {
    (-S::ONE).add_product(t + t, t)
}

/// An even and an odd half at a block of arguments, by Horner's rule in u.
#[inline(always)]
fn halves<S: Scalar, const N: usize>(terms: &[S], [t, u]: [&[S; N]; 2]) -> [S; N] {
    // The highest of an odd number of terms is an even power that stands alone.
    let (alone, rest) = terms.split_at_checked(terms.len() % 2).unwrap_or_default();
    let mut sums = [alone.first().copied().unwrap_or(S::ZERO); N];
    for [odd, even] in rest.as_chunks().0 {
        for (sum, (&t, &u)) in sums.iter_mut().zip(t.iter().zip(u)) {
            *sum = even.add_product(*odd, t).add_product(*sum, u);
        }
    }
    sums
}

/// A Chebyshev series at a block of arguments, by Clenshaw's recurrence.
#[inline(always)]
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::layout::Form;

    /// Against sums of cosines, t = cos θ: T_n = cos nθ, and u = cos 2θ. The sums are below 100,
    /// and cos nθ is off by n roundings of 1e-16: some 1e-12 in all.
    #[test]
    fn each_form_is_the_sum_that_it_stands_for() {
        let mut terms = [0.0f64; 2 * HALVES];
        for (k, term) in terms.iter_mut().enumerate() {
            *term = (((7 * k) % 19) as f64 - 9.0) / (1 + k % 5) as f64;
        }
        for length in [0, 1, POWERS, POWERS + 1, POWERS + 2, HALVES, HALVES + 1, 2 * HALVES] {
            let terms = terms.get(..length).unwrap_or_default();
            for angle in [0.0, 0.3, 1.2, 1.6, 2.5, core::f64::consts::PI] {
                let (t, u) = (libm::cos(angle), libm::cos(2.0 * angle));
                let element = |k: usize| match Form::of(length) {
                    Form::Powers => libm::pow(t, k as f64),
                    Form::Halves if k.is_multiple_of(2) => libm::pow(u, (k / 2) as f64),
                    Form::Halves => t * libm::pow(u, (k / 2) as f64),
                    Form::Series => libm::cos(k as f64 * angle),
                };
                let sum: f64 =
                    terms.iter().rev().enumerate().map(|(k, term)| term * element(k)).sum();
                let found = value(terms, t);
                assert!((found - sum).abs() < 1e-11, "{length} at {angle}: {found}, {sum}");
                let [one, other] =
                    pairs::<f64, { usize::MAX }, 1>([terms, terms], [&[t], &[doubled(t)]]);
                assert_eq!((one, other), ([found], [found]));
            }
        }
    }
}
