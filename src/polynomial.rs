//! Profile polynomials in t = 2z - 1, highest term first: in the form that belongs to their length,
//! [`Form`](crate::index::layout::Form), or by the recurrence of their azimuth.

use crate::float;
use crate::index::layout::{EVEN_ODD_TERMS, MONOMIAL_TERMS, Recurrence};
use crate::invariant::split;

/// The argument t = 2z - 1 of the profile polynomials.
#[inline]
pub(crate) fn argument(z: f32) -> f32 {
    z + z - 1.0
}

/// (cosine + i sine)(x + i y).
#[inline]
pub(crate) fn turned(cosine: f32, sine: f32, x: f32, y: f32) -> (f32, f32) {
    (float::add_product(cosine * x, -sine, y), float::add_product(cosine * y, sine, x))
}

/// The value of a polynomial. `recurrence` is the recurrence of its azimuth, or empty.
#[inline]
pub(crate) fn value(terms: &[f32], t: f32, recurrence: &[Recurrence]) -> f32 {
    if cfg!(feature = "series") && !recurrence.is_empty() {
        let [[value], _] = orthogonal([terms, terms], &[t], recurrence);
        return value;
    }
    short(terms, t)
}

/// The value of a polynomial in the form of its length.
#[inline]
pub(crate) fn short(terms: &[f32], t: f32) -> f32 {
    if terms.len() <= MONOMIAL_TERMS {
        let Some((&first, rest)) = terms.split_first() else { return 0.0 };
        return rest.iter().fold(first, |sum, &term| float::add_product(term, sum, t));
    }
    let [value] = long(terms, &[t]);
    value
}

/// The values of a polynomial at a block of arguments t, in the form of its length. The argument u
/// = 2t² - 1 is read only if `LONGEST` is [`EVEN_ODD_TERMS`]. No polynomial has more than `LONGEST`
/// terms. Beyond [`EVEN_ODD_TERMS`], which is for small code, the loop over azimuths contains a
/// call, around which all registers are saved.
#[inline(always)]
pub(crate) fn values<const LONGEST: usize, const N: usize>(
    terms: &[f32],
    [t, u]: [&[f32; N]; 2],
) -> [f32; N] {
    if LONGEST > EVEN_ODD_TERMS && terms.len() > MONOMIAL_TERMS {
        return long(terms, t);
    }
    if LONGEST > MONOMIAL_TERMS && terms.len() > MONOMIAL_TERMS {
        return halves(terms, [t, u]);
    }
    let Some((&first, rest)) = terms.split_first() else {
        return [0.0; N];
    };
    let mut sums = [first; N];
    for &term in rest {
        float::horner(term, &mut sums, t);
    }
    sums
}

/// [`values`] of two polynomials of the same length.
#[inline(always)]
pub(crate) fn pairs<const LONGEST: usize, const N: usize>(
    [one, other]: [&[f32]; 2],
    [t, u]: [&[f32; N]; 2],
) -> [[f32; N]; 2] {
    let (Some((&first, rest)), Some((&second, others))) = (one.split_first(), other.split_first())
    else {
        return [[0.0; N]; 2];
    };
    if LONGEST > EVEN_ODD_TERMS && one.len() > MONOMIAL_TERMS {
        return [long(one, t), long(other, t)];
    }
    if LONGEST > MONOMIAL_TERMS && one.len() > MONOMIAL_TERMS {
        return [halves(one, [t, u]), halves(other, [t, u])];
    }
    let (mut sums, mut more) = ([first; N], [second; N]);
    for (&term, &another) in rest.iter().zip(others) {
        float::horner_of_two([term, another], [&mut sums, &mut more], t);
    }
    [sums, more]
}

/// The values of a polynomial of more than [`MONOMIAL_TERMS`] terms. Not inlined.
#[inline(never)]
pub(crate) fn long<const N: usize>(terms: &[f32], t: &[f32; N]) -> [f32; N] {
    halves(terms, [t, &t.map(doubled)])
}

/// The argument u = 2t² - 1 = T_2(t).
#[inline(always)]
pub(crate) fn doubled(t: f32) -> f32 {
    float::add_product(-1.0, t + t, t)
}

/// The values of a polynomial with an even and an odd half, by Horner's rule in u.
#[inline(always)]
fn halves<const N: usize>(terms: &[f32], [t, u]: [&[f32; N]; 2]) -> [f32; N] {
    // With an odd number of terms, the highest is an even power without an odd partner.
    let (alone, rest) = split(terms, terms.len() % 2);
    let mut sums = [alone.first().copied().unwrap_or(0.0); N];
    for [odd, even] in rest.as_chunks().0 {
        for (sum, (&t, &u)) in sums.iter_mut().zip(t.iter().zip(u)) {
            *sum = float::add_product(float::add_product(*even, *odd, t), *sum, u);
        }
    }
    sums
}

/// The values of two polynomials of the same length at a block of arguments, by the recurrence of
/// their azimuth. Both share the polynomials e_k of the recurrence.
#[inline(always)]
pub(crate) fn orthogonal<const N: usize>(
    [one, other]: [&[f32]; 2],
    t: &[f32; N],
    recurrence: &[Recurrence],
) -> [[f32; N]; 2] {
    let [mut sums, mut more] = [[0.0; N]; 2];
    let (mut element, mut before) = ([1.0; N], [0.0; N]);
    for ((&term, &another), &[at, below]) in one.iter().zip(other).rev().zip(recurrence) {
        let both = sums.iter_mut().zip(&mut more);
        let elements = element.iter_mut().zip(&mut before);
        for ((sum, more), ((element, before), &t)) in both.zip(elements.zip(t)) {
            *sum = float::add_product(*sum, term, *element);
            *more = float::add_product(*more, another, *element);
            let next = float::add_product((t + t - at) * *element, -below, *before);
            (*before, *element) = (*element, next);
        }
    }
    [sums, more]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::layout::Form;

    const TERMS: usize = 40;

    fn terms() -> [f32; TERMS] {
        core::array::from_fn(|k| (((7 * k) % 19) as f32 - 9.0) / (1 + k % 5) as f32)
    }

    /// Compares with powers of t and of u = cos 2θ. The sums are below 100.
    #[test]
    fn each_form_is_the_sum_that_it_stands_for() {
        let all = terms();
        for length in [0, 1, MONOMIAL_TERMS, MONOMIAL_TERMS + 1, MONOMIAL_TERMS + 2, EVEN_ODD_TERMS]
        {
            let terms = all.get(..length).unwrap_or_default();
            for angle in [0.0, 0.3, 1.2, 1.6, 2.5, core::f64::consts::PI] {
                let (t, u) = (libm::cos(angle), libm::cos(2.0 * angle));
                let element = |k: usize| match Form::of(length) {
                    Form::Monomial => libm::pow(t, k as f64),
                    Form::EvenOdd if k.is_multiple_of(2) => libm::pow(u, (k / 2) as f64),
                    Form::EvenOdd => t * libm::pow(u, (k / 2) as f64),
                };
                let sum: f64 = terms
                    .iter()
                    .rev()
                    .enumerate()
                    .map(|(k, &term)| f64::from(term) * element(k))
                    .sum();
                let t = t as f32;
                let found = value(terms, t, &[]);
                assert!(
                    (f64::from(found) - sum).abs() < 5e-4,
                    "{length} at {angle}: {found}, {sum}"
                );
                let [one, other] =
                    pairs::<{ usize::MAX }, 1>([terms, terms], [&[t], &[doubled(t)]]);
                assert_eq!((one, other), ([found], [found]));
            }
        }
    }

    /// With a_k = 0 and b_k = 1 the recurrence gives the Chebyshev polynomials of the second kind:
    /// for t = cos θ, U_k = sin (k+1)θ / sin θ.
    #[test]
    fn recurrences_give_polynomials_of_the_second_kind() {
        let (all, recurrence) = (terms(), [[0.0, 1.0]; TERMS]);
        for length in [1, 2, 7, TERMS] {
            let terms = all.get(..length).unwrap_or_default();
            for angle in [0.3, 1.2, 1.6, 2.5] {
                let element = |k: usize| libm::sin((k + 1) as f64 * angle) / libm::sin(angle);
                let sum: f64 = terms
                    .iter()
                    .rev()
                    .enumerate()
                    .map(|(k, &term)| f64::from(term) * element(k))
                    .sum();
                let found = f64::from(value(terms, libm::cos(angle) as f32, &recurrence));
                assert!((found - sum).abs() < 5e-4, "{length} at {angle}: {found}, {sum}");
            }
        }
    }
}
