//! Scenes of nine terms or fewer, enough for a matte material under light of degree 2.

use crate::descent::Descent;
use crate::nine_terms::NineTerms;
use crate::scalar::Scalar;
use crate::scene::Scene;

impl<B> Scene<'_, B> {
    /// The scene as the nine-term formula, which shades it fastest. `None` if the scene has more
    /// terms, or if azimuth 0 is the only one.
    #[inline]
    #[must_use]
    pub fn nine_terms<S: Scalar>(&self) -> Option<NineTerms<S>>
    where
        B: AsRef<[S]>,
    {
        nine_terms(self.descent())
    }
}

/// Converts polynomials of azimuths 0, 1 and 2 in t = 2z - 1 into one polynomial of the normal.
#[inline]
pub(crate) fn nine_terms<S: Scalar>(mut polynomials: Descent<'_, S>) -> Option<NineTerms<S>> {
    // A WebAssembly module for a web page has no room for a second loop.
    if cfg!(target_arch = "wasm32") || polynomials.is_orthogonal() {
        return None;
    }
    let [square, linear, constant] = filled(polynomials.pole)?;
    let second = match polynomials.lengths {
        [_] => Some((&[] as &[S], &[] as &[S])),
        [_, _] => polynomials.next(),
        _ => None,
    };
    let ((plus, minus), (first_plus, first_minus)) = (second?, polynomials.next()?);
    let ([plus], [minus]) = (filled(plus)?, filled(minus)?);
    let ([of_xz, of_x], [of_yz, of_y]) = (filled(first_plus)?, filled(first_minus)?);
    let twice = |term: S| term + term;
    let squares = twice(twice(square));
    Some(NineTerms::new([
        constant - linear + square,
        of_x - of_xz,
        of_y - of_yz,
        twice(linear) - squares,
        plus,
        twice(minus),
        twice(of_xz),
        twice(of_yz),
        squares,
    ]))
}

/// The terms, highest first, after leading zeros; `None` if there are too many.
#[inline]
fn filled<S: Scalar, const N: usize>(terms: &[S]) -> Option<[S; N]> {
    let mut filled = [S::ZERO; N];
    let zeros = N.checked_sub(terms.len())?;
    for (to, &term) in filled.iter_mut().skip(zeros).zip(terms) {
        *to = term;
    }
    Some(filled)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::normal::Normal;
    use crate::parts::Recurrences;

    /// Compares scenes with their polynomials in t, azimuth by azimuth. The formula does not shade
    /// scenes with more terms.
    #[test]
    fn scenes_of_nine_terms_are_their_polynomials() {
        let mut numbers = [0.0f64; 9];
        for (k, number) in numbers.iter_mut().enumerate() {
            *number = ((7 * k % 11) as f64 - 5.0) / 3.0;
        }
        for lengths in [&[3u16, 2, 1][..], &[3, 2], &[1, 1], &[2, 1, 1], &[0, 2, 1], &[3, 0, 1]] {
            let scene = Scene::of(lengths, Recurrences::NONE, numbers);
            let formula = scene.nine_terms::<f64>().unwrap();
            for k in 0..=40 {
                let (z, tilt) = (f64::from(k) / 40.0, 2.4 * f64::from(k));
                let (sine, cosine) = libm::sincos(tilt);
                let rim = libm::sqrt(1.0 - z * z);
                let normal = Normal::new(rim * cosine, rim * sine, z).unwrap();
                let mut numbers = numbers.iter();
                let mut value = |length: u16| {
                    let terms = numbers.by_ref().take(length.into());
                    terms.fold(0.0, |sum, term| sum * (2.0 * z - 1.0) + term)
                };
                let mut expected = value(lengths.first().copied().unwrap_or(0));
                for (azimuth, &length) in (1..).zip(lengths.iter().skip(1)) {
                    let (sine, cosine) = libm::sincos(f64::from(azimuth) * tilt);
                    let around = value(length) * cosine + value(length) * sine;
                    expected += libm::pow(rim, azimuth.into()) * around;
                }
                let found = formula.shade(normal);
                assert!((found - expected).abs() < 1e-13, "{lengths:?}, {k}: {found}, {expected}");
                assert_eq!(scene.shade(normal), found);
            }
        }
        for lengths in [&[4u16, 2, 1][..], &[3, 3], &[3, 1, 2], &[1, 1, 1, 1], &[3], &[]] {
            let scene = Scene::of(lengths, Recurrences::NONE, [1.0f64; 11]);
            assert_eq!(scene.nine_terms::<f64>(), None, "{lengths:?}");
        }
    }
}
