//! Light and material in fixed point.

use crate::error::{Error, What};
use crate::format::{Fixed, Wide as _};
use crate::index::{light, material};

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
    /// The light with these mantissas; |exponent| <= 128.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are (degree + 1)² mantissas, [`Error::Exponent`] if
    /// |exponent| is above 128.
    pub const fn new(degree: usize, exponent: i32, mantissas: &'a [Q]) -> Result<Self, Error> {
        if exponent.unsigned_abs() > 128 {
            return Err(Error::Exponent);
        }
        match Error::check(What::Light, light::count(degree), mantissas.len()) {
            Ok(()) => Ok(Self { degree, exponent, mantissas }),
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
    /// The material with these mantissas.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`index::material::count`](crate::index::material::count)
    /// mantissas, and one exponent for each o.
    pub const fn new(order: usize, exponents: &'a [i8], mantissas: &'a [Q]) -> Result<Self, Error> {
        let checks = [
            Error::check(What::Material, material::count(order), mantissas.len()),
            Error::check(What::Material, order.saturating_add(1), exponents.len()),
        ];
        match checks {
            [Ok(()), Ok(())] => Ok(Self { order, exponents, mantissas }),
            [Err(error), _] | [_, Err(error)] => Err(error),
        }
    }
}

impl<'a, Q: Fixed> Light<'a, Q> {
    /// Writes the mantissas of a light into `to`, in integer arithmetic throughout.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless both slices have (degree + 1)² numbers, [`Error::NotFinite`] for
    /// the first number that is infinite or NaN, which no integer can represent.
    pub fn quantise(degree: usize, from: &[f32], to: &'a mut [Q]) -> Result<Self, Error> {
        Error::check(What::Light, light::count(degree), from.len())?;
        Error::check(What::Light, from.len(), to.len())?;
        check_finite(What::Light, from)?;
        let exponent = quantise(from, to);
        Self::new(degree, exponent, to)
    }
}

impl<'a, Q: Fixed> Material<'a, Q> {
    /// Writes the mantissas of a material into `to` and its exponents into `exponents`: see
    /// [`Light::quantise`].
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `from` and `to` have
    /// [`index::material::count`](crate::index::material::count) numbers and `exponents` has
    /// order + 1; [`Error::NotFinite`] as in [`Light::quantise`].
    pub fn quantise(
        order: usize,
        from: &[f32],
        to: &'a mut [Q],
        exponents: &'a mut [i8],
    ) -> Result<Self, Error> {
        Error::check(What::Material, material::count(order), from.len())?;
        Error::check(What::Material, from.len(), to.len())?;
        Error::check(What::Material, order.saturating_add(1), exponents.len())?;
        check_finite(What::Material, from)?;
        let (mut from, mut rest) = (from, &mut *to);
        for (o, exponent) in exponents.iter_mut().enumerate() {
            let count = (o / 2 + 1) * (o / 2 + 2) / 2;
            let (of_order, after) = from.split_at_checked(count).unwrap_or((from, &[]));
            let (places, places_after) = rest.split_at_mut_checked(count).unwrap_or_default();
            *exponent = quantise(of_order, places).clamp(-127, 127) as i8;
            (from, rest) = (after, places_after);
        }
        Self::new(order, exponents, to)
    }
}

/// [`Error::check_finite`] without a float unit: tests the bits of the exponent.
fn check_finite(what: What, numbers: &[f32]) -> Result<(), Error> {
    match numbers.iter().position(|number| (number.to_bits() >> 23) & 0xff == 0xff) {
        None => Ok(()),
        Some(index) => Err(Error::NotFinite { what, index }),
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
fn quantise<Q: Fixed>(from: &[f32], to: &mut [Q]) -> i32 {
    let tops = from.iter().map(|&number| decoded(number)).filter(|(size, _)| *size != 0);
    let top = tops.map(|(size, exponent)| size.bits().cast_signed() + exponent).max();
    // If all numbers are zero, use the least exponent, because an exponent bounds how large its
    // numbers can be.
    let exponent = top.unwrap_or(-96).max(-96) - Q::BITS.cast_signed();
    for (to, &number) in to.iter_mut().zip(from) {
        let (size, of_number) = decoded(number);
        *to = Q::narrow(Q::Wide::of(size).shifted(of_number - exponent));
    }
    exponent
}
