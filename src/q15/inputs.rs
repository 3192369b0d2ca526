//! Lights and materials in fixed point.

use super::Q15;
use super::arithmetic::{BITS, Shift as _};
use crate::checked_slice::{part, part_mut};
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
        quantize_orders(from, to, exponents);
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
/// The compiler computes the presets with it, so it has neither iterators nor traits.
#[inline(never)]
const fn quantize(from: &[f32], to: &mut [Q15]) -> i32 {
    let (mut top, mut rest) = (LEAST_TOP, from);
    while let [number, others @ ..] = rest {
        let (size, of_number) = decoded(*number);
        let bits = i32::BITS - size.unsigned_abs().leading_zeros();
        let of_number = of_number + bits.cast_signed();
        if size != 0 && of_number > top {
            top = of_number;
        }
        rest = others;
    }
    let exponent = top - BITS.cast_signed();
    let (mut from, mut to) = (from, to);
    while let ([number, numbers @ ..], [place, places @ ..]) = (from, to) {
        let (size, of_number) = decoded(*number);
        // At least 9: the significand of the largest number has 24 bits, or the exponent is the
        // least one.
        let right = exponent - of_number;
        let rounded = if right > 31 { 0 } else { ((size >> (right - 1)) + 1) >> 1 };
        *place = Q15(match rounded {
            32_768 => 32_767,
            -32_768 => -32_767,
            _ => rounded as i16,
        });
        (from, to) = (numbers, places);
    }
    exponent
}

/// [`quantize`] of each order of a material.
const fn quantize_orders(from: &[f32], to: &mut [Q15], exponents: &mut [i8]) {
    let (mut from, mut to, mut exponents, mut o) = (from, to, exponents, 0);
    while let [exponent, others @ ..] = exponents {
        let count = (o / 2 + 1) * (o / 2 + 2) / 2;
        let (Some((of_order, numbers)), Some((places, rest))) =
            (from.split_at_checked(count), to.split_at_mut_checked(count))
        else {
            return;
        };
        // From -111 to 113.
        *exponent = quantize(of_order, places) as i8;
        (from, to, exponents, o) = (numbers, rest, others, o + 1);
    }
}

/// The exponent and the mantissas of a light, as the compiler computes them.
#[cfg(feature = "presets")]
pub(crate) const fn quantized_light<const N: usize>(from: &[f32]) -> (i32, [Q15; N]) {
    let mut mantissas = [Q15(0); N];
    let exponent = quantize(from, &mut mantissas);
    (exponent, mantissas)
}

#[cfg(feature = "presets")]
impl<const N: usize, const O: usize> MaterialBuffer<N, O> {
    /// The exponents and the mantissas of a material, as the compiler computes them.
    pub(crate) const fn quantized(from: &[f32]) -> Self {
        let mut material = Self { exponents: [0; O], mantissas: [Q15(0); N] };
        quantize_orders(from, &mut material.mantissas, &mut material.exponents);
        material
    }
}
