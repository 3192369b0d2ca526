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
        let (order, pairs) = (self.order(), pair::count(self.order()));
        let (effects, all) = (self.parts.effects, self.parts.effects.is_all());
        let polar = rows(self.parts.polar, pairs).zip(rows(self.parts.polar_exponents, pairs));
        for (polar, (sums, exponent)) in polar.zip(rows_mut(sums, pairs).zip(exponents)) {
            let of_orders = material.exponents;
            let common = top(of_orders, |o| above(of_orders, o), polar.1) + room::<Q::Wide>(order);
            let coefficient = |o, p, q| {
                let b = material.mantissas.get(material::position(o, p, q))?;
                let of_order = of_orders.get(o).filter(|_| all || effects.factored(o))?;
                Some((shared(*b, o == p), common - i32::from(*of_order) - 1))
            };
            for q in 0..order + 1 {
                for index in 0..(order - q) / 2 + 1 {
                    let p = q + 2 * index;
                    if let Some(sum) = sums.get_mut(pair::position(p, q)) {
                        *sum = couple((p, q), order, polar, coefficient);
                    }
                }
            }
            *exponent = Q::Wide::of(normalize::<Q>(sums, common));
        }
    }
}

/// The coefficient b_op^q as it is multiplied: divided by √2 unless o and p are equal.
#[inline(always)]
fn shared<Q: FixedPoint>(b: Q, same: bool) -> Q::Wide {
    if same { b } else { b.over_root_two() }.widen()
}

/// The largest exponent of `o` and of all higher orders of the same parity: Ĉ of (o, q) is
/// multiplied by their coefficients.
#[inline(always)]
fn above(of_orders: &[i8], o: usize) -> i8 {
    let above = of_orders.iter().skip(o).step_by(2);
    above.copied().max().unwrap_or(i8::MIN)
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
/// one addend for each o of a parity. It is at least one bit, which [`couple`] needs.
#[inline(always)]
fn room<W: Wide>(order: usize) -> i32 {
    (W::of((order / 2 + 1) as i32).bits().cast_signed() - 1).max(1)
}

/// The sum of one degree for the pair (`to`, `q`). `polar` holds the polar integrals of this degree
/// with their exponents, `coefficient` the coefficient of (o, p, q) and the shift of its products,
/// minus one, before the exponent of the polar integral is subtracted.
#[inline(always)]
fn couple<Q: FixedPoint>(
    (to, q): (usize, usize),
    order: usize,
    (polar, exponents): (&[Q], &[i8]),
    coefficient: impl Fn(usize, usize, usize) -> Option<(Q::Wide, i32)>,
) -> Q::Wide {
    let mut sum = Q::Wide::default();
    for index in 0..(order - q) / 2 + 1 {
        let from = q + 2 * index;
        let (o, p) = if from > to { (from, to) } else { (to, from) };
        let place = pair::position(from, q);
        if let (Some((b, shift)), Some(&polar), Some(&exponent)) =
            (coefficient(o, p, q), polar.get(place), exponents.get(place))
        {
            // The shift is not negative, because an addend has at least one bit of room.
            sum += (b * polar.widen()).round_shr(shift - i32::from(exponent));
        }
    }
    sum
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
        *to = shared(mantissa, same);
    }
    coefficients
}

/// [`above`] of every o.
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
    polar: (&'static [Q; P], &'static [i8; P]),
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
        Some(Self { polar: (polar, exponents), shifts, common })
    }

    /// Writes the sum for the pair (`R`, `S`).
    #[inline(always)]
    pub fn couple<T: Shape<Basis<'static, Q>>, const R: usize, const S: usize, const B: usize>(
        &self,
        b: &[Q::Wide; B],
        sums: &mut [Q::Wide; P],
    ) {
        let coefficient = |o, p, q| {
            let shift = self.shifts.get(o).filter(|_| T::BASIS.parts.effects.factored(o))?;
            Some((*b.get(material::position(o, p, q))?, *shift))
        };
        let (polar, exponents) = self.polar;
        if let Some(sum) = sums.get_mut(pair::position(R, S)) {
            *sum = couple((R, S), O - 1, (polar.as_slice(), exponents), coefficient);
        }
    }

    /// Scales the sums so that they use all bits, and returns their exponent.
    #[inline(never)]
    pub fn normalize(&self, sums: &mut [Q::Wide; P]) -> i32 {
        normalize::<Q>(sums, self.common)
    }
}
