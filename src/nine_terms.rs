//! The nine-term formula (Ramamoorthi and Hanrahan 2001): irradiance as a polynomial of degree 2 in
//! the normal, in nine multiply-adds.

use crate::error::{Argument, Error};
use crate::float;
use crate::index::light::{graphics_sign, position};
use crate::light::Light;
use crate::normal::{Normal, Normals};
use crate::scene::{Descent, Scene};

// The clamped cosine over π has the weights 1, 2/3 and 1/4. They are multiplied by the norms of the
// harmonics, √(1/4π), √(3/4π), √(15/4π) and √(5/16π).
pub(crate) const CONSTANT: f32 = 0.282_094_8;
pub(crate) const LINEAR: f32 = 2.0 / 3.0 * 0.488_602_52;
pub(crate) const SQUARE: f32 = 0.25 * 1.092_548_5;
pub(crate) const UPRIGHT: f32 = 0.25 * 0.315_391_57;

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
pub struct NineTerms {
    coefficients: [f32; 9],
}

impl NineTerms {
    /// Multiply-adds per pixel.
    pub const MULTIPLY_ADDS: usize = 9;

    /// Creates the polynomial with these coefficients of 1, x, y, z, x² - y², xy, xz, yz and z².
    #[inline]
    #[must_use]
    pub const fn new(coefficients: [f32; 9]) -> Self {
        Self { coefficients }
    }

    /// The coefficients of 1, x, y, z, x² - y², xy, xz, yz and z².
    #[must_use]
    pub const fn coefficients(&self) -> &[f32; 9] {
        &self.coefficients
    }
}

impl NineTerms {
    /// The irradiance of a Lambertian material, f = `albedo` / π, under a light. Only the light's
    /// coefficients of degrees 0 to 2 are used.
    #[must_use]
    pub fn lambertian(light: &Light<'_>, albedo: f32) -> Self {
        let of = |l: usize, m: isize, weight: f32| {
            let light = light.coefficients().get(position(l, m)).copied().unwrap_or(0.0);
            albedo * weight * f32::from(graphics_sign(m)) * light
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
    pub fn shade(&self, normal: Normal) -> f32 {
        let Normal { x, y, z } = normal;
        let [constant, c1, c2, c3, c4, c5, c6, c7, c8] = self.coefficients;
        let of_x = float::add_product(float::add_product(c1, c4, x), c5, y);
        let of_y = float::add_product(c2, -c4, y);
        let of_z =
            float::add_product(float::add_product(float::add_product(c3, c6, x), c7, y), c8, z);
        float::add_product(
            float::add_product(float::add_product(constant, of_x, x), of_y, y),
            of_z,
            z,
        )
    }

    /// Writes the irradiance of each normal to `irradiance`, bit for bit the same as
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` has the same length as `normals`.
    pub fn shade_slice(&self, normals: Normals<'_>, irradiance: &mut [f32]) -> Result<(), Error> {
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
    pub fn nine_terms(&self) -> Option<NineTerms>
    where
        B: AsRef<[f32]>,
    {
        nine_terms(self.descent())
    }
}

/// Converts polynomials of azimuths 0, 1 and 2 in t = 2z - 1 into one polynomial of the normal.
#[inline]
pub(crate) fn nine_terms(mut polynomials: Descent<'_>) -> Option<NineTerms> {
    // A WebAssembly module for a web page has no room for a second loop.
    if cfg!(target_arch = "wasm32") || polynomials.is_orthogonal() {
        return None;
    }
    let [square, linear, constant] = filled(polynomials.pole)?;
    let second = match polynomials.lengths {
        [_] => Some((&[] as &[f32], &[] as &[f32])),
        [_, _] => polynomials.next(),
        _ => None,
    };
    let ((plus, minus), (first_plus, first_minus)) = (second?, polynomials.next()?);
    let ([plus], [minus]) = (filled(plus)?, filled(minus)?);
    let ([of_xz, of_x], [of_yz, of_y]) = (filled(first_plus)?, filled(first_minus)?);
    let twice = |term: f32| term + term;
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
        let numbers: [f32; 9] = core::array::from_fn(|k| ((7 * k % 11) as f32 - 5.0) / 3.0);
        for lengths in [&[3u16, 2, 1][..], &[3, 2], &[1, 1], &[2, 1, 1], &[0, 2, 1], &[3, 0, 1]] {
            let scene = Scene::of(lengths, Recurrences::NONE, numbers);
            let formula = scene.nine_terms().unwrap();
            for k in 0..=40 {
                let (z, tilt) = (k as f32 / 40.0, 2.4 * k as f32);
                let (sine, cosine) = libm::sincosf(tilt);
                let rim = libm::sqrtf(1.0 - z * z);
                let normal = Normal::new(rim * cosine, rim * sine, z).unwrap();
                let mut numbers = numbers.iter();
                let mut value = |length: u16| {
                    let terms = numbers.by_ref().take(length.into());
                    terms.fold(0.0, |sum, term| sum * (2.0 * z - 1.0) + term)
                };
                let mut expected = value(lengths.first().copied().unwrap_or(0));
                for (azimuth, &length) in (1..).zip(lengths.iter().skip(1)) {
                    let (sine, cosine) = libm::sincosf(azimuth as f32 * tilt);
                    let around = value(length) * cosine + value(length) * sine;
                    expected += libm::powf(rim, azimuth as f32) * around;
                }
                let found = formula.shade(normal);
                assert!((found - expected).abs() < 1e-5, "{lengths:?}, {k}: {found}, {expected}");
                assert_eq!(scene.shade(normal), found);
            }
        }
        for lengths in [&[4u16, 2, 1][..], &[3, 3], &[3, 1, 2], &[1, 1, 1, 1], &[3], &[]] {
            let scene = Scene::of(lengths, Recurrences::NONE, [1.0; 11]);
            assert_eq!(scene.nine_terms(), None, "{lengths:?}");
        }
    }
}
