//! One image in integers, its components summed azimuth by azimuth:
//! I(n) = Σ_m Re/Im (n_x + i n_y)^m H_m(n_z).

use super::{Basis, Profile};
use crate::buffer::zeros;
use crate::error::{Error, What};
use crate::format::{Fixed, Wide as _};
use core::marker::PhantomData;
use core::ops::{Add, Mul, Shr};

/// Room for a collapsed scene.
pub type SceneBuffer<const N: usize> = heapless::Vec<i32, N>;

/// Bits of d that its size leaves out: twice ten and sixteen are 32.
const UNIT: u32 = 16;

/// One image: for each azimuth |m| the polynomials of +m and -m in `buffer`, all times
/// 2^exponent.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Scene<'a, Q, B> {
    pub(crate) lengths: &'a [u8],
    pub(crate) exponent: i32,
    pub(crate) buffer: B,
    format: PhantomData<Q>,
}

impl<'a, Q: Fixed> Basis<'a, Q> {
    /// Sums the components of each azimuth.
    ///
    /// `N` is at least [`scene_len`](Self::scene_len). `mantissas` and `exponent` are
    /// those of the first components; those that are missing count as zero. They may be
    /// any: but the scene's resolution is what 2^16 of them are.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components,
    /// [`Error::Exponent`] if |exponent| is above 2^16, which that of no light on a
    /// material is, [`Error::Capacity`] if `N` is too small.
    pub fn collapse<const N: usize>(
        &self,
        mantissas: &[i32],
        exponent: i32,
    ) -> Result<Scene<'a, Q, SceneBuffer<N>>, Error> {
        let buffer = zeros::<i32, N>(What::Scene, self.scene_len())?;
        self.collapse_into(mantissas, exponent, buffer)
    }

    /// [`collapse`](Self::collapse) into a buffer of one's own, of length
    /// [`scene_len`](Self::scene_len).
    ///
    /// # Errors
    ///
    /// [`Error::Length`] if there are more coefficients than components, or the buffer
    /// has another length; [`Error::Exponent`] as there.
    pub fn collapse_into<B: AsMut<[i32]>>(
        &self,
        mantissas: &[i32],
        exponent: i32,
        mut buffer: B,
    ) -> Result<Scene<'a, Q, B>, Error> {
        let sums = buffer.as_mut();
        Error::check(What::Scene, self.scene_len(), sums.len())?;
        if mantissas.len() > self.components() {
            let (expected, found) = (self.components(), mantissas.len());
            return Err(Error::Length { what: What::Coefficients, expected, found });
        }
        if exponent.unsigned_abs() > 1 << 16 {
            return Err(Error::Exponent);
        }
        sums.fill(0);
        let bits = self.size(mantissas);
        let (mut terms, mut profiles, mut rest) = (self.parts.terms, self.parts.profiles, sums);
        for (azimuth, &length) in self.parts.lengths.iter().enumerate() {
            let (block, others) = split(profiles, azimuth);
            profiles = others;
            let finer = finer(bits, self.bits(step(mantissas, block)));
            let (base, mut rows) = (base::<Q>(bits) + finer.cast_signed(), terms);
            for is_minus in [false, true] {
                if is_minus && azimuth == 0 {
                    continue;
                }
                let length = usize::from(length);
                let (polynomial, after) = rest.split_at_mut_checked(length).unwrap_or_default();
                (rest, rows) = (after, terms);
                let mut either = 0;
                for profile in block {
                    let (row, after) = rows.split_at_checked(length).unwrap_or_default();
                    rows = after;
                    let component = if is_minus { profile.minus } else { profile.plus };
                    let d = mantissas.get(usize::from(component)).copied().unwrap_or(0);
                    let weight = weight(d, base + i32::from(profile.exponent));
                    either |= weight;
                    // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
                    let weight = if is_minus { weight.wrapping_neg() } else { weight };
                    for (sum, term) in polynomial.iter_mut().zip(row) {
                        *sum = sum.wrapping_add(term.weigh(weight));
                    }
                }
                if either != 0 {
                    round(polynomial, Q::SUM_SHIFT + finer, azimuth == 0);
                }
            }
            terms = rows;
        }
        let to = exponent + bits - Q::TERM_BITS.cast_signed();
        Ok(Scene { lengths: self.parts.lengths, exponent: to, buffer, format: PhantomData })
    }

    /// The scene of polynomials and an exponent that were collapsed before, from wherever
    /// they were kept. Others give meaningless irradiances.
    ///
    /// # Errors
    ///
    /// [`Error::Length`] unless there are [`scene_len`](Self::scene_len) of them.
    pub fn scene<B: AsRef<[i32]>>(
        &self,
        exponent: i32,
        buffer: B,
    ) -> Result<Scene<'a, Q, B>, Error> {
        Error::check(What::Scene, self.scene_len(), buffer.as_ref().len())?;
        Ok(Scene { lengths: self.parts.lengths, exponent, buffer, format: PhantomData })
    }

    /// The least n of: neither a step of a pixel's polynomials nor one of their terms nor
    /// an irradiance goes beyond 2^n, in units of these coefficients, less a sixty-fourth
    /// for rounding and normals that are not quite of unit length.
    ///
    /// Each is a sum over components, each at most |d| times what the table states of
    /// its profile.
    fn size(&self, mantissas: &[i32]) -> i32 {
        let mut profiles = self.parts.profiles;
        let [plus, minus] = SIGNS.map(|sign| sum(mantissas, profiles, sign, |one| one.size));
        let mut largest = plus + minus;
        for azimuth in 0..=self.degree() {
            let (block, others) = split(profiles, azimuth);
            largest = largest.max(step(mantissas, block));
            profiles = others;
        }
        self.bits(largest)
    }

    /// [`bits`] of this basis.
    fn bits(&self, largest: u64) -> i32 {
        bits(largest, self.degree())
    }
}

/// The profiles of this azimuth, which come first, and the others.
fn split(profiles: &[Profile], azimuth: usize) -> (&[Profile], &[Profile]) {
    let of_azimuth = |profile: &&Profile| usize::from(profile.azimuth) == azimuth;
    let count = profiles.iter().take_while(of_azimuth).count();
    profiles.split_at_checked(count).unwrap_or((profiles, &[]))
}

/// The component of +m of a profile, and of -m.
const SIGNS: [fn(&Profile) -> u16; 2] = [|profile| profile.plus, |profile| profile.minus];

/// The largest term or step of the polynomials of one azimuth.
fn step(mantissas: &[i32], profiles: &[Profile]) -> u64 {
    let [plus, minus] = SIGNS.map(|sign| sum(mantissas, profiles, sign, |profile| profile.step));
    plus.max(minus)
}

/// Sizes of d times what profiles state.
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

/// By how many bits the weights of an azimuth are finer than those of all: its terms have
/// less bits.
#[inline(always)]
pub(crate) fn finer(bits: i32, of_azimuth: i32) -> u32 {
    (bits - of_azimuth).cast_unsigned().min(FINEST)
}

/// The most that it is worth.
pub(crate) const FINEST: u32 = 2;

/// |d|, of which a size is made: in units of 2^[`UNIT`], rounded up.
#[inline(always)]
pub(crate) fn size(d: i32) -> u32 {
    (d.unsigned_abs() + ((1 << UNIT) - 1)) >> UNIT
}

/// Bits of a largest step, term or irradiance: `largest` is in sixteenths of
/// 2^[`UNIT`].
#[inline]
pub(crate) fn bits(largest: u64, degree: usize) -> i32 {
    let bits = u64::BITS - with_margin(largest, degree).leading_zeros();
    bits.cast_signed() - 4 + UNIT.cast_signed()
}

/// A largest step, term or irradiance and what it may be too small by.
#[inline(always)]
pub(crate) fn with_margin<N>(largest: N, degree: usize) -> N
where
    N: Copy + From<u16> + Add<Output = N> + Mul<Output = N> + Shr<u32, Output = N>,
{
    // A normal may be a two-thousandth too long, and (n_x + i n_y)^m its mth power: to
    // m = 24 that is in the sixty-fourth. The degree is at most 510.
    let beyond = N::from(degree.saturating_sub(24) as u16);
    largest + (largest >> 6) + beyond * (largest >> 10)
}

/// By how many bits a component's weight is more than d, less its profile's exponent,
/// where a scene's terms have `bits` bits in units of d.
#[inline(always)]
pub(crate) fn base<Q: Fixed>(bits: i32) -> i32 {
    (Q::WEIGHT_BITS + Q::TERM_BITS).cast_signed() - bits
}

/// d 2^`by`, rounded.
#[inline]
pub(crate) fn weight(d: i32, by: i32) -> i32 {
    // That of a profile of no size may be any.
    if by >= 0 { d << by.min(31) } else { d.shifted(by) }
}

/// Scales the sums of weighed terms.
///
/// A step of Horner's rule rounds down, half a unit on average; so every term that is
/// added to such a step is rounded up, by as much. The first is added to none, and the
/// last of m = 0 to one that is not rounded.
#[inline]
fn round(polynomial: &mut [i32], by: u32, is_constant: bool) {
    let last = polynomial.len().saturating_sub(1);
    for (k, sum) in polynomial.iter_mut().enumerate() {
        let nearest = k == 0 || (is_constant && k == last);
        *sum = sum.wrapping_add(half_or_one(nearest, by)) >> by;
    }
}

/// What is added before a sum's shift: half a unit to round it to the nearest, else one.
#[inline(always)]
pub(crate) fn half_or_one(nearest: bool, by: u32) -> i32 {
    (1 << by) >> u32::from(nearest)
}
