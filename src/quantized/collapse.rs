//! Sums the components of each azimuth into the polynomials of a [`Scene`], in fixed point.

use super::size::{Shifts, base, bits, finer, sizes, weight};
use super::{Basis, Coefficients, Profile, Scene, SceneBuffer};
use crate::buffer::zeros;
use crate::error::{Argument, Error};
use crate::format::FixedPoint;
use crate::invariant::{part_mut, split, split_mut, split_row};
use crate::places::{AzimuthPlace, Shape};

/// The largest |exponent| of coefficients. No light on a material reaches it.
const MAX_EXPONENT: u32 = 1 << 16;

impl<'a, Q: FixedPoint> Basis<'a, Q> {
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
    ) -> Result<Scene<'a, Q, SceneBuffer<N>>, Error> {
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
    ) -> Result<Scene<'a, Q, B>, Error> {
        let sums = buffer.as_mut();
        Error::check(Argument::Scene, self.scene_len(), sums.len())?;
        if mantissas.len() > self.components() {
            let (expected, found) = (self.components(), mantissas.len());
            return Err(Error::Length { argument: Argument::Coefficients, expected, found });
        }
        if exponent.unsigned_abs() > MAX_EXPONENT {
            return Err(Error::Exponent);
        }
        sums.fill(0);
        let bits = self.bits(self.size(mantissas));
        let (mut terms, mut profiles, mut rest) = (self.parts.terms, self.parts.profiles, sums);
        for (azimuth, &length) in self.parts.lengths.iter().enumerate() {
            let (block, others) = of_azimuth(profiles, azimuth);
            profiles = others;
            let [_, step] = any_sizes(mantissas, block);
            let finer = finer(bits, self.bits(step));
            let (base, mut rows) = (base::<Q>(bits) + finer.cast_signed(), terms);
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
                    let weight = if is_minus { of_minus(weight) } else { weight };
                    add_profiles(
                        row,
                        length,
                        &[[weight]],
                        |_, before| before,
                        |sum| sum,
                        polynomial,
                    );
                }
                if either != 0 {
                    let by = Q::SUM_SHIFT + finer;
                    for (k, sum) in polynomial.iter_mut().enumerate() {
                        *sum = sum.wrapping_add(to_round(k, length, azimuth, by)) >> by;
                    }
                }
            }
            terms = rows;
        }
        let to = exponent + bits - Q::TERM_BITS.cast_signed();
        Ok(Scene::of(self.parts.lengths, to, buffer))
    }

    /// The largest irradiance, term or step of an image.
    fn size(&self, mantissas: &[i32]) -> u64 {
        let (mut profiles, mut image, mut largest) = (self.parts.profiles, 0, 0);
        for azimuth in 0..=self.degree() {
            let (block, others) = of_azimuth(profiles, azimuth);
            let [of_azimuth, step] = any_sizes(mantissas, block);
            (image, largest, profiles) = (image + of_azimuth, largest.max(step), others);
        }
        largest.max(image)
    }

    /// [`bits`] for this basis.
    fn bits(&self, largest: u64) -> i32 {
        bits(largest, self.degree())
    }
}

/// The profiles of this azimuth, which come first, and the others.
fn of_azimuth(profiles: &[Profile], azimuth: usize) -> (&[Profile], &[Profile]) {
    let of_azimuth = |profile: &&Profile| usize::from(profile.azimuth) == azimuth;
    let count = profiles.iter().take_while(of_azimuth).count();
    split_row(profiles, count)
}

/// [`sizes`] for profiles of any number.
#[inline(never)]
fn any_sizes(mantissas: &[i32], profiles: &[Profile]) -> [u64; 2] {
    sizes(mantissas, profiles)
}

/// The weight of -m: Φ_-m = √2 sin(-mβ) = -√2 Im (n_x + i n_y)^m / sin^m.
#[inline(always)]
fn of_minus(weight: i32) -> i32 {
    weight.wrapping_neg()
}

/// Writes the sums of the terms of `P` profiles, each times its weights, to `W` polynomials of this
/// length. A sum begins with `first` of the number of its term and of what is there, and ends as
/// `last` of the sum.
#[inline(always)]
fn add_profiles<Q: FixedPoint, const W: usize, const P: usize>(
    terms: &[Q],
    length: usize,
    weights: &[[i32; W]; P],
    first: impl Fn(usize, i32) -> i32,
    last: impl Fn(i32) -> i32,
    polynomials: &mut [i32],
) {
    let (Some(terms), Some(polynomials)) =
        (terms.get(..P * length), polynomials.get_mut(..W * length))
    else {
        return;
    };
    for k in 0..length {
        let mut sums = [0; W];
        for (sign, sum) in sums.iter_mut().enumerate() {
            *sum = first(k, polynomials.get(sign * length + k).copied().unwrap_or(0));
        }
        for (profile, weights) in weights.iter().enumerate() {
            let term = terms.get(profile * length + k).copied().unwrap_or_default();
            for (sum, &weight) in sums.iter_mut().zip(weights) {
                *sum = sum.wrapping_add(term.weigh(weight));
            }
        }
        for (sign, sum) in sums.into_iter().enumerate() {
            if let Some(to) = polynomials.get_mut(sign * length + k) {
                *to = last(sum);
            }
        }
    }
}

/// The number added to a sum before it is shifted: half a unit to round it to the nearest, otherwise
/// one unit.
///
/// A step of Horner's rule rounds down, by half a unit on average, so every term that is added to
/// such a step is rounded up by as much. The first term is not added to any step, and the last term
/// of m = 0 is added to a step that is not rounded.
#[inline(always)]
fn to_round(k: usize, length: usize, azimuth: usize, by: u32) -> i32 {
    let nearest = k == 0 || (azimuth == 0 && k == length - 1);
    (1 << by) >> u32::from(nearest)
}

/// The terms of a scene, to be filled for this basis.
#[inline(always)]
pub fn terms<'s, 'a, Q: FixedPoint, const N: usize>(
    basis: &Basis<'a, Q>,
    scene: &'s mut Scene<'a, Q, SceneBuffer<N>>,
) -> Option<&'s mut [i32; N]> {
    scene.lengths = basis.parts.lengths;
    scene.buffer.filled()
}

/// The mantissas of exactly `K` coefficients, if [`Basis::collapse_into`] accepts their exponent.
#[inline(always)]
#[must_use]
pub fn mantissas<const K: usize>(coefficients: &Coefficients<K>) -> Option<&[i32; K]> {
    if coefficients.exponent.unsigned_abs() > MAX_EXPONENT {
        return None;
    }
    coefficients.mantissas.as_slice().try_into().ok()
}

/// Writes the polynomials of azimuth `M`, which has `P` profiles.
#[inline(always)]
pub fn azimuth<
    B: Shape<Basis<'static, Q>>,
    Q: FixedPoint,
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
    let finer = shifts.finer(M);
    let weight = |component: u16, exponent| {
        let d = d.get(usize::from(component)).copied().unwrap_or(0);
        shifts.weight::<Q>(d, exponent, finer)
    };
    let profiles = const { profiles::<B, Q, P>(M) };
    if M == 0 {
        let weights = profiles.map(|profile| [weight(profile.plus, profile.exponent)]);
        write::<B, Q, M, 1, P, N>(&weights, finer, scene);
    } else {
        let weights = profiles.map(|Profile { plus, minus, exponent, .. }| {
            [weight(plus, exponent), of_minus(weight(minus, exponent))]
        });
        write::<B, Q, M, 2, P, N>(&weights, finer, scene);
    }
}

/// The `P` profiles of an azimuth.
#[expect(clippy::panic, reason = "while the program is compiled")]
const fn profiles<B: Shape<Basis<'static, Q>>, Q: 'static, const P: usize>(
    azimuth: usize,
) -> &'static [Profile; P] {
    match B::BASIS.profiles_at(&B::BASIS.azimuth_at(azimuth)).first_chunk() {
        Some(profiles) => profiles,
        None => panic!("the azimuth has fewer profiles"),
    }
}

/// Writes the polynomials of azimuth `M`, with weights for `W` polynomials each. The weights are
/// `finer` by that many bits.
///
/// Not inlined: a compiler that sees several azimuths at once runs out of registers.
#[inline(never)]
fn write<
    B: Shape<Basis<'static, Q>>,
    Q: FixedPoint,
    const M: usize,
    const W: usize,
    const P: usize,
    const N: usize,
>(
    weights: &[[i32; W]; P],
    finer: u32,
    scene: &mut [i32; N],
) {
    let AzimuthPlace { start, length, .. } = const { B::BASIS.azimuth_at(M) };
    let terms = const { B::BASIS.parts.terms.split_at(B::BASIS.azimuth_at(M).terms).1 };
    let scene = part_mut(scene, start..);
    let by = Q::SUM_SHIFT + finer;
    let first = |k, _| to_round(k, length, M, by);
    add_profiles(terms, length, weights, first, |sum| sum >> (by & 31), scene);
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
pub fn finish<'a, Q: FixedPoint, const K: usize, const N: usize, const A: usize>(
    coefficients: &Coefficients<K>,
    shifts: &Shifts<A>,
    scene: &mut Scene<'a, Q, SceneBuffer<N>>,
) {
    scene.exponent = coefficients.exponent + shifts.bits - Q::TERM_BITS.cast_signed();
}
