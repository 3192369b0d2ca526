//! Light and material in fixed point.

use crate::error::{Argument, Error};
use crate::format::{FixedPoint, Wide as _};
use crate::light::degree;
use crate::material::order;

/// One channel of distant light: mantissas in the order of [`index::light`](crate::index::light),
/// all to be multiplied by 2^exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Light<'a, Q> {
    pub(crate) degree: usize,
    pub(crate) exponent: i32,
    pub(crate) mantissas: &'a [Q],
}

/// One channel of an isotropic BRDF: mantissas in the order of
/// [`index::material`](crate::index::material). Each order o has its own exponent.
///
/// The exponents determine how much precision small coefficients lose. The largest mantissa of each
/// o should use all bits, and an o whose mantissas are all zero should have the least exponent.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Material<'a, Q> {
    pub(crate) order: usize,
    pub(crate) exponents: &'a [i8],
    pub(crate) mantissas: &'a [Q],
}

impl<'a, Q> Light<'a, Q> {
    /// The light with these mantissas; |exponent| <= 128. The number of mantissas determines the
    /// degree.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² mantissas for some degree,
    /// [`Error::Exponent`] if |exponent| is above 128.
    pub const fn new(exponent: i32, mantissas: &'a [Q]) -> Result<Self, Error> {
        if exponent.unsigned_abs() > 128 {
            return Err(Error::Exponent);
        }
        match degree(mantissas.len()) {
            Ok(degree) => Ok(Self { degree, exponent, mantissas }),
            Err(error) => Err(error),
        }
    }
}

impl<Q> Light<'_, Q> {
    /// The common exponent of the mantissas.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}

impl<'a, Q> Material<'a, Q> {
    /// The material with these mantissas, and an exponent for each o. The number of mantissas
    /// determines the order.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are [`index::material::count`](crate::index::material::count)
    /// mantissas for some order, [`Error::Length`] unless there are order + 1 exponents.
    pub const fn new(exponents: &'a [i8], mantissas: &'a [Q]) -> Result<Self, Error> {
        let order = match order(mantissas.len()) {
            Ok(order) => order,
            Err(error) => return Err(error),
        };
        match Error::check(Argument::Material, order + 1, exponents.len()) {
            Ok(()) => Ok(Self { order, exponents, mantissas }),
            Err(error) => Err(error),
        }
    }
}

impl<'a, Q: FixedPoint> Light<'a, Q> {
    /// Writes the mantissas of a light into `to`, in integer arithmetic throughout.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are (degree + 1)² numbers for some degree, [`Error::Length`]
    /// unless `to` has the same length, [`Error::NotFinite`] for the first number that is infinite
    /// or NaN, which no integer can represent.
    pub fn quantize(from: &[f32], to: &'a mut [Q]) -> Result<Self, Error> {
        degree(from.len())?;
        Error::check(Argument::Light, from.len(), to.len())?;
        check_finite(Argument::Light, from)?;
        let exponent = quantize(from, to);
        Self::new(exponent, to)
    }
}

impl<'a, Q: FixedPoint> Material<'a, Q> {
    /// Writes the mantissas of a material into `to` and its exponents into `exponents`: see
    /// [`Light::quantize`].
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are [`index::material::count`](crate::index::material::count)
    /// numbers for some order, [`Error::Length`] unless `to` has the same length and `exponents`
    /// has order + 1; [`Error::NotFinite`] as in [`Light::quantize`].
    pub fn quantize(from: &[f32], to: &'a mut [Q], exponents: &'a mut [i8]) -> Result<Self, Error> {
        let order = order(from.len())?;
        Error::check(Argument::Material, from.len(), to.len())?;
        Error::check(Argument::Material, order + 1, exponents.len())?;
        check_finite(Argument::Material, from)?;
        let (mut from, mut rest) = (from, &mut *to);
        for (o, exponent) in exponents.iter_mut().enumerate() {
            let count = (o / 2 + 1) * (o / 2 + 2) / 2;
            let (of_order, after) = from.split_at_checked(count).unwrap_or((from, &[]));
            let (places, places_after) = rest.split_at_mut_checked(count).unwrap_or_default();
            *exponent = quantize(of_order, places).clamp(-127, 127) as i8;
            (from, rest) = (after, places_after);
        }
        Self::new(exponents, to)
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
fn decoded(number: f32) -> (i32, i32) {
    let bits = number.to_bits();
    let (biased, fraction) = ((bits >> 23) & 0xff, bits & 0x7f_ffff);
    let (size, exponent) = match biased {
        0 => (fraction, -149),
        _ => (fraction | 0x80_0000, biased.cast_signed() - 150),
    };
    let size = size.cast_signed();
    (if bits >> 31 == 1 { -size } else { size }, exponent)
}

/// Writes the mantissas of these numbers and returns their exponent.
fn quantize<Q: FixedPoint>(from: &[f32], to: &mut [Q]) -> i32 {
    let tops = from.iter().map(|&number| decoded(number)).filter(|(size, _)| *size != 0);
    let top = tops.map(|(size, exponent)| size.bits().cast_signed() + exponent).max();
    // If all numbers are zero, use the least exponent, because an exponent bounds how large its
    // numbers can be.
    let exponent = top.unwrap_or(-96).max(-96) - Q::BITS.cast_signed();
    for (to, &number) in to.iter_mut().zip(from) {
        let (size, of_number) = decoded(number);
        *to = Q::saturate(Q::Wide::of(size).shifted(of_number - exponent));
    }
    exponent
}
