//! The arithmetic of 15-bit mantissas: products, sums and shifts, how many bits each has, and
//! mantissas with a common exponent.

use super::Q15;

/// Number of bits by which a scene's weights are finer than its terms.
pub(crate) const WEIGHT_BITS: u32 = 14;
/// Number of bits by which a sum of weighted terms is finer than a scene's terms: as many.
pub(crate) const SUM_SHIFT: u32 = WEIGHT_BITS;
/// Bits of the magnitude at each step of a pixel's polynomials, and of its irradiance.
pub(crate) const TERM_BITS: u32 = 17;
/// Bits of a mantissa's magnitude.
pub(crate) const BITS: u32 = Q15::BITS;

/// Shifts of signed integers that round.
pub(crate) trait Shift: Copy {
    /// Number of bits of |self|: the smallest n with |self| < 2^n.
    fn bits(self) -> u32;
    /// The integer nearest to self 2^`by`. Domain: it fits.
    fn shifted(self, by: i32) -> Self;
    /// floor(self 2^`by`): a shift to the right if `by` is negative. Domain: it fits.
    fn floor_shr(self, by: i32) -> Self;
    /// The integer nearest to self / 2^(`by` + 1). Domain: `by` >= 0, self is not the largest.
    fn round_shr(self, by: i32) -> Self;
}

macro_rules! shift {
    ($integer:ident, $size:literal) => {
        impl Shift for $integer {
            #[inline]
            fn bits(self) -> u32 {
                $size + 1 - self.unsigned_abs().leading_zeros()
            }
            #[inline]
            fn shifted(self, by: i32) -> Self {
                match by {
                    0.. => {
                        let fits = self == 0 || self.bits().cast_signed() + by <= $size;
                        debug_assert!(fits, "out of domain");
                        self << by.min($size)
                    }
                    _ if by >= -$size => (self >> -by) + ((self >> (-by - 1)) & 1),
                    _ => 0,
                }
            }
            #[inline(always)]
            fn floor_shr(self, by: i32) -> Self {
                if by >= 0 { self << by.min($size) } else { self >> (-by).min($size) }
            }
            #[inline(always)]
            fn round_shr(self, by: i32) -> Self {
                debug_assert!(by >= 0, "out of domain");
                // A shift by all bits gives 0 or -1, both of which round to 0.
                ((self >> by.cast_unsigned().min($size)) + 1) >> 1
            }
        }
    };
}
shift!(i32, 31);
shift!(i64, 63);

/// The nearest `i32`.
#[inline]
pub(crate) fn saturated(number: i64) -> i32 {
    number.clamp((-i32::MAX).into(), i32::MAX.into()) as i32
}

/// The product of two complex numbers of magnitude 1 and thereabouts, in fractions of 2^30: from
/// halves of 15 bits, without the low product, because small processors have no longer products.
#[inline(always)]
pub(crate) fn rotated([c, s]: [i32; 2], [cosine, sine]: [i32; 2]) -> [i32; 2] {
    let halves = |number: i32| [number >> 15, number & 0x7fff];
    let ([c, c_low], [s, s_low]) = (halves(c), halves(s));
    let ([cosine, cosine_low], [sine, sine_low]) = (halves(cosine), halves(sine));
    let low = |a: i32, b: i32| a.wrapping_add(b) >> 15;
    [
        c * cosine - s * sine
            + low(c * cosine_low, -(s * sine_low))
            + low(c_low * cosine, -(s_low * sine)),
        s * cosine
            + c * sine
            + low(s * cosine_low, c * sine_low)
            + low(s_low * cosine, c_low * sine),
    ]
}

/// The mantissa of the low bits of a number.
#[inline(always)]
pub(crate) fn truncated(number: i32) -> Q15 {
    Q15(number as i16)
}

/// A mantissa / √2, rounded.
#[inline]
pub(crate) fn over_root_two(mantissa: Q15) -> Q15 {
    Q15::saturate((mantissa.get() * 23_170 + (1 << 14)) >> 15)
}

/// `weight` times a mantissa, [`SUM_SHIFT`] bits finer than a term; modulo 2^32.
#[inline(always)]
pub(crate) fn weigh(mantissa: Q15, weight: i32) -> i32 {
    weight.wrapping_mul(mantissa.get())
}

/// floor(sum t), where t is `argument` as a fraction of 2^14. Domain: |sum| < 2^[`TERM_BITS`],
/// |t| <= 1.
#[inline(always)]
pub(crate) fn argument_times(sum: i32, argument: i32) -> i32 {
    sum.wrapping_mul(argument) >> 14
}

/// The same as [`argument_times`], rounded to the nearest integer.
#[inline(always)]
pub(crate) fn nearest_argument_times(sum: i32, argument: i32) -> i32 {
    sum.wrapping_mul(argument).wrapping_add(1 << 13) >> 14
}

/// 2z - 1 as a fraction of 2^14. Domain: z >= 0.
#[inline(always)]
pub(crate) fn argument(z: Q15) -> i32 {
    z.get() - (1 << 14)
}

/// A mantissa as a fraction of 2^14.
#[inline(always)]
pub(crate) fn halved(mantissa: Q15) -> i32 {
    (mantissa.get() + 1) >> 1
}

/// a x + b y, rounded, where a and b are fractions of 2^14. Domain: a² + b² at most 2, x² + y² at
/// most 1.001, which a [`Normal`](super::Normal) satisfies.
#[inline(always)]
pub(crate) fn dot(a: i32, x: Q15, b: i32, y: Q15) -> i32 {
    (a * x.get() + b * y.get() + (1 << 14)) >> 15
}

/// `value` times `fraction`, a fraction of 2^14; modulo 2^32.
#[inline(always)]
pub(crate) fn product(value: i32, fraction: i32) -> i32 {
    value.wrapping_mul(fraction)
}

/// `value` on the scale of a [`product`].
#[inline(always)]
pub(crate) fn of_value(value: i32) -> i32 {
    value << 14
}

/// Rounds a sum of [`product`]s. Intermediate sums may wrap if the final one fits.
#[inline(always)]
pub(crate) fn sum(sum: i32) -> i32 {
    ((sum >> 13) + 1) >> 1
}

/// `value` times a mantissa, modulo 2^32.
#[inline(always)]
pub(crate) fn times(mantissa: Q15, value: i32) -> i32 {
    value.wrapping_mul(mantissa.get())
}

/// floor(sum / 2^15): the integer part of a sum of products with mantissas.
#[inline(always)]
pub(crate) fn whole(sum: i32) -> i32 {
    sum >> 15
}

/// Rounds numbers with exponents of their own to mantissas, and returns the common exponent.
#[inline(always)]
pub(crate) fn settle(row: impl Iterator<Item = (i32, i32)> + Clone, numbers: &mut [Q15]) -> i16 {
    let common = common_exponent(row.clone(), BITS);
    for (to, (number, exponent)) in numbers.iter_mut().zip(row) {
        *to = Q15::saturate(number.shifted(exponent - common));
    }
    common as i16
}

/// [`settle`] of the row of a transfer: products of factors and sums, with the exponents of both.
#[inline(never)]
pub(crate) fn settle_row<const L: usize>(
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

/// [`settle_row`] for a row in which no number with the largest exponent is large.
#[cold]
#[inline(never)]
fn settle_small(row: &[i32], exponents: &[i32], numbers: &mut [Q15]) -> i16 {
    settle(row.iter().copied().zip(exponents.iter().copied()), numbers)
}

/// When a row is aligned to its largest exponent, its largest number must have this many bits more
/// than are kept.
const GUARD_BITS: u32 = 5;

/// A common exponent for at most 511 numbers, each with an exponent of its own. With it, the
/// mantissas are below 2^`bits`, and the sum of their sizes after rounding is below 2^(`bits` + 1).
/// It is the least such exponent, except for the 256th that rounding may add.
fn common_exponent(numbers: impl Iterator<Item = (i32, i32)> + Clone, bits: u32) -> i32 {
    let (mut largest, mut top, mut count) = (i32::MIN, None, 0);
    numbers.clone().for_each(|(number, exponent)| {
        count += 1;
        largest = largest.max(exponent);
        if number != 0 {
            top = top.max(Some(number.bits().cast_signed() + exponent));
        }
    });
    let Some(top) = top else { return 0 };
    let guard = guard(count);
    let at = |reference: i32| {
        let (mut most, mut sum) = (0, 0);
        numbers.clone().for_each(|(number, exponent)| {
            let aligned = number.max(-number).floor_shr(exponent - reference);
            most = most.max(aligned);
            sum += aligned.floor_shr(-guard.cast_signed());
        });
        row_bits(most, sum, count, guard)
    };
    // If no number with the largest exponent is large, align all of them so that they fill their
    // bits.
    let found = at(largest);
    let (reference, found) = if found >= bits + GUARD_BITS {
        (largest, found)
    } else {
        let reference = top - 31;
        (reference, at(reference))
    };
    reference + found.cast_signed() - bits.cast_signed()
}

/// By how many bits sizes are shifted right so that `count` of them, plus a 256th, fit in a sum.
#[inline(always)]
fn guard(count: i32) -> u32 {
    (count + (count >> 8)).bits()
}

/// The least n such that the sizes are below 2^n, and their sum, including the error of rounding,
/// is below 2^(n + 1). `either` is the largest size, or the bitwise OR of all sizes; `sum` is the
/// sum of `count` sizes, each shifted right by [`guard`].
#[inline(always)]
fn row_bits(either: i32, sum: i32, count: i32, guard: u32) -> u32 {
    // Each size was rounded down.
    let sum = sum + sum.floor_shr(-8) + count;
    let half = guard - 1;
    sum.max(either.floor_shr(-half.cast_signed())).bits() + half
}
