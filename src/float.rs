//! Sums of products in `f32`, fused where the target can, and a root for loops over pixels.

#[cfg(target_feature = "relaxed-simd")]
use crate::checked_slice::padded;

/// sum + a b. With the feature `std` on a target with the target feature `fma`, it rounds once,
/// otherwise twice.
#[cfg(all(feature = "std", target_feature = "fma"))]
#[inline(always)]
pub(crate) fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    a.mul_add(b, sum)
}

/// sum + a b. With the feature `std` on a target with the target feature `fma`, it rounds once,
/// otherwise twice.
#[cfg(not(all(feature = "std", target_feature = "fma")))]
#[inline(always)]
pub(crate) fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    sum + a * b
}

/// sums + a b, four at a time, by an instruction that rounds each sum once where the processor has
/// one. Compilers do not emit it on their own, because its result depends on the processor.
#[cfg(target_feature = "relaxed-simd")]
#[inline(always)]
pub(crate) fn fused<const N: usize>(mut sums: [f32; N], a: &[f32; N], b: &[f32; N]) -> [f32; N] {
    use core::arch::wasm32::{f32x4, f32x4_extract_lane, f32x4_relaxed_madd};

    let four = |sums: [f32; 4], a: [f32; 4], b: [f32; 4]| {
        let [sums, a, b] = [sums, a, b].map(|[p, q, r, s]| f32x4(p, q, r, s));
        let next = f32x4_relaxed_madd(a, b, sums);
        [
            f32x4_extract_lane::<0>(next),
            f32x4_extract_lane::<1>(next),
            f32x4_extract_lane::<2>(next),
            f32x4_extract_lane::<3>(next),
        ]
    };
    let ((of_four, rest), (a, a_rest), (b, b_rest)) =
        (sums.as_chunks_mut(), a.as_chunks(), b.as_chunks());
    for (sums, (&a, &b)) in of_four.iter_mut().zip(a.iter().zip(b)) {
        *sums = four(*sums, a, b);
    }
    let last = four(padded(rest), padded(a_rest), padded(b_rest));
    for (sum, next) in rest.iter_mut().zip(last) {
        *sum = next;
    }
    sums
}

/// √(x/2) for x > 0 by Newton's method, without branches, division or tables, so that loops over
/// pixels can be vectorized. The half saves a product. Relative error: 8e-7.
#[inline(always)]
pub(crate) fn root_of_half(x: f32) -> f32 {
    // 1/√(2x). Each step multiplies by 3/2 - x y², with the constants for the smallest largest
    // error: 8.8e-4 after the first one, 5.8e-7 after the second.
    let first = f32::from_bits(0x5ef7_6a26_u32.wrapping_sub(x.to_bits() >> 1));
    let second = first * (1.500_88 - x * first * first);
    x * (second * (1.500_000_6 - x * second * second))
}

#[cfg(test)]
mod tests {
    use super::root_of_half;

    /// Every mantissa of two octaves, of which all others are copies.
    #[test]
    fn roots_of_halves() {
        let mut most = 0.0_f64;
        for bits in 1.0_f32.to_bits()..4.0_f32.to_bits() {
            let x = f32::from_bits(bits);
            let exact = libm::sqrt(0.5 * f64::from(x));
            most = most.max((f64::from(root_of_half(x)) / exact - 1.0).abs());
        }
        assert!(most <= 8e-7, "{most:e}");
    }
}
