//! Rounds a row of numbers, each with an exponent of its own, to mantissas with a common exponent.

use crate::format::{FixedPoint, Wide};

/// When a row is aligned to its largest exponent, its largest number must have this many bits more
/// than are kept.
const GUARD_BITS: u32 = 5;

/// Writes the mantissas of at most 511 numbers and returns their exponent. The mantissas are at most
/// 2^BITS - 1 in size, and their sizes sum to less than 2^(BITS + 1). It is the least such exponent,
/// except for the 256th that rounding may add.
#[inline]
pub(super) fn settle<Q: FixedPoint>(
    row: impl Iterator<Item = (Q::Wide, i32)> + Clone,
    mantissas: &mut [Q],
) -> i16 {
    let (mut largest, mut top) = (i32::MIN, None);
    row.clone().for_each(|(number, exponent)| {
        largest = largest.max(exponent);
        if number != Q::Wide::default() {
            top = top.max(Some(number.bits().cast_signed() + exponent));
        }
    });
    let Some(top) = top else {
        mantissas.fill(Q::default());
        return 0;
    };
    let count = mantissas.len();
    let at = |reference: i32| row_bits(row.clone(), count, reference, i32::MAX);
    // If no number with the largest exponent is large, align all of them so that they fill their
    // bits.
    let found = at(largest);
    let (reference, found) = if found >= Q::BITS + GUARD_BITS {
        (largest, found)
    } else {
        let reference = top - Q::Wide::SIZE.cast_signed();
        (reference, at(reference))
    };
    let common = reference + found.cast_signed() - Q::BITS.cast_signed();
    for (to, (number, exponent)) in mantissas.iter_mut().zip(row) {
        *to = Q::saturate(number.shifted(exponent - common));
    }
    common as i16
}

/// [`settle`] in fewer instructions if a number with the largest exponent is large.
#[inline(always)]
pub(super) fn settle_large<Q: FixedPoint>(
    row: impl Iterator<Item = (Q::Wide, i32)> + Clone,
    mantissas: &mut [Q],
) -> i16 {
    let largest = row.clone().fold(i32::MIN, |largest, (_, exponent)| largest.max(exponent));
    let found = row_bits(row.clone(), mantissas.len(), largest, 0);
    if found < Q::BITS + GUARD_BITS {
        return settle_small(row, mantissas);
    }
    let common = largest + found.cast_signed() - Q::BITS.cast_signed();
    for (to, (number, exponent)) in mantissas.iter_mut().zip(row) {
        *to = Q::saturate(number.round_shr(common - exponent - 1));
    }
    common as i16
}

/// [`settle`] for a row in which no number with the largest exponent is large.
#[cold]
#[inline(never)]
fn settle_small<Q: FixedPoint>(
    row: impl Iterator<Item = (Q::Wide, i32)> + Clone,
    mantissas: &mut [Q],
) -> i16 {
    settle(row, mantissas)
}

/// The least n such that the sizes of `count` numbers are below 2^n, and their sum, including the
/// error of rounding, is below 2^(n + 1), in units of 2^`reference`. No exponent exceeds `reference`
/// by more than `most`.
#[inline(always)]
fn row_bits<W: Wide>(
    row: impl Iterator<Item = (W, i32)>,
    count: usize,
    reference: i32,
    most: i32,
) -> u32 {
    let count = count as i32;
    // Sizes are shifted right by so many bits that their sum, plus a 256th of it, fits.
    let guard = W::of(count + (count >> 8)).bits();
    let (mut either, mut sum) = (W::default(), W::default());
    row.for_each(|(number, exponent)| {
        let aligned = number.max(-number).floor_shr((exponent - reference).min(most));
        either = either | aligned;
        sum += aligned.floor_shr(-guard.cast_signed());
    });
    // Each size was rounded down.
    let sum = sum + sum.floor_shr(-8) + W::of(count);
    let half = guard - 1;
    sum.max(either.floor_shr(-half.cast_signed())).bits() + half
}
