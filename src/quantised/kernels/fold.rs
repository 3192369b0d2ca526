//! A new material with every size a constant: the steps of
//! [`Basis::fold_into`](crate::quantised::Basis::fold_into).

use crate::format::{Fixed, Wide};
use crate::quantised::{Material, TransferBuffer};

/// A material's mantissas and exponents of exactly these lengths, if no exponent is above
/// that of a lower o of its parity: then an addend is never larger than the scale that
/// [`Degree::new`] takes from each o by itself.
#[inline(always)]
#[must_use]
pub fn inputs<'a, Q, const B: usize, const O: usize>(
    material: &Material<'a, Q>,
) -> Option<(&'a [Q; B], &'a [i8; O])> {
    let exponents: &[i8; O] = material.exponents.try_into().ok()?;
    let above = exponents.get(2..).unwrap_or_default();
    let falls = exponents.iter().zip(above).all(|(lower, higher)| higher <= lower);
    if falls { Some((material.mantissas.try_into().ok()?, exponents)) } else { None }
}

/// A transfer's numbers and exponents, to be written.
#[inline(always)]
pub fn numbers<Q: Fixed, const T: usize, const E: usize>(
    transfer: &mut TransferBuffer<Q, T, E>,
) -> Option<(&mut [Q; T], &mut [i16; E])> {
    let TransferBuffer { numbers, exponents } = transfer;
    let _ = (numbers.resize_default(T), exponents.resize_default(E));
    Some((numbers.as_mut_slice().try_into().ok()?, exponents.as_mut_slice().try_into().ok()?))
}

/// The coefficients as they are multiplied: those whose o and p are not the `same` over √2.
#[inline(never)]
pub fn coefficients<Q: Fixed, const B: usize>(
    mantissas: &[Q; B],
    same: &'static [bool; B],
) -> [Q::Wide; B] {
    let mut coefficients = [Q::Wide::default(); B];
    for ((&mantissa, &same), to) in mantissas.iter().zip(same).zip(&mut coefficients) {
        *to = if same { mantissa } else { mantissa.over_root_two() }.widen();
    }
    coefficients
}

/// One degree's polar integrals of `P` pairs, and for each o what they are shifted
/// by, less their own exponents and one.
#[derive(Clone, Copy, Debug)]
pub struct Degree<Q: 'static, const P: usize, const O: usize> {
    polar: &'static [Q; P],
    exponents: &'static [i8; P],
    shifts: [i32; O],
    common: i32,
}

impl<Q: Fixed, const P: usize, const O: usize> Degree<Q, P, O> {
    /// The degree `l`.
    #[inline(never)]
    #[must_use]
    pub fn new(
        l: usize,
        polar: &'static [Q],
        exponents: &'static [i8],
        of_orders: &[i8; O],
    ) -> Option<Self> {
        let polar = polar.as_chunks::<P>().0.get(l)?;
        let exponents = exponents.as_chunks::<P>().0.get(l)?;
        // The addends of one sum are one for each o of a parity.
        let room = Q::Wide::of((O as i32 - 1) / 2 + 1).bits().cast_signed() - 1;
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

    /// sum + b Ĉ: of the pair `FROM` and the coefficient `MODE`, whose o is `ORDER`.
    #[inline(always)]
    #[must_use]
    pub fn add<const FROM: usize, const MODE: usize, const ORDER: usize, const B: usize>(
        &self,
        sum: Q::Wide,
        b: &[Q::Wide; B],
    ) -> Q::Wide {
        let Self { polar, exponents, shifts, .. } = self;
        if let (Some(&b), Some(polar), Some(&exponent), Some(&shift)) =
            (b.get(MODE), polar.get(FROM), exponents.get(FROM), shifts.get(ORDER))
        {
            // Not negative: an addend has room.
            return sum + (b * polar.widen()).lowered(shift - i32::from(exponent));
        }
        sum
    }

    /// Brings the sums to full size, and gives their exponent.
    #[inline(never)]
    pub fn normalise(&self, sums: &mut [Q::Wide; P]) -> i32 {
        let mut either = Q::Wide::default();
        for &sum in sums.iter() {
            either = either.max(sum).max(-sum);
        }
        let largest = either.bits();
        let by = Q::BITS.cast_signed() - largest.cast_signed();
        for sum in sums.iter_mut() {
            // A number that rounding brings to 2^BITS is one less.
            *sum = Q::narrow(sum.shifted(by)).widen();
        }
        if largest == 0 { 0 } else { self.common - by }
    }
}

/// The rows of `N` profiles of azimuth `M`, `L` degrees each: their factors start at the
/// row `ROW`, their numbers at `START`, their exponents at `FIRST`.
#[inline(never)]
pub fn azimuth<
    Q: Fixed,
    const M: usize,
    const N: usize,
    const L: usize,
    const ROW: usize,
    const START: usize,
    const FIRST: usize,
    const P: usize,
    const D: usize,
    const F: usize,
    const R: usize,
    const T: usize,
    const E: usize,
>(
    factors: &'static [Q; F],
    factor_exponents: &'static [i8; R],
    sums: &[[Q::Wide; P]; D],
    of_sums: &[i32; D],
    (numbers, exponents): (&mut [Q; T], &mut [i16; E]),
) {
    let mut rows = factors.as_chunks::<P>().0.get(ROW..).unwrap_or_default().iter();
    let mut of_rows = factor_exponents.get(ROW..).unwrap_or_default().iter();
    let numbers = numbers.get_mut(START..).unwrap_or_default().as_chunks_mut::<L>().0;
    let exponents = exponents.get_mut(FIRST..).unwrap_or_default();
    let sums = sums.get(M..).unwrap_or_default();
    let of_sums = of_sums.get(M..).unwrap_or_default();
    for (numbers, exponent) in numbers.iter_mut().zip(exponents).take(N) {
        let mut row = [(Q::Wide::default(), 0); L];
        let given = rows.by_ref().zip(of_rows.by_ref()).zip(sums.iter().zip(of_sums));
        for (to, ((factors, &of_factors), (sums, &of_sums))) in row.iter_mut().zip(given) {
            let mut sum = Q::Wide::default();
            for (factor, &scattered) in factors.iter().zip(sums) {
                sum += factor.widen() * scattered;
            }
            *to = (sum, i32::from(of_factors) + of_sums);
        }
        let common = common_exponent(&row, Q::BITS + 1, Q::BITS);
        *exponent = common as i16;
        for (to, (sum, exponent)) in numbers.iter_mut().zip(row) {
            *to = Q::narrow(sum.shifted(exponent - common));
        }
    }
}

/// The same as that of the general way, bits counted where a number may be the largest.
fn common_exponent<W: Wide, const L: usize>(row: &[(W, i32); L], all: u32, each: u32) -> i32 {
    // Less than any exponent, and no difference overflows.
    const NONE: i32 = -1 << 20;
    let mut top = NONE;
    for &(number, exponent) in row {
        let size = number.max(-number);
        // Below 2^(top - exponent) it is not the largest.
        let room = top - exponent;
        let known = room >= W::SIZE.cast_signed() || (room >= 0 && !size.reaches(room));
        if size != W::default() && !known {
            top = top.max(size.bits().cast_signed() + exponent);
        }
    }
    if top == NONE {
        return 0;
    }
    let room = W::SIZE.cast_signed() - W::of(L as i32).bits().cast_signed() - 2;
    let base = top - room;
    let mut sum = W::default();
    for &(number, exponent) in row {
        let aligned = number.shifted(exponent - base);
        sum += aligned.max(-aligned);
    }
    sum += sum.shifted(-8);
    (base + sum.bits().cast_signed() - all.cast_signed()).max(top - each.cast_signed())
}
