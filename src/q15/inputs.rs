//! Lights and materials, and normals, in fixed point.

use super::Q15;
use super::arithmetic::{BITS, Shift as _};
use crate::checked_slice::{part, part_mut, split_mut, split_row};
use crate::color::Rgb;
use crate::error::{Argument, Error};
use crate::index::material::count;
use crate::light::degree;
use crate::material::order;

/// One channel of distant light: mantissas in the order of [`eigenshade_table::light`],
/// all to be multiplied by 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light<'a> {
    pub(crate) degree: usize,
    pub(crate) exponent: i32,
    pub(crate) mantissas: &'a [Q15],
}

/// One channel of an isotropic BRDF: mantissas in the order of
/// [`eigenshade_table::material`]. Each order o has its own exponent.
///
/// The exponents determine how much precision small coefficients lose. The largest mantissa of each
/// o should use all bits, and an o whose mantissas are all zero should have the least exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Material<'a> {
    pub(crate) order: usize,
    pub(crate) exponents: &'a [i8],
    pub(crate) mantissas: &'a [Q15],
}

impl<'a> Light<'a> {
    /// The light with these mantissas; |exponent| <= 128. The number of mantissas determines the
    /// degree.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² mantissas for some degree,
    /// [`Error::Exponent`] if |exponent| is above 128.
    pub const fn new(exponent: i32, mantissas: &'a [Q15]) -> Result<Self, Error> {
        if exponent.unsigned_abs() > 128 {
            return Err(Error::Exponent);
        }
        match degree(mantissas.len()) {
            Ok(degree) => Ok(Self { degree, exponent, mantissas }),
            Err(error) => Err(error),
        }
    }

    /// The common exponent of the mantissas.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }

    /// All mantissas.
    #[must_use]
    pub const fn mantissas(&self) -> &'a [Q15] {
        self.mantissas
    }
}

impl<'a> Material<'a> {
    /// The material with these mantissas, and an exponent for each o. The number of mantissas
    /// determines the order.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are [`eigenshade_table::material::count`]
    /// mantissas for some order, [`Error::Length`] unless there are order + 1 exponents.
    pub const fn new(exponents: &'a [i8], mantissas: &'a [Q15]) -> Result<Self, Error> {
        let order = match order(mantissas.len()) {
            Ok(order) => order,
            Err(error) => return Err(error),
        };
        match Error::check(Argument::Material, order + 1, exponents.len()) {
            Ok(()) => Ok(Self { order, exponents, mantissas }),
            Err(error) => Err(error),
        }
    }

    /// The exponent of each order o.
    #[must_use]
    pub const fn exponents(&self) -> &'a [i8] {
        self.exponents
    }

    /// All mantissas.
    #[must_use]
    pub const fn mantissas(&self) -> &'a [Q15] {
        self.mantissas
    }
}

/// A material of fixed order: `N` mantissas and `O` exponents, one for each o.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MaterialBuffer<const N: usize, const O: usize> {
    pub(crate) exponents: [i8; O],
    pub(crate) mantissas: [Q15; N],
}

impl<const N: usize, const O: usize> MaterialBuffer<N, O> {
    /// The material.
    ///
    /// # Errors
    ///
    /// As [`Material::new`].
    pub const fn material(&self) -> Result<Material<'_>, Error> {
        Material::new(&self.exponents, &self.mantissas)
    }
}

impl<const N: usize, const O: usize> Rgb<MaterialBuffer<N, O>> {
    /// The materials in these buffers; errors as [`Material::new`].
    pub fn materials(&self) -> Result<Rgb<Material<'_>>, Error> {
        self.each_ref().try_map(MaterialBuffer::material)
    }
}

impl<'a> From<Light<'a>> for Rgb<Light<'a>> {
    #[inline]
    fn from(gray: Light<'a>) -> Self {
        Self::gray(gray)
    }
}

impl<'a> From<Material<'a>> for Rgb<Material<'a>> {
    #[inline]
    fn from(gray: Material<'a>) -> Self {
        Self::gray(gray)
    }
}

impl<'a> Light<'a> {
    /// Writes the mantissas of a light into `to`, in integer arithmetic throughout.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² numbers for some degree, [`Error::Length`]
    /// unless `to` has the same length, [`Error::NotFinite`] for the first number that is infinite
    /// or NaN, which no integer can represent.
    pub fn quantize(from: &[f32], to: &'a mut [Q15]) -> Result<Self, Error> {
        let degree = degree(from.len())?;
        Error::check(Argument::Light, from.len(), to.len())?;
        check_finite(Argument::Light, from)?;
        let exponent = quantize(from, to);
        Ok(Self { degree, exponent, mantissas: to })
    }
}

impl<'a> Material<'a> {
    /// Writes the mantissas of a material into `to` and its exponents into `exponents`: see
    /// [`Light::quantize`].
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are [`eigenshade_table::material::count`]
    /// numbers for some order, [`Error::Length`] unless `to` has the same length and `exponents`
    /// has order + 1; [`Error::NotFinite`] as in [`Light::quantize`].
    pub fn quantize(
        from: &[f32],
        to: &'a mut [Q15],
        exponents: &'a mut [i8],
    ) -> Result<Self, Error> {
        let order = order(from.len())?;
        Error::check(Argument::Material, from.len(), to.len())?;
        Error::check(Argument::Material, order + 1, exponents.len())?;
        check_finite(Argument::Material, from)?;
        let (mut from, mut rest) = (from, &mut *to);
        for (o, exponent) in exponents.iter_mut().enumerate() {
            let count = (o / 2 + 1) * (o / 2 + 2) / 2;
            let (of_order, after) = split_row(from, count);
            let (places, places_after) = split_mut(rest, count);
            *exponent = quantize(of_order, places).clamp(-127, 127) as i8;
            (from, rest) = (after, places_after);
        }
        Ok(Self { order, exponents, mantissas: to })
    }

    /// This material in a color: its coefficients times each channel, in integers. A channel is a
    /// fraction of 2^15, of either sign. There are `N` coefficients and `O` exponents. A
    /// coefficient is off by at most half a unit of the result.
    ///
    /// ```
    /// use eigenshade::q15::Material;
    /// use eigenshade::Q15;
    ///
    /// let gray = Material::new(&[-13, -14], &[Q15(16_384), Q15(-20_000)])?;
    /// let red = gray.tint::<2, 2>([30_000, 8_192, 0].map(Q15))?;
    /// assert_eq!(red.materials()?.g.mantissas(), [16_384, -20_000].map(Q15));
    /// assert_eq!(red.materials()?.g.exponents(), [-15, -16]);
    /// # Ok::<(), eigenshade::Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are `N` mantissas and `O` exponents, [`Error::Exponent`] if a
    /// product is 2^127.
    pub fn tint<const N: usize, const O: usize>(
        &self,
        color: [Q15; 3],
    ) -> Result<Rgb<MaterialBuffer<N, O>>, Error> {
        Rgb::gray(*self).tint(color)
    }

    /// This material times a factor.
    fn times<const N: usize, const O: usize>(
        self,
        factor: Q15,
    ) -> Result<MaterialBuffer<N, O>, Error> {
        Error::check(Argument::Material, N, self.mantissas.len())?;
        Error::check(Argument::Material, O, self.exponents.len())?;
        let mut tinted = MaterialBuffer { exponents: [0; O], mantissas: [Q15(0); N] };
        let exponents = tinted.exponents.iter_mut().zip(self.exponents);
        let mut start = 0;
        for (o, (exponent, &of_gray)) in exponents.enumerate() {
            let places = start..count(o);
            start = places.end;
            let top = i32::from(of_gray) - BITS.cast_signed();
            let of_order = part(self.mantissas, places.clone()).iter();
            let products = of_order.map(|mantissa| (mantissa.get() * factor.get(), top));
            let to = part_mut(&mut tinted.mantissas, places);
            let found = mantissas(products, to).max(-127);
            *exponent = i8::try_from(found).map_err(|_| Error::Exponent)?;
        }
        Ok(tinted)
    }
}

impl Rgb<Material<'_>> {
    /// [`Material::tint`] in each channel; the same errors.
    pub fn tint<const N: usize, const O: usize>(
        &self,
        color: [Q15; 3],
    ) -> Result<Rgb<MaterialBuffer<N, O>>, Error> {
        self.zip(Rgb::from(color)).try_map(|(material, factor)| material.times(factor))
    }
}

/// [`Error::check_finite`] without a float unit: tests the bits of the exponent.
fn check_finite(argument: Argument, numbers: &[f32]) -> Result<(), Error> {
    match numbers.iter().position(|number| (number.to_bits() >> 23) & 0xff == 0xff) {
        None => Ok(()),
        Some(index) => Err(Error::NotFinite { argument, index }),
    }
}

/// The signed 24-bit significand of a finite number, and its exponent.
pub(crate) const fn decoded(number: f32) -> (i32, i32) {
    let bits = number.to_bits();
    let (biased, fraction) = ((bits >> 23) & 0xff, bits & 0x7f_ffff);
    let (size, exponent) = match biased {
        0 => (fraction, -149),
        _ => (fraction | 0x80_0000, biased.cast_signed() - 150),
    };
    let size = size.cast_signed();
    (if bits >> 31 == 1 { -size } else { size }, exponent)
}

/// The least exponent of numbers as fractions.
pub(crate) const LEAST_TOP: i32 = -96;

/// Writes the mantissas of integers times powers of two, and returns their exponent.
pub(crate) fn mantissas(from: impl Iterator<Item = (i32, i32)> + Clone, to: &mut [Q15]) -> i32 {
    let tops = from.clone().filter(|(size, _)| *size != 0);
    let top = tops.map(|(size, exponent)| size.bits().cast_signed() + exponent).max();
    // If all numbers are zero, use the least exponent, because an exponent bounds how large its
    // numbers can be.
    let exponent = top.unwrap_or(LEAST_TOP).max(LEAST_TOP) - BITS.cast_signed();
    for (to, (size, of_number)) in to.iter_mut().zip(from) {
        *to = Q15::saturate(size.shifted(of_number - exponent));
    }
    exponent
}

/// [`mantissas`] of floats. Not inlined: lights and materials share it, which keeps modules small.
#[inline(never)]
fn quantize(from: &[f32], to: &mut [Q15]) -> i32 {
    mantissas(from.iter().map(|&number| decoded(number)), to)
}

/// One visible unit normal: x to the right, y up, z >= 0 toward the camera. The components are
/// fractions of 2^15.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Normal {
    pub(crate) x: Q15,
    pub(crate) y: Q15,
    pub(crate) z: Q15,
}

impl Normal {
    /// The normal with these components, as they are. The length must be 1 to within one part in
    /// 2,000, because sums of integers could overflow. [`new`](Self::new) scales a vector of any
    /// length.
    ///
    /// # Errors
    ///
    /// [`Error::NotUnit`] if the length is not 1, [`Error::Hidden`] if z < 0.
    #[inline]
    pub const fn from_unit(x: Q15, y: Q15, z: Q15) -> Result<Self, Error> {
        const ONE: u32 = 1 << (2 * BITS);
        let (a, b, c) = (x.0.unsigned_abs(), y.0.unsigned_abs(), z.0.unsigned_abs());
        let (a, b, c) = (a as u32, b as u32, c as u32);
        let square = a * a + b * b + c * c;
        if square < ONE - ONE / 1_000 || square > ONE + ONE / 1_000 {
            Err(Error::NotUnit)
        } else if z.0 < 0 {
            Err(Error::Hidden)
        } else {
            Ok(Self { x, y, z })
        }
    }

    /// The normal in the direction (x, y, z), integers of any scale. The vector is scaled to length
    /// 1, with an error of at most one unit in each component.
    ///
    /// A vector that points away from the camera by no more than 1/8 is moved to the rim. For an
    /// 8-bit normal map, pass 2c - 255 for each channel c.
    ///
    /// Cost: a root and three divisions in 64 bits, suitable for reading maps but not for each
    /// pixel.
    ///
    /// ```
    /// use eigenshade::q15::Normal;
    /// use eigenshade::{Error, Q15};
    ///
    /// let [x, y, z] = [218, 127, 218].map(|c| 2 * c - 255);
    /// assert_eq!(Normal::new(x, y, z)?.components(), [23_170, -128, 23_170].map(Q15));
    /// assert_eq!(Normal::new(4, 3, 0)?, Normal::new(400, 300, -50)?);
    /// assert_eq!(Normal::new(4, 3, -1), Err(Error::Hidden));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Normal`] if all three components are 0, [`Error::Hidden`] if z < -1/8 after
    /// scaling.
    pub fn new(x: i32, y: i32, z: i32) -> Result<Self, Error> {
        let sizes = [x, y, z].map(|c| u64::from(c.max(-i32::MAX).unsigned_abs()));
        let [a, b, c] = sizes;
        // The largest component gets 31 bits, so the squares sum to less than 2^64.
        let shift = (a | b | c).leading_zeros() - 33;
        let [xx, yy, zz] = sizes.map(|size| (size << shift) * (size << shift));
        let length = (xx + yy + zz).isqrt();
        let is_behind = z < 0;
        if is_behind && c << (shift + 3) > length {
            return Err(Error::Hidden);
        }
        let (c, length) = if is_behind { (0, (xx + yy).isqrt()) } else { (c, length) };
        let scaled = |component: i32, size: u64| {
            let rounded = ((size << (shift + BITS)) + length / 2).checked_div(length)?;
            let size = i32::try_from(rounded).unwrap_or(i32::MAX);
            Some(Q15::saturate(if component < 0 { -size } else { size }))
        };
        match (scaled(x, a), scaled(y, b), scaled(z, c)) {
            (Some(x), Some(y), Some(z)) => Ok(Self { x, y, z }),
            _ => Err(Error::Normal),
        }
    }

    /// The components x, y and z.
    #[must_use]
    pub const fn components(self) -> [Q15; 3] {
        [self.x, self.y, self.z]
    }
}
