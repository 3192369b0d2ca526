//! How large the terms, steps and irradiances of a scene can get, and the shifts of its weights that
//! follow from it.
//!
//! Each of them is a sum over components, and each component contributes at most |d| times the value
//! that the table states for its profile.

use super::{Basis, Profile};
use crate::format::{FixedPoint, Wide as _};
use crate::places::Shape;
use core::ops::{Add, Mul, Shr};

/// Number of low bits of d that [`size`] drops. The rest has at most 16 bits and so does the value
/// that a profile states, so their product fits into 32 bits.
const UNIT: u32 = 16;

/// The upper limit of [`finer`].
const FINEST: u32 = 2;

/// The type of a sum of sizes: `u32` for a table whose stated values sum to less than 2^16.
pub trait Sum:
    Copy
    + Ord
    + From<u16>
    + From<u32>
    + Into<u64>
    + Add<Output = Self>
    + Mul<Output = Self>
    + Shr<i32, Output = Self>
{
}
impl Sum for u32 {}
impl Sum for u64 {}

/// The size of d: |d| in units of 2^[`UNIT`], rounded up.
#[inline(always)]
fn size(d: i32) -> u32 {
    (d.unsigned_abs() + ((1 << UNIT) - 1)) >> UNIT
}

/// The largest irradiance of the components of some profiles of one azimuth, and the largest term or
/// step of their polynomials, both in sixteenths of 2^[`UNIT`].
#[inline(always)]
pub(super) fn sizes<N: Sum>(mantissas: &[i32], profiles: &[Profile]) -> [N; 2] {
    let of = |index: u16| mantissas.get(usize::from(index)).copied().map_or(0, size);
    let [mut image, mut of_plus, mut of_minus] = [N::from(0_u32); 3];
    for profile in profiles {
        let (plus, minus) = (of(profile.plus), of(profile.minus));
        let (size, step) = (u32::from(profile.size), u32::from(profile.step));
        image = image + N::from((plus + minus) * size);
        of_plus = of_plus + N::from(plus * step);
        of_minus = of_minus + N::from(minus * step);
    }
    [image, of_plus.max(of_minus)]
}

/// The least n such that no step of a pixel's polynomials, none of their terms and no irradiance
/// exceeds 2^n in units of d, where `largest` is the largest of them as [`sizes`] gives it.
#[inline]
pub(super) fn bits<N: Sum>(largest: N, degree: usize) -> i32 {
    let largest: u64 = with_margin(largest, degree).into();
    let bits = u64::BITS - largest.leading_zeros();
    bits.cast_signed() - 4 + UNIT.cast_signed()
}

/// The largest step, term or irradiance, with a margin of one sixty-fourth for rounding and for
/// normals that are not quite of unit length.
#[inline(always)]
fn with_margin<N: Sum>(largest: N, degree: usize) -> N {
    // A normal may be a two-thousandth too long, which makes (n_x + i n_y)^m too large by the mth
    // power. The sixty-fourth covers this up to m = 24. The degree is at most 510.
    let beyond = N::from(degree.saturating_sub(24) as u16);
    largest + (largest >> 6) + beyond * (largest >> 10)
}

/// By how many bits the weights of an azimuth can be finer than those of the scene, because its
/// terms have fewer bits.
#[inline(always)]
pub(super) fn finer(bits: i32, of_azimuth: i32) -> u32 {
    (bits - of_azimuth).cast_unsigned().min(FINEST)
}

/// The shift from d to the weight of a component is this number plus the exponent of its profile.
/// `bits` is the number of bits of the scene's terms, in units of d.
#[inline(always)]
pub(super) fn base<Q: FixedPoint>(bits: i32) -> i32 {
    (Q::WEIGHT_BITS + Q::TERM_BITS).cast_signed() - bits
}

/// d 2^`by`, rounded.
#[inline]
pub(super) fn weight(d: i32, by: i32) -> i32 {
    // The shift may be anything for a profile of size zero.
    if by >= 0 { d << by.min(31) } else { d.shifted(by) }
}

/// The size of an image, for a table with `A` azimuths.
#[derive(Clone, Copy, Debug)]
pub struct Size<N, const A: usize> {
    image: N,
    steps: [N; A],
}

/// The number of bits of a scene, and the shifts of its weights.
#[derive(Clone, Copy, Debug)]
pub struct Shifts<const A: usize> {
    pub(super) bits: i32,
    base: i32,
    finer: [u32; A],
}

/// Number of azimuths up to the last one with profiles.
#[must_use]
pub const fn azimuths<Q>(basis: &Basis<'_, Q>) -> usize {
    match basis.parts.profiles {
        [.., last] => last.azimuth() + 1,
        [] => 0,
    }
}

impl<N: Sum, const A: usize> Size<N, A> {
    /// The size of a black image.
    #[inline(always)]
    #[must_use]
    pub fn empty() -> Self {
        Self { image: N::from(0_u32), steps: [N::from(0_u32); A] }
    }

    /// Adds the components of azimuth `M`.
    #[inline(always)]
    #[must_use]
    pub fn azimuth<B: Shape<Basis<'static, Q>>, Q: FixedPoint, const M: usize, const K: usize>(
        mut self,
        d: &[i32; K],
    ) -> Self {
        let profiles = const { B::BASIS.profiles_at(&B::BASIS.azimuth_at(M)) };
        let [image, of_azimuth] = sizes::<N>(d, profiles);
        self.image = self.image + image;
        if let Some(step) = self.steps.get_mut(M) {
            *step = of_azimuth;
        }
        self
    }

    /// The shifts of this table. `None` if there is hardly an image, or if weights that are coarser
    /// than d would have to be shifted left, or right by more bits than they have.
    #[inline(never)]
    #[must_use]
    pub fn shifts<B: Shape<Basis<'static, Q>>, Q: FixedPoint>(&self) -> Option<Shifts<A>> {
        let degree = const { B::BASIS.parts.degree };
        let [least, largest] = const { exponents(B::BASIS.parts.profiles) };
        let bits = bits(self.steps.iter().copied().fold(self.image, N::max), degree);
        let base = base::<Q>(bits);
        let beyond = base + FINEST.cast_signed() + largest >= 0 || base + least < -31;
        if bits < 20 || (is_coarse::<Q>() && beyond) {
            return None;
        }
        let finer = self.steps.map(|step| {
            // The top bits show by how many bits the step is shorter, up to `FINEST`: the same
            // result as with `finer`, which counts bits.
            let top = with_margin(step, degree) >> (bits + 4 - (UNIT + FINEST).cast_signed());
            let top: u64 = top.into();
            FINEST.saturating_sub(top as u32)
        });
        Some(Shifts { bits, base, finer })
    }
}

/// The least and the largest exponent of these profiles.
const fn exponents(mut profiles: &[Profile]) -> [i32; 2] {
    let (mut least, mut largest) = (i8::MAX as i32, i8::MIN as i32);
    while let [profile, others @ ..] = profiles {
        let exponent = profile.exponent as i32;
        least = if exponent < least { exponent } else { least };
        largest = if exponent > largest { exponent } else { largest };
        profiles = others;
    }
    [least, largest]
}

/// Whether weights have no more bits than d.
#[inline(always)]
const fn is_coarse<Q: FixedPoint>() -> bool {
    Q::WEIGHT_BITS + Q::TERM_BITS <= 31
}

impl<const A: usize> Shifts<A> {
    /// By how many bits the weights of this azimuth are finer.
    #[inline(always)]
    pub(super) fn finer(&self, azimuth: usize) -> u32 {
        self.finer.get(azimuth).copied().unwrap_or(0)
    }

    /// The rounded weight of a component whose profile has this exponent.
    #[inline(always)]
    pub(super) fn weight<Q: FixedPoint>(&self, d: i32, exponent: i8, finer: u32) -> i32 {
        let by = self.base + i32::from(exponent) + finer.cast_signed();
        if is_coarse::<Q>() {
            // The same as `weight` in its range, without a comparison.
            return (d >> ((-1 - by) & 31)).wrapping_add(1) >> 1;
        }
        weight(d, by)
    }
}
