//! The nine-term formula (Ramamoorthi and Hanrahan 2001): irradiance as a polynomial of degree 2 in
//! the normal, in nine multiply-adds.

use crate::error::{Argument, Error};
use crate::index::light::{graphics_sign, position};
use crate::light::Light;
use crate::normal::{Normal, Normals};
use crate::scalar::Scalar;
use crate::scene::{Descent, Scene};

// The clamped cosine over π has the weights 1, 2/3 and 1/4. They are multiplied by the norms of the
// harmonics, √(1/4π), √(3/4π), √(15/4π) and √(5/16π).
pub(crate) const CONSTANT: f64 = 0.282_094_791_773_878_14;
pub(crate) const LINEAR: f64 = 2.0 / 3.0 * 0.488_602_511_902_919_9;
pub(crate) const SQUARE: f64 = 0.25 * 1.092_548_430_592_079;
pub(crate) const UPRIGHT: f64 = 0.25 * 0.315_391_565_252_520_05;

/// Irradiance as a polynomial of degree 2 in the normal, for a Lambertian material under light of
/// degree 2. It needs no table.
///
/// A [`Scene`](crate::Scene) of these nine terms or fewer is shaded with it.
///
/// ```
/// use eigenshade::{Light, NineTerms, Normal};
///
/// let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?; // all around, more from the camera
/// let matte = NineTerms::lambertian(&light, 0.8);
/// assert!(matte.shade(Normal::new(0.0, 0.0, 1.0)?) > matte.shade(Normal::new(1.0, 0.0, 0.0)?));
/// # Ok::<(), eigenshade::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NineTerms<S> {
    coefficients: [S; 9],
}

impl<S> NineTerms<S> {
    /// Multiply-adds per pixel.
    pub const MULTIPLY_ADDS: usize = 9;

    /// Creates the polynomial with these coefficients of 1, x, y, z, x² - y², xy, xz, yz and z².
    #[inline]
    #[must_use]
    pub const fn new(coefficients: [S; 9]) -> Self {
        Self { coefficients }
    }

    /// The coefficients of 1, x, y, z, x² - y², xy, xz, yz and z².
    #[must_use]
    pub const fn coefficients(&self) -> &[S; 9] {
        &self.coefficients
    }
}

impl<S: Scalar> NineTerms<S> {
    /// The irradiance of a Lambertian material, f = `albedo` / π, under a light. Only the light's
    /// coefficients of degrees 0 to 2 are used.
    #[must_use]
    pub fn lambertian(light: &Light<'_, S>, albedo: S) -> Self {
        let of = |l: usize, m: isize, weight: f64| {
            let light = light.coefficients().get(position(l, m)).copied().unwrap_or(S::ZERO);
            albedo * S::from_f64(weight * f64::from(graphics_sign(m))) * light
        };
        let upright = of(2, 0, UPRIGHT);
        Self::new([
            of(0, 0, CONSTANT) - upright,
            of(1, 1, LINEAR),
            of(1, -1, LINEAR),
            of(1, 0, LINEAR),
            of(2, 2, 0.5 * SQUARE),
            of(2, -2, SQUARE),
            of(2, 1, SQUARE),
            of(2, -1, SQUARE),
            upright + upright + upright,
        ])
    }

    /// The irradiance of one normal.
    #[inline(always)]
    #[must_use]
    pub fn shade(&self, normal: Normal<S>) -> S {
        let Normal { x, y, z } = normal;
        let [constant, c1, c2, c3, c4, c5, c6, c7, c8] = self.coefficients;
        let of_x = c1.add_product(c4, x).add_product(c5, y);
        let of_y = c2.add_product(-c4, y);
        let of_z = c3.add_product(c6, x).add_product(c7, y).add_product(c8, z);
        constant.add_product(of_x, x).add_product(of_y, y).add_product(of_z, z)
    }

    /// Writes the irradiance of each normal to `irradiance`, bit for bit the same as
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` has the same length as `normals`.
    pub fn shade_slice(&self, normals: Normals<'_, S>, irradiance: &mut [S]) -> Result<(), Error> {
        Error::check(Argument::Normals, normals.len(), irradiance.len())?;
        let axes = normals.x.iter().zip(normals.y).zip(normals.z);
        for (out, ((&x, &y), &z)) in irradiance.iter_mut().zip(axes) {
            *out = self.shade(Normal { x, y, z });
        }
        Ok(())
    }
}

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
pub(crate) fn filled<T: Copy, U: Copy + Default + From<T>, const N: usize>(
    terms: &[T],
) -> Option<[U; N]> {
    let mut filled = [U::default(); N];
    let zeros = N.checked_sub(terms.len())?;
    for (to, &term) in filled.iter_mut().skip(zeros).zip(terms) {
        *to = term.into();
    }
    Some(filled)
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test may panic")]
mod tests {
    use super::*;
    use crate::normal::Normal;
    use crate::recurrences::Recurrences;

    /// Compares scenes with their polynomials in t, azimuth by azimuth. The formula does not shade
    /// scenes with more terms.
    #[test]
    fn scenes_of_nine_terms_are_their_polynomials() {
        let numbers: [f64; 9] = core::array::from_fn(|k| ((7 * k % 11) as f64 - 5.0) / 3.0);
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
