//! The nine-term formula (Ramamoorthi and Hanrahan 2001): irradiance as a polynomial of degree 2 in
//! the normal, in nine multiply-adds.

use crate::error::{Argument, Error};
use crate::float;
use crate::index::light::{graphics_sign, position};
use crate::light::Light;
use crate::normal::{Normal, Normals};

// The clamped cosine over π has the weights 1, 2/3 and 1/4. They are multiplied by the norms of the
// harmonics, √(1/4π), √(3/4π), √(15/4π) and √(5/16π).
pub(crate) const CONSTANT: f32 = 0.282_094_8;
pub(crate) const LINEAR: f32 = 2.0 / 3.0 * 0.488_602_52;
pub(crate) const SQUARE: f32 = 0.25 * 1.092_548_5;
pub(crate) const UPRIGHT: f32 = 0.25 * 0.315_391_57;

/// Irradiance as a polynomial of degree 2 in the normal, for a Lambertian material under light of
/// degree 2, without a table.
///
/// ```
/// use eigenshade::lights::NineTerms;
/// use eigenshade::{Light, Normal};
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
