//! A new material with every size a constant: the steps of
//! [`Basis::fold_into`](crate::quantised::Basis::fold_into).

use crate::format::{Fixed, Wide};
use crate::index::{material, pair};
use crate::quantised::{Material, TransferBuffer};

/// A material's mantissas and exponents of exactly these lengths.
#[inline(always)]
#[must_use]
pub fn inputs<'a, Q, const B: usize, const O: usize>(
    material: &Material<'a, Q>,
) -> Option<(&'a [Q; B], &'a [i8; O])> {
    Some((material.mantissas.try_into().ok()?, material.exponents.try_into().ok()?))
}

/// A transfer's numbers and exponents, to be written.
#[inline(always)]
pub fn numbers<Q: Fixed, const T: usize, const E: usize>(
    transfer: &mut TransferBuffer<Q, T, E>,
) -> Option<(&mut [Q; T], &mut [i16; E])> {
    let TransferBuffer { numbers, exponents } = transfer;
    let _ = (numbers.resize_default(T), exponents.resize_default(E));
    Some((
        numbers.as_mut_slice().try_into().ok()?,
        exponents.as_mut_slice().try_into().ok()?,
    ))
}

/// S, an exponent for each of `D` degrees: `P` pairs, `B` coefficients, `O` orders, from
/// `R` = P D polar integrals.
#[inline(never)]
pub fn scatter<
    Q: Fixed,
    const P: usize,
    const B: usize,
    const O: usize,
    const R: usize,
    const D: usize,
>(
    (mantissas, of_orders): (&[Q; B], &[i8; O]),
    polar: &'static [Q; R],
    polar_exponents: &'static [i8; R],
    sums: &mut [[Q::Wide; P]; D],
    exponents: &mut [i32; D],
) {
    // The addends of one sum are one for each o of a parity.
    let room = Q::Wide::of((O as i32 - 1) / 2 + 1).bits().cast_signed() - 1;
    let mut coefficients = [Q::Wide::default(); B];
    let modes = material::indices(O - 1).zip(mantissas);
    for (((o, p, _), &mantissa), to) in modes.zip(&mut coefficients) {
        *to = if o == p { mantissa } else { mantissa.over_root_two() }.widen();
    }
    let polar = polar.as_chunks::<P>().0.iter().zip(polar_exponents.as_chunks::<P>().0);
    for ((polar, of_polar), (sums, exponent)) in polar.zip(sums.iter_mut().zip(exponents)) {
        // What each pair's polar integral is shifted by, but for the common exponent.
        let mut shifts = [0; P];
        let mut top = i32::MIN;
        let of_pairs = pair::indices(O - 1).zip(of_polar);
        for (((o, _), &of_polar), shift) in of_pairs.zip(&mut shifts) {
            *shift = i32::from(of_orders.get(o).copied().unwrap_or(0)) + i32::from(of_polar);
            top = top.max(*shift);
        }
        let common = top + room;
        *sums = [Q::Wide::default(); P];
        let mut rest = coefficients.as_slice();
        let mut of_o = 0;
        for o in 0..O {
            let mut of_p = first(o % 2);
            for p in (o % 2..=o).step_by(2) {
                for half in 0..=p / 2 {
                    let [b, after @ ..] = rest else { break };
                    rest = after;
                    let of_order = of_orders.get(o).copied().unwrap_or(0);
                    let by = i32::from(of_order) - common;
                    add(sums, (*b, by), polar, of_polar, of_o + half, of_p + half);
                    if o != p {
                        add(sums, (*b, by), polar, of_polar, of_p + half, of_o + half);
                    }
                }
                // The pairs of p and of p + 1.
                of_p += p / 2 + 1 + (p + 1) / 2 + 1;
            }
            of_o += o / 2 + 1;
        }
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
        *exponent = if largest == 0 { 0 } else { common - by };
    }
}

/// The place of the first pair of o.
const fn first(o: usize) -> usize {
    pair::position(o, o % 2)
}

/// sums\[to\] += b Ĉ\[from\], shifted.
#[inline(always)]
fn add<Q: Fixed, const P: usize>(
    sums: &mut [Q::Wide; P],
    (b, by): (Q::Wide, i32),
    polar: &[Q; P],
    of_polar: &[i8; P],
    from: usize,
    to: usize,
) {
    if let (Some(polar), Some(&of_polar), Some(sum)) =
        (polar.get(from), of_polar.get(from), sums.get_mut(to))
    {
        *sum += (b * polar.widen()).shifted(by + i32::from(of_polar));
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
    let mut top = i32::MIN;
    for &(number, exponent) in row {
        let size = number.max(-number);
        // Below 2^(top - exponent) it is not the largest.
        let room = top.saturating_sub(exponent);
        let known = room >= W::SIZE.cast_signed() || (room >= 0 && !size.reaches(room));
        if size != W::default() && !known {
            top = top.max(size.bits().cast_signed() + exponent);
        }
    }
    if top == i32::MIN {
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
