//! Profile polynomials: an even and an odd half, Σ_k (a_k + b_k t) u^k in t = 2z - 1 and
//! u = 2t² - 1, evaluated by Horner's rule in u.
//!
//! The terms are in the order ..., b_1, a_1, b_0, a_0, so with an odd number of them the first has no
//! odd partner. A term costs as much as in powers of t, but only half as many powers cancel.

use crate::checked_slice::split;
use crate::float;

/// The argument t = 2z - 1 of the profile polynomials.
#[inline]
pub(crate) fn argument(z: f32) -> f32 {
    z + z - 1.0
}

/// The argument u = 2t² - 1 = T_2(t).
#[inline(always)]
pub(crate) fn doubled(t: f32) -> f32 {
    float::add_product(-1.0, t + t, t)
}

/// (cosine + i sine)(x + i y).
#[inline]
pub(crate) fn turned(cosine: f32, sine: f32, x: f32, y: f32) -> (f32, f32) {
    (float::add_product(cosine * x, -sine, y), float::add_product(cosine * y, sine, x))
}

/// The value of a polynomial.
#[inline]
pub(crate) fn value(terms: &[f32], t: f32) -> f32 {
    let [value] = values(terms, [&[t], &[doubled(t)]]);
    value
}

/// The values of a polynomial at a block of arguments t and u.
#[inline(always)]
pub(crate) fn values<const N: usize>(terms: &[f32], [t, u]: [&[f32; N]; 2]) -> [f32; N] {
    // In a block, an even number of terms begins with zero: with its first two, x86-64 takes more
    // instructions.
    let (mut sums, rest) = match terms {
        [odd, even, rest @ ..] if N == 1 && rest.len().is_multiple_of(2) => {
            (t.map(|t| float::add_product(*even, *odd, t)), rest)
        }
        _ => {
            let (alone, rest) = split(terms, terms.len() % 2);
            ([alone.first().copied().unwrap_or(0.0); N], rest)
        }
    };
    for [odd, even] in rest.as_chunks().0 {
        float::horner([odd, even], &mut sums, [t, u]);
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::index::layout::MAX_TERMS;

    /// Compares with powers of t and of u = cos 2θ. The sums are below 100.
    #[test]
    fn values_are_the_sums_that_they_stand_for() {
        let all: [f32; MAX_TERMS] =
            core::array::from_fn(|k| (((7 * k) % 19) as f32 - 9.0) / (1 + k % 5) as f32);
        for length in [0, 1, 2, 3, 16, 17, MAX_TERMS] {
            let terms = all.get(..length).unwrap_or_default();
            for angle in [0.0, 0.3, 1.2, 1.6, 2.5, core::f64::consts::PI] {
                let (t, u) = (libm::cos(angle), libm::cos(2.0 * angle));
                let element = |k: usize| {
                    let even = libm::pow(u, (k / 2) as f64);
                    if k.is_multiple_of(2) { even } else { t * even }
                };
                let terms_of_rising_k = terms.iter().rev().enumerate();
                let sum: f64 =
                    terms_of_rising_k.map(|(k, &term)| f64::from(term) * element(k)).sum();
                let t = t as f32;
                let found = value(terms, t);
                assert!(
                    (f64::from(found) - sum).abs() < 2e-4,
                    "{length} at {angle}: {found}, {sum}"
                );
                let at = [&[t; 2], &[doubled(t); 2]];
                assert_eq!(values(terms, at), [found; 2]);
            }
        }
    }
}
