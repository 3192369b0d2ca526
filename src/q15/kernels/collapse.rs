//! Collapses a scene with all sizes constant: the steps of
//! [`Basis::collapse_into`](crate::q15::Basis::collapse_into), azimuth by azimuth.

use crate::checked_slice::part_mut;
use crate::q15::arithmetic::{SUM_SHIFT, TERM_BITS, weigh};
use crate::q15::scene::{FINEST, Scene, bits_of, half_or_one, size, with_margin};
use crate::q15::{Basis, Coefficients, Profile, scene};
use crate::specialized::{KnownTable, at, head, tail};

/// A scene of this basis, all zero.
#[inline(always)]
pub const fn blank_scene<'a, const N: usize>(basis: &Basis<'a>) -> Scene<'a, [i32; N]> {
    Scene { lengths: basis.parts.lengths, exponent: 0, buffer: [0; N] }
}

/// The terms of a scene.
#[inline(always)]
pub const fn terms<'s, const N: usize>(scene: &'s Scene<'_, [i32; N]>) -> &'s [i32; N] {
    &scene.buffer
}

/// The terms of a scene, to be overwritten.
#[inline(always)]
pub const fn terms_mut<'s, const N: usize>(scene: &'s mut Scene<'_, [i32; N]>) -> &'s mut [i32; N] {
    &mut scene.buffer
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

    /// The shifts of this table. `None` if there is hardly an image, or if weights that are coarser
    /// than d would have to be shifted left, or right by more bits than they have.
    #[inline(never)]
    pub fn shifts<B: KnownTable<Basis<'static>>>(&self) -> Option<Shifts<A>> {
        let [least, largest] = const { exponents(B::BASIS.parts.profiles) };
        let most = self.steps.iter().copied().fold(self.image, u32::max);
        let bits = bits_of(most.into());
        let base = -scene::base(bits);
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
pub fn azimuth<
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
        sum::<B, M, 1, P, N>(&weights, finer, scene);
    } else {
        // Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
        let weights = profiles.map(|Profile { plus, minus, exponent, .. }| {
            [weight(plus, exponent), -weight(minus, exponent)]
        });
        sum::<B, M, 2, P, N>(&weights, finer, scene);
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
fn sum<B, const M: usize, const W: usize, const P: usize, const N: usize>(
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
