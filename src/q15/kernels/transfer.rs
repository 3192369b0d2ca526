//! Computes the transfer of a new material with all sizes constant: the steps of
//! [`Basis::transfer_into`](crate::q15::Basis::transfer_into).

use crate::checked_slice::{part, part_mut};
use crate::index::{material, pair};
use crate::q15::arithmetic::{BITS, Shift as _, over_root_two};
use crate::q15::transfer::{GUARD_BITS, ZERO_EXPONENT, guard, room, row_bits};
use crate::q15::{Basis, Material, Q15, TransferBuffer, transfer};
use crate::specialized::{KnownTable, at};

/// The mantissas and exponents of a material, of exactly these lengths. `None` if an exponent
/// exceeds the exponent of a lower o of the same parity. Otherwise no addend exceeds the scale that
/// [`Degree::new`] derives from each o alone.
#[inline(always)]
pub fn inputs<'a, const B: usize, const O: usize>(
    material: &Material<'a>,
) -> Option<(&'a [Q15; B], &'a [i8; O])> {
    let exponents: &[i8; O] = material.exponents.try_into().ok()?;
    let falls = exponents.iter().zip(exponents.iter().skip(2)).all(|(low, high)| high <= low);
    if falls { Some((material.mantissas.try_into().ok()?, exponents)) } else { None }
}

/// The numbers and exponents of a transfer, to be filled.
#[inline(always)]
pub fn numbers<const T: usize, const E: usize>(
    transfer: &mut TransferBuffer<T, E>,
) -> Option<(&mut [Q15; T], &mut [i16; E])> {
    let TransferBuffer { numbers, exponents } = transfer;
    Some((numbers.filled()?, exponents.filled()?))
}

/// The coefficients as they are multiplied: divided by √2 unless o and p are equal.
#[inline(never)]
pub fn coefficients<const B: usize>(mantissas: &[Q15; B]) -> [i32; B] {
    let mut coefficients = [0; B];
    let same = const { &same::<B>() };
    for ((&mantissa, &same), to) in mantissas.iter().zip(same).zip(&mut coefficients) {
        *to = if same { mantissa } else { over_root_two(mantissa) }.get();
    }
    coefficients
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

/// The polar integrals of `P` pairs for one degree. For each o, `shifts` holds the shift of its
/// products, minus one, before their own exponents are subtracted.
#[derive(Clone, Copy, Debug)]
pub struct Degree<const P: usize, const O: usize> {
    polar: &'static [Q15; P],
    exponents: &'static [i8; P],
    shifts: [i32; O],
    common: i32,
}

impl<const P: usize, const O: usize> Degree<P, O> {
    /// Prepares the degree `l`.
    #[inline(never)]
    pub fn new<T: KnownTable<Basis<'static>>>(l: usize, of_orders: &[i8; O]) -> Option<Self> {
        let polar = T::BASIS.parts.polar.as_chunks::<P>().0.get(l)?;
        let exponents = T::BASIS.parts.polar_exponents.as_chunks::<P>().0.get(l)?;
        let room = room(O - 1);
        let mut rest = exponents.as_slice();
        let mut top = i32::MIN;
        for (o, &of_order) in of_orders.iter().enumerate() {
            let (of_o, after) = rest.split_at_checked(o / 2 + 1)?;
            rest = after;
            let largest = of_o.iter().copied().max().unwrap_or(i8::MIN);
            top = top.max(i32::from(of_order) + i32::from(largest));
        }
        let common = top + room;
        let shifts = of_orders.map(|of_order| common - i32::from(of_order) - 1);
        Some(Self { polar, exponents, shifts, common })
    }

    /// sum + b Ĉ of the order `L` for the pair (`R`, `S`).
    #[inline(always)]
    pub fn add<const R: usize, const S: usize, const L: usize, const B: usize>(
        &self,
        sum: i32,
        b: &[i32; B],
    ) -> i32 {
        let Self { polar, exponents, shifts, .. } = self;
        let (o, p) = if L > R { (L, R) } else { (R, L) };
        let (from, mode) = (pair::position(L, S), material::position(o, p, S));
        if let (Some(&b), Some(polar), Some(&exponent), Some(&shift)) =
            (b.get(mode), polar.get(from), exponents.get(from), shifts.get(o))
        {
            // The shift is not negative, because an addend has at least one bit of room.
            return sum + (b * polar.get()).round_shr(shift - i32::from(exponent));
        }
        sum
    }

    /// Scales the sums so that they use all bits, and returns their exponent.
    #[inline(never)]
    pub fn normalize(&self, sums: &mut [i32; P]) -> i32 {
        let mut either = 0;
        for &sum in sums.iter() {
            either |= sum.max(-sum);
        }
        let largest = either.bits();
        let by = BITS.cast_signed() - largest.cast_signed();
        if largest == 0 {
            return ZERO_EXPONENT;
        }
        if by < 0 {
            sums.iter_mut().for_each(|sum| *sum = sum.round_shr(-by - 1));
        } else {
            sums.iter_mut().for_each(|sum| *sum = sum.floor_shr(by));
        }
        self.common - by
    }
}

/// Computes the rows of the profiles of azimuth `M`, with `L` degrees each.
#[inline(never)]
pub fn azimuth<
    B: KnownTable<Basis<'static>>,
    const M: usize,
    const L: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const E: usize,
>(
    sums: &[[i32; P]; D],
    of_sums: &[i32; D],
    (numbers, exponents): (&mut [Q15; T], &mut [i16; E]),
) {
    let place = const { *at(B::BASIS.parts.azimuths, M) };
    let (first, before) = (usize::from(place.first), place.rows as usize);
    let parts = const { &B::BASIS.parts };
    let rows = part(parts.factors.as_chunks::<P>().0, before..);
    let of_rows = part(parts.factor_exponents, before..);
    let rows = rows.as_chunks::<L>().0.iter().zip(of_rows.as_chunks::<L>().0);
    let numbers = part_mut(numbers, before..).as_chunks_mut::<L>().0;
    let exponents = part_mut(exponents, first..);
    let sums = part(sums, M..);
    let of_sums = part(of_sums, M..);
    for (((rows, of_rows), numbers), exponent) in
        rows.zip(numbers).zip(exponents).take(place.profiles.into())
    {
        let mut row = [0; L];
        for ((place, factors), sums) in row.iter_mut().zip(rows).zip(sums) {
            *place = product(factors, sums);
        }
        *exponent = settle(&row, of_rows, of_sums, numbers);
    }
}

/// [`transfer::product`] over all pairs.
#[inline(never)]
fn product<const P: usize>(factors: &[Q15; P], sums: &[i32; P]) -> i32 {
    transfer::product(factors, sums)
}

/// Rounds a row to mantissas as the general code does, and returns its exponent.
#[inline(never)]
fn settle<const L: usize>(
    row: &[i32; L],
    of_factors: &[i8; L],
    of_sums: &[i32],
    numbers: &mut [Q15; L],
) -> i16 {
    let mut exponents = [0; L];
    let mut largest = i32::MIN;
    for ((exponent, &of_factors), of_sums) in exponents.iter_mut().zip(of_factors).zip(of_sums) {
        *exponent = i32::from(of_factors) + of_sums;
        largest = largest.max(*exponent);
    }
    let guard = guard(L as i32);
    let (mut either, mut sum) = (0, 0);
    for (&number, exponent) in row.iter().zip(exponents) {
        let aligned = number.max(-number).floor_shr((exponent - largest).min(0));
        either |= aligned;
        sum += aligned.floor_shr(-guard.cast_signed());
    }
    let found = row_bits(either, sum, L as i32, guard);
    if found < BITS + GUARD_BITS {
        return settle_small(row, &exponents, numbers);
    }
    let common = largest + found.cast_signed() - BITS.cast_signed();
    for ((to, number), exponent) in numbers.iter_mut().zip(row).zip(exponents) {
        *to = Q15::saturate(number.round_shr(common - exponent - 1));
    }
    common as i16
}

/// [`settle`] for a row in which no number with the largest exponent is large.
#[cold]
#[inline(never)]
fn settle_small(row: &[i32], exponents: &[i32], numbers: &mut [Q15]) -> i16 {
    transfer::settle(row.iter().copied().zip(exponents.iter().copied()), numbers)
}
