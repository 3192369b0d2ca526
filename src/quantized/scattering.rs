//! Combines the material with the polar integrals in fixed point, one degree after the other:
//! S_l,pq = Σ_o B_op^q Ĉ_lo^q.

use super::{Basis, Material};
use crate::format::{FixedPoint, Wide};
use crate::index::{material, pair};
use crate::invariant::split_row;
use crate::lanes::{rows, rows_mut};
use crate::places::Shape;

/// The exponent of zeros, less than that of any number.
const ZERO_EXPONENT: i32 = -1 << 12;

impl<Q: FixedPoint> Basis<'_, Q> {
    /// Writes S: for each l a row over the pairs (p, q), with numbers of at most 2^BITS, and the
    /// exponent of the row.
    pub(super) fn scatter(
        &self,
        material: &Material<'_, Q>,
        sums: &mut [Q::Wide],
        exponents: &mut [Q::Wide],
    ) {
        let pairs = pair::count(self.order());
        let (effects, all) = (self.parts.effects, self.parts.effects.is_all());
        let of_orders = material.exponents;
        let polar = rows(self.parts.polar, pairs).zip(rows(self.parts.polar_exponents, pairs));
        for ((polar, of_polar), (sums, exponent)) in polar.zip(rows_mut(sums, pairs).zip(exponents))
        {
            let top = top(of_orders, |o| above(of_orders, o), of_polar);
            let common = top + room::<Q::Wide>(self.order());
            sums.fill(Q::Wide::default());
            let coefficients = material::indices(material.order).zip(material.mantissas);
            for ((o, p, q), &b) in coefficients {
                if !all && !effects.factored(o) {
                    continue;
                }
                let b = factor(b, o == p);
                let shift = common - of_orders.get(o).copied().map_or(0, i32::from) - 1;
                let (of_o, of_p) = (pair::position(o, q), pair::position(p, q));
                let mut add = |from: usize, to: usize| {
                    if let (Some(&polar), Some(&exponent), Some(sum)) =
                        (polar.get(from), of_polar.get(from), sums.get_mut(to))
                    {
                        *sum += addend(b, polar, shift - i32::from(exponent));
                    }
                };
                add(of_o, of_p);
                if o != p {
                    add(of_p, of_o);
                }
            }
            *exponent = Q::Wide::of(normalize::<Q>(sums, common));
        }
    }
}

/// The coefficient b_op^q as it is multiplied: divided by √2 unless o and p are equal.
#[inline(always)]
fn factor<Q: FixedPoint>(b: Q, same: bool) -> Q::Wide {
    if same { b } else { b.over_root_two() }.widen()
}

/// The largest exponent of `o` and of all higher orders of the same parity: Ĉ of (o, q) is
/// multiplied by their coefficients.
#[inline(always)]
fn above(of_orders: &[i8], o: usize) -> i8 {
    let (mut largest, mut next) = (i8::MIN, o);
    while let Some(&exponent) = of_orders.get(next) {
        (largest, next) = (largest.max(exponent), next + 2);
    }
    largest
}

/// The largest exponent of an addend of S.
#[inline(always)]
fn top(of_orders: &[i8], above: impl Fn(usize) -> i8, of_polar: &[i8]) -> i32 {
    let (mut top, mut rest) = (i32::MIN, of_polar);
    for o in 0..of_orders.len() {
        let (of_o, others) = split_row(rest, o / 2 + 1);
        rest = others;
        let largest = of_o.iter().copied().max().unwrap_or(i8::MIN);
        top = top.max(i32::from(above(o)) + i32::from(largest));
    }
    top
}

/// The number of bits by which the addends of S are shifted right so that their sum fits. There is
/// one addend for each o of a parity. It is at least one bit, which [`addend`] needs.
#[inline(always)]
fn room<W: Wide>(order: usize) -> i32 {
    (W::of((order / 2 + 1) as i32).bits().cast_signed() - 1).max(1)
}

/// b Ĉ / 2^(`by` + 1). The shift is not negative, because an addend has at least one bit of room.
#[inline(always)]
fn addend<Q: FixedPoint>(b: Q::Wide, polar: Q, by: i32) -> Q::Wide {
    (b * polar.widen()).round_shr(by)
}

/// Scales sums so that they use all bits, and returns their exponent.
#[inline(always)]
fn normalize<Q: FixedPoint>(sums: &mut [Q::Wide], common: i32) -> i32 {
    let either = sums.iter().fold(Q::Wide::default(), |either, &sum| either | sum.max(-sum));
    let largest = either.bits();
    if largest == 0 {
        return ZERO_EXPONENT;
    }
    let by = Q::BITS.cast_signed() - largest.cast_signed();
    if by < 0 {
        for sum in sums.iter_mut() {
            *sum = sum.round_shr(-by - 1);
        }
    } else {
        for sum in sums.iter_mut() {
            *sum = sum.floor_shr(by);
        }
    }
    common - by
}

/// The coefficients as they are multiplied.
#[inline(never)]
pub fn coefficients<Q: FixedPoint, const B: usize>(mantissas: &[Q; B]) -> [Q::Wide; B] {
    let mut coefficients = [Q::Wide::default(); B];
    let same = const { &same::<B>() };
    for ((&mantissa, &same), to) in mantissas.iter().zip(same).zip(&mut coefficients) {
        *to = factor(mantissa, same);
    }
    coefficients
}

/// `above` of every o.
#[inline(never)]
pub fn all_above<const O: usize>(of_orders: &[i8; O]) -> [i8; O] {
    core::array::from_fn(|o| above(of_orders, o))
}

/// For each coefficient, whether o and p are equal.
const fn same<const B: usize>() -> [bool; B] {
    let (mut same, mut mode) = ([false; B], (0, 0, 0));
    let mut rest = same.as_mut_slice();
    while let [to, others @ ..] = rest {
        *to = mode.0 == mode.1;
        (rest, mode) = (others, material::following(mode));
    }
    same
}

/// The polar integrals of `P` pairs for one degree of a table `T`. For each o, `shifts` holds the
/// shift of its products, minus one, before the exponents of the polar integrals are subtracted.
#[derive(Clone, Copy, Debug)]
pub struct Degree<Q: 'static, const P: usize, const O: usize> {
    polar: &'static [Q; P],
    exponents: &'static [i8; P],
    shifts: [i32; O],
    common: i32,
}

impl<Q: FixedPoint, const P: usize, const O: usize> Degree<Q, P, O> {
    /// Prepares the degree `l`, for these exponents of the material and their [`all_above`].
    #[inline(never)]
    #[must_use]
    pub fn new<T: Shape<Basis<'static, Q>>>(
        l: usize,
        [of_orders, above]: [&[i8; O]; 2],
    ) -> Option<Self> {
        let polar = T::BASIS.parts.polar.as_chunks::<P>().0.get(l)?;
        let exponents = T::BASIS.parts.polar_exponents.as_chunks::<P>().0.get(l)?;
        let above = |o| above.get(o).copied().unwrap_or(i8::MIN);
        let common = top(of_orders, above, exponents) + room::<Q::Wide>(O - 1);
        let shifts = of_orders.map(|of_order| common - i32::from(of_order) - 1);
        Some(Self { polar, exponents, shifts, common })
    }

    /// sum + b Ĉ of the order `L` for the pair (`R`, `S`).
    #[inline(always)]
    #[must_use]
    pub fn add<const R: usize, const S: usize, const L: usize, const B: usize>(
        &self,
        sum: Q::Wide,
        b: &[Q::Wide; B],
    ) -> Q::Wide {
        let Self { polar, exponents, shifts, .. } = self;
        let (o, p) = if L > R { (L, R) } else { (R, L) };
        let (from, mode) = (pair::position(L, S), material::position(o, p, S));
        if let (Some(&b), Some(&polar), Some(&exponent), Some(&shift)) =
            (b.get(mode), polar.get(from), exponents.get(from), shifts.get(o))
        {
            return sum + addend(b, polar, shift - i32::from(exponent));
        }
        sum
    }

    /// Scales the sums so that they use all bits, and returns their exponent.
    #[inline(never)]
    pub fn normalize(&self, sums: &mut [Q::Wide; P]) -> i32 {
        normalize::<Q>(sums, self.common)
    }
}
