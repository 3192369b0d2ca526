//! Relights with all sizes constant: the steps of
//! [`Basis::relight_into`](crate::quantized::Basis::relight_into), azimuth by azimuth.

use crate::format::{FixedPoint, Wide as _};
use crate::index::light::position;
use crate::quantized::{Coefficients, Light, Transfer};

/// The size of an empty sum. It is less than any other, and no difference from it overflows.
pub const NONE: i32 = -1 << 20;

/// The numbers of a transfer and of a light, of exactly these lengths. `None` unless the rows of
/// the transfer are known to fit their accumulators.
#[inline(always)]
#[must_use]
pub fn inputs<'a, Q, const T: usize, const P: usize, const N: usize>(
    transfer: &Transfer<'a, Q>,
    light: &Light<'a, Q>,
) -> Option<(&'a [Q; T], &'a [i16; P], &'a [Q; N])> {
    if !transfer.bounded {
        return None;
    }
    Some((
        transfer.numbers.try_into().ok()?,
        transfer.exponents.try_into().ok()?,
        light.mantissas.try_into().ok()?,
    ))
}

/// The mantissas of the coefficients of an image, to be filled.
#[inline(always)]
pub fn mantissas<const K: usize>(coefficients: &mut Coefficients<K>) -> Option<&mut [i32; K]> {
    coefficients.mantissas.filled()
}

/// Computes the sums of `P` profiles of azimuth `M` for the components of +m and -m. Each profile
/// has a row of `D` numbers from `START` on, and the exponents begin at `FIRST`. Returns the larger
/// of `top` and the largest size of these sums.
///
/// Not inlined: several copies in one function need too many addresses.
#[inline(never)]
pub fn azimuth<
    Q: FixedPoint,
    const M: usize,
    const START: usize,
    const FIRST: usize,
    const P: usize,
    const D: usize,
    const T: usize,
    const E: usize,
    const N: usize,
    const K: usize,
>(
    (numbers, exponents, light): (&[Q; T], &[i16; E], &[Q; N]),
    components: &'static [[u16; 2]; P],
    mantissas: &mut [i32; K],
    top: i32,
) -> i32 {
    let mut top = top;
    let rows = numbers.get(START..).unwrap_or_default().as_chunks::<D>().0;
    let exponents = exponents.get(FIRST..).unwrap_or_default();
    for ((row, &[of_plus, of_minus]), &exponent) in rows.iter().zip(components).zip(exponents) {
        let (mut plus, mut minus) = (Q::Wide::default(), Q::Wide::default());
        for (l, number) in (M..).zip(row) {
            let order = M.cast_signed();
            let at = |order| light.get(position(l, order)).copied().unwrap_or_default().widen();
            let number = number.widen();
            // The sums may wrap for a transfer of another basis, but must not panic.
            plus = plus.wrapping_plus(number * at(order));
            if M > 0 {
                minus = minus.wrapping_plus(number * at(-order));
            }
        }
        let minus = if M % 2 == 1 { minus.wrapping_minus() } else { minus };
        let mut either = 0;
        for (component, sum) in [(of_plus, plus), (of_minus, minus)] {
            if let Some(place) = mantissas.get_mut(usize::from(component)) {
                // Keep the upper 31 bits.
                *place = sum.shifted(31 - Q::Wide::SIZE.cast_signed()).saturated();
                either |= place.unsigned_abs();
            }
        }
        // Count the bits only if they may exceed `top`.
        let room = top - i32::from(exponent);
        if room < 0 || (room < 31 && either >> (room & 31) != 0) {
            top = counted(either, exponent).max(top);
        }
    }
    top
}

/// The size of the sums of a profile.
#[inline(never)]
fn counted(either: u32, exponent: i16) -> i32 {
    if either == 0 {
        return NONE;
    }
    let bits = u32::BITS - either.leading_zeros();
    bits.cast_signed() + i32::from(exponent)
}

/// The common exponent of all components.
#[inline(always)]
#[must_use]
pub const fn common(top: i32) -> i32 {
    if top == NONE { 0 } else { top - 30 }
}

/// Shifts the components of profile number `AT` to the common exponent.
#[inline(always)]
pub fn align<
    const AT: usize,
    const PLUS: usize,
    const MINUS: usize,
    const E: usize,
    const K: usize,
>(
    exponents: &[i16; E],
    common: i32,
    d: &mut [i32; K],
) {
    let by = i32::from(exponents.get(AT).copied().unwrap_or(0)) - common;
    for component in [PLUS, MINUS] {
        if let Some(place) = d.get_mut(component) {
            let twice = *place >> (-by - 1).clamp(0, 31);
            let rounded = (twice >> 1) + (twice & 1);
            *place = if by < 0 { rounded } else { *place << by.min(31) };
        }
    }
}

/// Writes the exponent of the coefficients of an image.
#[inline(always)]
pub fn finish<Q: FixedPoint, const K: usize>(
    coefficients: &mut Coefficients<K>,
    common: i32,
    of_light: i32,
) {
    coefficients.exponent = common + of_light + Q::Wide::SIZE.cast_signed() - 31;
}
