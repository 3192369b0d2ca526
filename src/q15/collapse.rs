//! Collapses an image in fixed point: sums the components of each azimuth into a [`Scene`].

use super::arithmetic::{SUM_SHIFT, Shift as _, TERM_BITS, WEIGHT_BITS, weigh};
use super::relight::check_exponent;
use super::scene::Scene;
use super::{Basis, Coefficients, Profile};
use crate::buffer::{Buffer, zeros};
use crate::checked_slice::{part_mut, split, split_mut, split_row};
use crate::error::{Argument, Error};
use crate::known_table::{KnownTable, at, head, tail};
use core::ops::{Add, Shr};

/// Number of low bits of d that [`size`] drops. The rest has at most 16 bits and so does the value
/// that a profile states, so their product fits into 32 bits.
const UNIT: u32 = 16;

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

    /// The least n such that no step of a pixel's polynomials, none of their terms and no
    /// irradiance exceeds 2^n in units of these coefficients, with a margin of one sixty-fourth for
    /// rounding and for normals that are not quite of unit length. Each of these is a sum over
    /// components, and each component contributes at most |d| times the value that the table states
    /// for its profile.
    fn size(&self, mantissas: &[i32]) -> i32 {
        let mut profiles = self.parts.profiles;
        let [plus, minus] = SIGNS.map(|sign| sum_sizes(mantissas, profiles, sign, |one| one.size));
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
    let [plus, minus] =
        SIGNS.map(|sign| sum_sizes(mantissas, profiles, sign, |profile| profile.step));
    plus.max(minus)
}

/// Sums the sizes of d times the values that the profiles state.
fn sum_sizes(
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
fn finer(bits: i32, of_azimuth: i32) -> u32 {
    (bits - of_azimuth).cast_unsigned().min(FINEST)
}

/// The upper limit of [`finer`].
const FINEST: u32 = 2;

/// The size of d: |d| in units of 2^[`UNIT`], rounded up.
#[inline(always)]
fn size(d: i32) -> u32 {
    (d.unsigned_abs() + ((1 << UNIT) - 1)) >> UNIT
}

/// Number of bits of the largest step, term or irradiance, in sixteenths of 2^[`UNIT`].
#[inline]
fn bits_of(largest: u64) -> i32 {
    let bits = u64::BITS - with_margin(largest).leading_zeros();
    bits.cast_signed() - 4 + UNIT.cast_signed()
}

/// The largest step, term or irradiance, plus a margin for the error of that bound.
#[inline(always)]
fn with_margin<N>(largest: N) -> N
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
fn base(bits: i32) -> i32 {
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
fn half_or_one(nearest: bool, by: u32) -> i32 {
    (1 << by) >> u32::from(nearest)
}

/// The mantissas of exactly `K` coefficients.
#[inline(always)]
pub fn mantissas<const K: usize>(coefficients: &Coefficients<K>) -> Option<&[i32; K]> {
    coefficients.mantissas.as_slice().try_into().ok()
}

/// How large the terms, steps and irradiances of a scene with `A` azimuths can get: sums of |d|
/// times the values that the table states for each profile. Domain: these values sum to less than
/// 2^16, the sizes over all components, the steps over the components of an azimuth.
#[derive(Clone, Copy, Debug)]
pub struct Size<const A: usize> {
    image: u32,
    steps: [u32; A],
}

/// The number of bits of a scene, and the shifts of its weights.
#[derive(Clone, Copy, Debug)]
pub struct Shifts<const A: usize> {
    bits: i32,
    base: i32,
    finer: [u32; A],
}

/// Number of azimuths up to the last one with profiles.
pub const fn azimuths(basis: &Basis<'_>) -> usize {
    match basis.parts.profiles {
        [.., last] => last.azimuth() + 1,
        [] => 0,
    }
}

impl<const A: usize> Size<A> {
    /// The size of a black image.
    #[inline(always)]
    pub const fn empty() -> Self {
        Self { image: 0, steps: [0; A] }
    }

    /// Adds the components of azimuth `M`.
    #[inline(always)]
    pub fn azimuth<B, const M: usize, const K: usize>(mut self, d: &[i32; K]) -> Self
    where
        B: KnownTable<Basis<'static>>,
    {
        let of = |index: u16| d.get(usize::from(index)).copied().map_or(0, size);
        let (mut of_plus, mut of_minus) = (0_u32, 0_u32);
        for profile in const { B::BASIS.profiles_of(M) } {
            let (plus, minus) = (of(profile.plus), of(profile.minus));
            let (size, step) = (u32::from(profile.size), u32::from(profile.step));
            self.image = self.image.wrapping_add((plus + minus).wrapping_mul(size));
            of_plus = of_plus.wrapping_add(plus.wrapping_mul(step));
            of_minus = of_minus.wrapping_add(minus.wrapping_mul(step));
        }
        if let Some(step) = self.steps.get_mut(M) {
            *step = of_plus.max(of_minus);
        }
        self
    }

    /// The shifts of this table. `None` if the image has less than 20 bits, or if a weight would be
    /// finer than d, or coarser by more than the bits of a word: the general form takes these.
    #[inline(never)]
    pub fn shifts<B: KnownTable<Basis<'static>>>(&self) -> Option<Shifts<A>> {
        let [least, largest] = const { exponents(B::BASIS.parts.profiles) };
        let most = self.steps.iter().copied().fold(self.image, u32::max);
        let bits = bits_of(most.into());
        let base = -base(bits);
        let most_finer = FINEST.cast_signed();
        let beyond = base - most_finer <= largest || base - least > 31;
        if bits < 20 || beyond {
            return None;
        }
        let finer = self.steps.map(|step| {
            // The top bits show by how many bits the step is shorter, up to `FINEST`: the same
            // result as with `bits`.
            let upper = with_margin(step) >> (bits - 12 - most_finer);
            FINEST.saturating_sub(upper)
        });
        Some(Shifts { bits, base, finer })
    }
}

const fn exponents(mut profiles: &[Profile]) -> [i32; 2] {
    let (mut least, mut largest) = (i32::MAX, i32::MIN);
    while let [profile, others @ ..] = profiles {
        let exponent = profile.exponent as i32;
        least = if exponent < least { exponent } else { least };
        largest = if exponent > largest { exponent } else { largest };
        profiles = others;
    }
    [least, largest]
}

impl<const A: usize> Shifts<A> {
    /// The rounded weight of a component whose profile has this exponent.
    #[inline(always)]
    fn weight(&self, d: &[i32], component: u16, exponent: i8, finer: u32) -> i32 {
        let d = d.get(usize::from(component)).copied().unwrap_or(0);
        let exponent = i32::from(exponent);
        let by = (self.base - exponent - 1).cast_unsigned().wrapping_sub(finer) & 31;
        (d >> by).wrapping_add(1) >> 1
    }
}

/// Writes the polynomials of azimuth `M`, which has `P` profiles.
#[inline(always)]
pub fn collapse_azimuth<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const P: usize,
    const A: usize,
    const K: usize,
    const N: usize,
>(
    d: &[i32; K],
    shifts: &Shifts<A>,
    scene: &mut [i32; N],
) {
    let finer = shifts.finer.get(M).copied().unwrap_or(0);
    let weight = |component, exponent| shifts.weight(d, component, exponent, finer);
    let profiles = const { profiles::<B, P>(M) };
    if M == 0 {
        let weights = profiles.map(|profile| [weight(profile.plus, profile.exponent)]);
        sum_profiles::<B, M, 1, P, N>(&weights, finer, scene);
    } else {
        // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
        let weights = profiles.map(|Profile { plus, minus, exponent, .. }| {
            [weight(plus, exponent), -weight(minus, exponent)]
        });
        sum_profiles::<B, M, 2, P, N>(&weights, finer, scene);
    }
}

const fn profiles<B: KnownTable<Basis<'static>>, const P: usize>(
    azimuth: usize,
) -> &'static [Profile; P] {
    head(B::BASIS.profiles_of(azimuth))
}

/// Sums the `P` profiles of azimuth `M`, with weights for `W` polynomials each. The weights are
/// `finer` by that many bits. Not inlined: a compiler that sees several azimuths at once runs out
/// of registers.
#[inline(never)]
fn sum_profiles<B, const M: usize, const W: usize, const P: usize, const N: usize>(
    weights: &[[i32; W]; P],
    finer: u32,
    scene: &mut [i32; N],
) where
    B: KnownTable<Basis<'static>>,
{
    let (place, length) = const { (*at(B::BASIS.parts.azimuths, M), B::BASIS.length(M)) };
    let terms = const { tail(B::BASIS.parts.terms, at(B::BASIS.parts.azimuths, M).terms as usize) };
    let scene = part_mut(scene, place.start as usize..);
    let by = SUM_SHIFT + finer;
    for k in 0..length {
        let mut sums = [half_or_one(k == 0 || (W == 1 && k == length - 1), by); W];
        for (profile, weights) in weights.iter().enumerate() {
            let term = terms.get(profile * length + k).copied().unwrap_or_default();
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = sum.wrapping_add(weigh(term, weight));
            }
        }
        for (sign, sum) in sums.into_iter().enumerate() {
            if let Some(to) = scene.get_mut(sign * length + k) {
                *to = sum >> (by & 31);
            }
        }
    }
    let mut either = [0; W];
    for weights in weights {
        for (either, weight) in either.iter_mut().zip(weights) {
            *either |= weight;
        }
    }
    for (sign, either) in either.into_iter().enumerate() {
        if either == 0 {
            part_mut(scene, sign * length..(sign + 1) * length).fill(0);
        }
    }
}

/// Writes the exponent of a scene.
#[inline(always)]
pub fn finish<const K: usize, const N: usize, const A: usize>(
    coefficients: &Coefficients<K>,
    shifts: &Shifts<A>,
    scene: &mut Scene<'_, [i32; N]>,
) {
    scene.exponent = coefficients.exponent + shifts.bits - TERM_BITS.cast_signed();
}
