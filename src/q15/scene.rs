//! One image in fixed point, with the components of each azimuth summed,
//! I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z), and the irradiance of a normal.

use super::arithmetic::{SUM_SHIFT, Shift as _, TERM_BITS, WEIGHT_BITS, weigh};
use super::pixel::Pixel;
use super::relight::check_exponent;
use super::{Basis, Normal, Profile};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{split, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::specialized::shade_each;
use core::ops::{Add, Shr};

/// Number of low bits of d that [`size`] drops. The rest has at most 16 bits and so does the value
/// that a profile states, so their product fits into 32 bits.
const UNIT: u32 = 16;

/// One image: `buffer` holds the polynomials of +m and -m for each azimuth |m|, all to be
/// multiplied by 2^exponent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, B> {
    pub(crate) lengths: &'a [u8],
    pub(crate) exponent: i32,
    pub(crate) buffer: B,
}

impl<'a> Basis<'a> {
    /// Sums the components of each azimuth.
    ///
    /// `N` must be at least [`scene_len`](Self::scene_len). `mantissas` and `exponent` belong to
    /// the leading components; missing ones count as zero. Any mantissas are accepted, but the
    /// resolution of the scene is never finer than for mantissas of size 2^16.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, [`Error::Exponent`] if
    /// |exponent| is above 2^16, which no light on a material reaches, [`Error::Capacity`] if `N`
    /// is too small.
    pub fn collapse<const N: usize>(
        &self,
        mantissas: &[i32],
        exponent: i32,
    ) -> Result<Scene<'a, Buffer<i32, N>>, Error> {
        let buffer = zeros::<i32, N>(Argument::Scene, self.scene_len())?;
        self.collapse_into(mantissas, exponent, buffer)
    }

    /// [`collapse`](Self::collapse) into a buffer that the caller provides, of length
    /// [`scene_len`](Self::scene_len).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, or if the buffer has
    /// another length; [`Error::Exponent`] as for `collapse`.
    pub fn collapse_into<B: AsMut<[i32]>>(
        &self,
        mantissas: &[i32],
        exponent: i32,
        mut buffer: B,
    ) -> Result<Scene<'a, B>, Error> {
        let sums = buffer.as_mut();
        Error::check(Argument::Scene, self.scene_len(), sums.len())?;
        Error::check_components(self.components(), mantissas.len())?;
        check_exponent(exponent)?;
        sums.fill(0);
        let bits = self.size(mantissas);
        let (mut terms, mut profiles, mut rest) = (self.parts.terms, self.parts.profiles, sums);
        for (azimuth, &length) in self.parts.lengths.iter().enumerate() {
            let (block, others) = of_azimuth(profiles, azimuth);
            profiles = others;
            let finer = finer(bits, bits_of(step(mantissas, block)));
            let (base, mut rows) = (base(bits) + finer.cast_signed(), terms);
            for is_minus in [false, true] {
                if is_minus && azimuth == 0 {
                    continue;
                }
                let length = usize::from(length);
                let (polynomial, after) = split_mut(rest, length);
                (rest, rows) = (after, terms);
                let mut either = 0;
                for profile in block {
                    let (row, after) = split(rows, length);
                    rows = after;
                    let component = if is_minus { profile.minus } else { profile.plus };
                    let d = mantissas.get(usize::from(component)).copied().unwrap_or(0);
                    let weight = weight(d, base + i32::from(profile.exponent));
                    either |= weight;
                    // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
                    let weight = if is_minus { weight.wrapping_neg() } else { weight };
                    for (sum, term) in polynomial.iter_mut().zip(row) {
                        *sum = sum.wrapping_add(weigh(*term, weight));
                    }
                }
                if either != 0 {
                    round(polynomial, SUM_SHIFT + finer, azimuth == 0);
                }
            }
            terms = rows;
        }
        let to = exponent + bits - TERM_BITS.cast_signed();
        Ok(Scene { lengths: self.parts.lengths, exponent: to, buffer })
    }

    /// The scene of polynomials and an exponent that were collapsed earlier and stored. The
    /// irradiances are meaningless for any other numbers.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) numbers.
    #[inline]
    pub fn scene<B: AsRef<[i32]>>(&self, exponent: i32, buffer: B) -> Result<Scene<'a, B>, Error> {
        Error::check(Argument::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene { lengths: self.parts.lengths, exponent, buffer })
    }

    /// The least n such that no step of a pixel's polynomials, none of their terms and no
    /// irradiance exceeds 2^n in units of these coefficients, with a margin of one sixty-fourth for
    /// rounding and for normals that are not quite of unit length. Each of these is a sum over
    /// components, and each component contributes at most |d| times the value that the table states
    /// for its profile.
    fn size(&self, mantissas: &[i32]) -> i32 {
        let mut profiles = self.parts.profiles;
        let [plus, minus] = SIGNS.map(|sign| sum(mantissas, profiles, sign, |one| one.size));
        let mut largest = plus + minus;
        for azimuth in 0..=self.degree() {
            let (block, others) = of_azimuth(profiles, azimuth);
            largest = largest.max(step(mantissas, block));
            profiles = others;
        }
        bits_of(largest)
    }
}

/// The profiles of this azimuth, which come first, and the others.
fn of_azimuth(profiles: &[Profile], azimuth: usize) -> (&[Profile], &[Profile]) {
    let of_azimuth = |profile: &&Profile| usize::from(profile.azimuth) == azimuth;
    let count = profiles.iter().take_while(of_azimuth).count();
    split_row(profiles, count)
}

/// The components of a profile for +m and for -m.
const SIGNS: [fn(&Profile) -> u16; 2] = [|profile| profile.plus, |profile| profile.minus];

/// The largest term or step of the polynomials of one azimuth.
fn step(mantissas: &[i32], profiles: &[Profile]) -> u64 {
    let [plus, minus] = SIGNS.map(|sign| sum(mantissas, profiles, sign, |profile| profile.step));
    plus.max(minus)
}

/// Sums the sizes of d times the values that the profiles state.
fn sum(
    mantissas: &[i32],
    profiles: &[Profile],
    component: impl Fn(&Profile) -> u16,
    stated: impl Fn(&Profile) -> u16,
) -> u64 {
    let products = profiles.iter().map(|profile| {
        let d = mantissas.get(usize::from(component(profile))).copied().unwrap_or(0);
        u64::from(size(d) * u32::from(stated(profile)))
    });
    products.sum()
}

/// By how many bits an azimuth's weights can be finer, because its terms have fewer bits.
#[inline(always)]
pub(crate) fn finer(bits: i32, of_azimuth: i32) -> u32 {
    (bits - of_azimuth).cast_unsigned().min(FINEST)
}

/// The upper limit of [`finer`].
pub(crate) const FINEST: u32 = 2;

/// The size of d: |d| in units of 2^[`UNIT`], rounded up.
#[inline(always)]
pub(crate) fn size(d: i32) -> u32 {
    (d.unsigned_abs() + ((1 << UNIT) - 1)) >> UNIT
}

/// Number of bits of the largest step, term or irradiance, in sixteenths of 2^[`UNIT`].
#[inline]
pub(crate) fn bits_of(largest: u64) -> i32 {
    let bits = u64::BITS - with_margin(largest).leading_zeros();
    bits.cast_signed() - 4 + UNIT.cast_signed()
}

/// The largest step, term or irradiance, plus a margin for the error of that bound.
#[inline(always)]
pub(crate) fn with_margin<N>(largest: N) -> N
where
    N: Copy + Add<Output = N> + Shr<u32, Output = N>,
{
    // A normal may be a two-thousandth too long, which makes (n_x + i n_y)^m too large by the mth
    // power. The sixty-fourth covers this up to m = 24, twice the largest degree.
    largest + (largest >> 6)
}

/// The shift from d to the weight of a component is this number plus the exponent of its profile.
/// `bits` is the number of bits of the scene's terms, in units of d.
#[inline(always)]
pub(crate) fn base(bits: i32) -> i32 {
    (WEIGHT_BITS + TERM_BITS).cast_signed() - bits
}

/// d 2^`by`, rounded.
#[inline]
fn weight(d: i32, by: i32) -> i32 {
    // The shift may be anything for a profile of size zero.
    if by >= 0 { d << by.min(31) } else { d.shifted(by) }
}

/// Scales the sums of weighted terms. A step of Horner's rule rounds down, by half a unit on
/// average, so every term that is added to such a step is rounded up by as much. The first term is
/// not added to any step, and the last term of m = 0 is added to a step that is not rounded.
#[inline]
fn round(polynomial: &mut [i32], by: u32, is_constant: bool) {
    let last = polynomial.len().saturating_sub(1);
    for (k, sum) in polynomial.iter_mut().enumerate() {
        let nearest = k == 0 || (is_constant && k == last);
        *sum = sum.wrapping_add(half_or_one(nearest, by)) >> by;
    }
}

/// The number added before a shift: half a unit to round to the nearest, otherwise one unit.
#[inline(always)]
pub(crate) fn half_or_one(nearest: bool, by: u32) -> i32 {
    (1 << by) >> u32::from(nearest)
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// Shades one normal. The irradiance is the result times 2 to the scene's
    /// [`exponent`](Self::exponent).
    #[inline]
    #[must_use]
    pub fn shade(&self, normal: Normal) -> i32 {
        let (first, mut lengths, mut rest) = self.constant();
        let mut pixel = Pixel::new(first, normal);
        while let [length, others @ ..] = lengths {
            let length = usize::from(*length);
            let (plus, after) = split_row(rest, length);
            let (minus, after) = split_row(after, length);
            (lengths, rest) = (others, after);
            pixel = pixel.add(plus, minus);
        }
        pixel.irradiance()
    }

    /// Writes the irradiance of each normal into `irradiance`: bit for bit as
    /// [`shade`](Self::shade).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless `irradiance` and `normals` have the same length.
    pub fn shade_slice(&self, normals: &[Normal], irradiance: &mut [i32]) -> Result<(), Error> {
        shade_each(normals, irradiance, |normal| self.shade(normal))
    }

    /// The polynomial of m = 0, and the lengths and polynomials of the other azimuths.
    #[inline]
    fn constant(&self) -> (&[i32], &[u8], &[i32]) {
        let (length, lengths) = self.lengths.split_first().unwrap_or((&0, &[]));
        let terms = self.buffer.as_ref();
        let (first, rest) = split_row(terms, usize::from(*length));
        (first, lengths, rest)
    }
}

impl<B: AsRef<[i32]>> Scene<'_, B> {
    /// The terms of all polynomials, azimuth by azimuth, the ones of +m before the ones of -m.
    #[must_use]
    pub fn terms(&self) -> &[i32] {
        self.buffer.as_ref()
    }
}

impl<B> Scene<'_, B> {
    /// The exponent of every irradiance.
    #[must_use]
    pub const fn exponent(&self) -> i32 {
        self.exponent
    }
}
