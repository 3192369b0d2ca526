//! Material as Koenderink-van Doorn coefficients b_op^q of (7).

use crate::buffer::{Buffer, copied};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::material;

/// One channel of an isotropic BRDF: its coefficients in 1/sr, in the order of
/// [`eigenshade_table::material`].
///
/// The azimuth in (8) is φ_i - φ_r, so zero is backscatter.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Material<'a> {
    order: usize,
    coefficients: &'a [f32],
}

impl<'a> Material<'a> {
    /// Creates a material from its coefficients, which must be finite. The number of coefficients
    /// determines the order: 1, 2, 5, 8, 14, 20, 30 and 40 for orders 0 to 7.
    ///
    /// Constants can be created by [`from_finite`](Self::from_finite).
    ///
    /// ```
    /// use eigenshade::{Argument, Error, Material};
    ///
    /// assert_eq!(Material::new(&[2.0])?.order(), 0); // a white matte, f = 1/π
    /// assert_eq!(Material::new(&[0.1; 40])?.order(), 7);
    /// let refused = Error::Count { argument: Argument::Material, found: 3 };
    /// assert_eq!(Material::new(&[2.0, 0.1, 0.1]), Err(refused));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are [`eigenshade_table::material::count`]
    /// coefficients for some order; [`Error::NotFinite`] with the index of the first coefficient
    /// that is infinite or NaN.
    pub fn new(coefficients: &'a [f32]) -> Result<Self, Error> {
        let material = Self::from_finite(coefficients)?;
        Error::check_finite(Argument::Material, coefficients)?;
        Ok(material)
    }

    /// [`new`](Self::new) in a constant, or without a pass over the coefficients: the caller
    /// promises finite coefficients. An infinite or NaN coefficient spoils more of an image than
    /// its own mode.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] as for `new`.
    #[inline]
    pub const fn from_finite(coefficients: &'a [f32]) -> Result<Self, Error> {
        match order(coefficients.len()) {
            Ok(order) => Ok(Self { order, coefficients }),
            Err(error) => Err(error),
        }
    }

    /// This material without the orders above `order`. A material of that order or less stays as it
    /// is.
    #[must_use]
    pub fn truncated(self, order: usize) -> Self {
        match self.coefficients.get(..material::count(order)) {
            Some(coefficients) if order < self.order => Self { order, coefficients },
            _ => self,
        }
    }

    /// Largest order o.
    #[must_use]
    pub const fn order(&self) -> usize {
        self.order
    }

    /// All coefficients.
    #[must_use]
    pub const fn coefficients(&self) -> &'a [f32] {
        self.coefficients
    }
}

impl Material<'_> {
    /// This material in a color: its coefficients times each channel. `N` is at least the number of
    /// coefficients.
    ///
    /// ```
    /// use eigenshade::Material;
    ///
    /// let red = Material::new(&[2.0, -0.5])?.tint::<2>([0.9, 0.2, 0.1])?;
    /// assert_eq!(red.materials()?.g.coefficients(), [0.4, -0.1]);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Capacity`] if `N` is too small; [`Error::NotFinite`] with the index of the first
    /// channel of the color that is infinite or NaN.
    pub fn tint<const N: usize>(&self, color: [f32; 3]) -> Result<Rgb<Buffer<f32, N>>, Error> {
        Rgb::gray(*self).tint(color)
    }
}

impl Rgb<Material<'_>> {
    /// [`Material::tint`] in each channel, such as of a preset: a gray material in a color, or one
    /// in color with another balance. The same errors.
    pub fn tint<const N: usize>(&self, color: [f32; 3]) -> Result<Rgb<Buffer<f32, N>>, Error> {
        Error::check_finite(Argument::Color, &color)?;
        self.zip(Rgb::from(color)).try_map(|(material, factor)| {
            copied(Argument::Material, material.coefficients().iter().map(|&from| factor * from))
        })
    }
}

impl<'a> From<Material<'a>> for Rgb<Material<'a>> {
    #[inline]
    fn from(gray: Material<'a>) -> Self {
        Self::gray(gray)
    }
}

impl<const N: usize> Rgb<Buffer<f32, N>> {
    /// The materials in these buffers; errors as [`Material::from_finite`].
    pub fn materials(&self) -> Result<Rgb<Material<'_>>, Error> {
        self.each_ref().try_map(|channel| Material::from_finite(channel))
    }
}

/// The order of a material with this number of coefficients: as [`degree`](crate::light::degree).
#[inline]
pub(crate) const fn order(found: usize) -> Result<usize, Error> {
    let (mut order, mut count) = (0, 1);
    while count < found {
        order += 1;
        // The coefficients of an o: one for each p and each q up to it.
        count += (order / 2 + 1) * (order / 2 + 2) / 2;
    }
    if count == found {
        Ok(order)
    } else {
        Err(Error::Count { argument: Argument::Material, found })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_count_determines_degree_and_order() {
        for size in 0..40 {
            assert_eq!(crate::light::degree(crate::index::light::count(size)), Ok(size));
            assert_eq!(order(material::count(size)), Ok(size));
            let between = material::count(size + 1) - 1;
            assert_eq!(order(between).is_ok(), size == 0);
        }
        assert!(order(0).is_err() && crate::light::degree(0).is_err());
    }
}
