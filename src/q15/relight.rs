//! The coefficients d of an image in fixed point, and a new light on a transferred material:
//! d_i = Σ_l T_i,l L_l^m.

use super::arithmetic::{BITS as MANTISSA_BITS, Shift as _};
use super::{Basis, Light, Profile, Q15, Transfer};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part, split_row};
use crate::error::{Argument, Error};
use crate::index::light;
use crate::known_table::{KnownTable, at};

/// The coefficients d of one image, component by component: mantissas times 2^exponent, with an
/// exponent from -2^16 to 2^16. Mantissas that were computed are at most 2^30 in size.
#[derive(Clone, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Coefficients<const K: usize> {
    pub(crate) mantissas: Buffer<i32, K>,
    pub(crate) exponent: i32,
}

impl<const K: usize> Coefficients<K> {
    /// Coefficients that were stored: mantissas, all times 2^exponent.
    ///
    /// # Errors
    ///
    /// [`Error::Exponent`] if |exponent| is above 2^16, which no light on a material reaches.
    pub fn new(mantissas: [i32; K], exponent: i32) -> Result<Self, Error> {
        check_exponent(exponent)?;
        Ok(Self { mantissas: mantissas.into(), exponent })
    }

    /// The mantissas, component by component.
    #[must_use]
    pub fn mantissas(&self) -> &[i32] {
        &self.mantissas
    }

    /// The common exponent.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}

/// `Ok` if an exponent of coefficients is at most 2^16 in size.
pub(crate) fn check_exponent(exponent: i32) -> Result<(), Error> {
    if exponent.unsigned_abs() > 1 << 16 { Err(Error::Exponent) } else { Ok(()) }
}

/// Number of bits of a mantissa of d.
const BITS: i32 = 30;

impl Basis<'_> {
    /// A transfer of these numbers, checked once for this basis. The function is `const`, so the
    /// transfer can initialize a static.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`transfer_len`](Self::transfer_len) numbers and
    /// [`profiles`](Self::profiles) exponents, [`Error::Bound`] if a row sums to
    /// 2^16 or more.
    pub const fn checked_transfer<'t>(
        &self,
        numbers: &'t [Q15],
        exponents: &'t [i16],
    ) -> Result<Transfer<'t>, Error> {
        let lengths = [
            Error::check(Argument::Transfer, self.transfer_len(), numbers.len()),
            Error::check(Argument::Transfer, self.profiles(), exponents.len()),
        ];
        if let [Err(error), _] | [_, Err(error)] = lengths {
            return Err(error);
        }
        let (mut rest, mut profiles) = (numbers, self.parts.profiles);
        while let [profile, others @ ..] = profiles {
            let length = self.parts.degree + 1 - profile.azimuth();
            let Some((row, tail)) = rest.split_at_checked(length) else { break };
            if !Self::bounds(row) {
                return Err(Error::Bound);
            }
            (rest, profiles) = (tail, others);
        }
        Ok(Transfer { numbers, exponents, bounded: true })
    }

    /// Computes d for a new light on a material whose transfer is known.
    ///
    /// `K` must be at least [`components`](Self::components).
    ///
    /// # Errors
    ///
    /// The same as [`relight_into`](Self::relight_into), and [`Error::Capacity`] if `K` is too
    /// small.
    pub fn relight<const K: usize>(
        &self,
        transfer: &Transfer<'_>,
        light: &Light<'_>,
    ) -> Result<Coefficients<K>, Error> {
        let mut mantissas = zeros::<i32, K>(Argument::Coefficients, self.components())?;
        let exponent = self.relight_into(transfer, light, &mut mantissas)?;
        Ok(Coefficients { mantissas, exponent })
    }

    /// [`relight`](Self::relight) into a slice of [`components`](Self::components) mantissas.
    /// Returns their exponent.
    ///
    /// # Errors
    ///
    /// [`Error::Beyond`] if the light goes beyond the basis's degree, [`Error::Length`] if the
    /// transfer or the slice does not fit the basis, [`Error::Bound`] if a row of a transfer made
    /// by [`Transfer::new`] sums to 2^16 or more.
    pub fn relight_into(
        &self,
        transfer: &Transfer<'_>,
        light: &Light<'_>,
        mantissas: &mut [i32],
    ) -> Result<i32, Error> {
        Error::check_beyond(Argument::Light, self.degree(), light.degree)?;
        Error::check(Argument::Transfer, self.transfer_len(), transfer.numbers.len())?;
        Error::check(Argument::Transfer, self.profiles(), transfer.exponents.len())?;
        Error::check(Argument::Coefficients, self.components(), mantissas.len())?;
        if !transfer.bounded && !self.has_bounded(transfer.numbers) {
            return Err(Error::Bound);
        }
        let (mut numbers, mut top) = (transfer.numbers, NONE);
        for (profile, &exponent) in self.parts.profiles.iter().zip(transfer.exponents) {
            let degrees = self.degree() + 1 - profile.azimuth();
            let (row, after) = split_row(numbers, degrees);
            numbers = after;
            let sums = sums::<true>(row, light.mantissas, profile.azimuth());
            top = top.max(size(write(sums, profile, mantissas), exponent));
        }
        let common = common(top);
        for (profile, &exponent) in self.parts.profiles.iter().zip(transfer.exponents) {
            let by = i32::from(exponent) - common;
            replace(profile, mantissas, |mantissa| mantissa.shifted(by));
        }
        Ok(exponent(common, light.exponent))
    }

    /// Whether the absolute values of each row sum to less than 2^16.
    #[cold]
    fn has_bounded(&self, mut numbers: &[Q15]) -> bool {
        self.parts.profiles.iter().all(|profile| {
            let length = self.degree() + 1 - usize::from(profile.azimuth);
            let (row, after) = split_row(numbers, length);
            numbers = after;
            let mut sum = 0;
            for number in row {
                let number = number.get();
                sum += number.max(-number);
            }
            sum.bits() <= MANTISSA_BITS + 1
        })
    }
}

/// The numbers and exponents of a transfer that a light of any degree up to the table's can be
/// applied to.
///
/// # Errors
///
/// As [`Basis::relight_into`].
#[inline(always)]
pub fn inputs<'a, const T: usize, const P: usize>(
    basis: &Basis<'_>,
    transfer: &Transfer<'a>,
    light: &Light<'_>,
) -> Result<(&'a [Q15; T], &'a [i16; P]), Error> {
    Error::check_beyond(Argument::Light, basis.degree(), light.degree)?;
    let length = |found, expected| Error::Length { argument: Argument::Transfer, expected, found };
    let (numbers, exponents) = (transfer.numbers, transfer.exponents);
    let of_length = (
        numbers.try_into().map_err(|_| length(numbers.len(), T))?,
        exponents.try_into().map_err(|_| length(exponents.len(), P))?,
    );
    let fits = transfer.bounded || basis.has_bounded(numbers);
    if fits { Ok(of_length) } else { Err(Error::Bound) }
}

/// Computes the sums of azimuth `M`: for each of its profiles. Not inlined: several copies in one
/// function need too many addresses.
#[inline(never)]
pub fn relight_azimuth<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const T: usize,
    const P: usize,
    const N: usize,
    const K: usize,
>(
    (numbers, exponents, light): (&[Q15; T], &[i16; P], &[Q15; N]),
    mantissas: &mut [i32; K],
    top: i32,
) -> i32 {
    let (place, degrees) = const { (*at(B::BASIS.parts.azimuths, M), B::BASIS.degree() + 1 - M) };
    let profiles = const { B::BASIS.profiles_of(M) };
    let rows = part(numbers, place.rows as usize..).chunks_exact(degrees);
    let exponents = part(exponents, place.first.into()..);
    let mut top = top;
    for ((row, profile), &exponent) in rows.zip(profiles).zip(exponents) {
        let sums = if M > 0 { sums::<true>(row, light, M) } else { sums::<false>(row, light, M) };
        top = larger(top, write(sums, profile, mantissas), exponent);
    }
    top
}

/// Shifts the components of azimuth `M` to the common exponent.
#[inline(always)]
pub fn align<B, const M: usize, const P: usize, const K: usize>(
    exponents: &[i16; P],
    common: i32,
    mantissas: &mut [i32; K],
) where
    B: KnownTable<Basis<'static>>,
{
    let first = const { at(B::BASIS.parts.azimuths, M).first };
    let profiles = const { B::BASIS.profiles_of(M) };
    let exponents = part(exponents, first.into()..);
    for (profile, &exponent) in profiles.iter().zip(exponents) {
        let by = i32::from(exponent) - common;
        // The same as `shifted`, in fewer instructions.
        let (up, down) = (by.clamp(0, 31), (-1 - by).clamp(0, 31));
        replace(profile, mantissas, |mantissa| {
            let (raised, twice) = (mantissa << up, mantissa >> down);
            if by < 0 { (twice >> 1) + (twice & 1) } else { raised }
        });
    }
}

/// All mantissas of the coefficients of an image, to be written, and their exponent.
///
/// # Errors
///
/// None: a buffer holds as many as its capacity.
#[inline(always)]
pub fn coefficients<const K: usize>(
    coefficients: &mut Coefficients<K>,
) -> Result<(&mut [i32; K], &mut i32), Error> {
    let Coefficients { mantissas, exponent } = coefficients;
    let (argument, needed, capacity) = (Argument::Coefficients, K, K);
    let mantissas = mantissas.filled().ok_or(Error::Capacity { argument, needed, capacity })?;
    Ok((mantissas, exponent))
}

/// The size of an empty sum: it is less than any other, and no difference from it overflows.
pub const NONE: i32 = -1 << 20;

/// Σ_l T_l L_l^±m, with the sum of -m times (-1)^m. Each row of a transfer of this basis sums to
/// less than 2^16, so both fit. The sums may wrap for a transfer of another basis, but must
/// not panic. Without `MINUS`, which azimuth 0 does not need, the second sum is zero.
#[inline(always)]
fn sums<const MINUS: bool>(row: &[Q15], light: &[Q15], azimuth: usize) -> [i32; 2] {
    let (mut plus, mut minus) = (0_i32, 0_i32);
    let order = azimuth.cast_signed();
    let at = |place: usize| light.get(place).copied().unwrap_or_default().get();
    for (l, number) in (azimuth..).zip(row) {
        let number = number.get();
        plus = plus.wrapping_add(number * at(light::position(l, order)));
        if MINUS {
            minus = minus.wrapping_add(number * at(light::position(l, -order)));
        }
    }
    [plus, if azimuth % 2 == 1 { minus.wrapping_neg() } else { minus }]
}

/// Writes the sums of a profile to its components. Returns the bitwise OR of their sizes.
#[inline(always)]
fn write([plus, minus]: [i32; 2], profile: &Profile, mantissas: &mut [i32]) -> u32 {
    let mut either = 0;
    for (component, sum) in [(profile.plus, plus), (profile.minus, minus)] {
        if let Some(mantissa) = mantissas.get_mut(usize::from(component)) {
            *mantissa = sum;
            either |= mantissa.unsigned_abs();
        }
    }
    either
}

/// The larger of `top` and the size of the sums of a profile, whose bits are counted only if they
/// may exceed `top`: some machines count in a loop.
#[inline(always)]
fn larger(top: i32, either: u32, exponent: i16) -> i32 {
    let room = top - i32::from(exponent);
    if room < 0 || (room < 31 && either >> (room & 31) != 0) {
        size(either, exponent).max(top)
    } else {
        top
    }
}

#[inline(never)]
fn size(either: u32, exponent: i16) -> i32 {
    if either == 0 {
        return NONE;
    }
    let bits = u32::BITS - either.leading_zeros();
    bits.cast_signed() + i32::from(exponent)
}

/// The common exponent of all components.
#[inline(always)]
pub const fn common(top: i32) -> i32 {
    if top == NONE { 0 } else { top - BITS }
}

#[inline(always)]
fn replace(profile: &Profile, mantissas: &mut [i32], by: impl Fn(i32) -> i32) {
    for component in [profile.plus, profile.minus] {
        if let Some(mantissa) = mantissas.get_mut(usize::from(component)) {
            *mantissa = by(*mantissa);
        }
    }
}

/// The exponent of the coefficients of an image.
#[inline(always)]
pub const fn exponent(common: i32, of_light: i32) -> i32 {
    common + of_light
}
