//! Groups of numbers, written so that a compiler puts each group in one register, and slices split
//! into rows of equal length.
//!
//! The loops over rows compile without a path to a panic. The standard library's chunk iterators
//! reject a length of 0, and divide by the length when zipped.

use crate::float;
use crate::index::layout::LANES;

/// sum + a b, lane by lane. The lanes are named and passed by value: compilers leave the same sum
/// scalar if it is a loop over mutable elements.
#[inline(always)]
pub(crate) fn multiply_add(sum: [f32; LANES], a: &[f32; LANES], b: &[f32; LANES]) -> [f32; LANES] {
    let ([s0, s1, s2, s3], [a0, a1, a2, a3], [b0, b1, b2, b3]) = (sum, *a, *b);
    [
        float::add_product(s0, a0, b0),
        float::add_product(s1, a1, b1),
        float::add_product(s2, a2, b2),
        float::add_product(s3, a3, b3),
    ]
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

/// The groups of two profiles side by side.
pub(crate) type Two = [f32; 2 * LANES];

/// sum + a b, lane by lane, with both groups of `a` times the same b.
#[inline(always)]
pub(crate) fn multiply_add_two(sum: Two, a: &Two, b: &[f32; LANES]) -> Two {
    let [s0, s1, s2, s3, s4, s5, s6, s7] = sum;
    let ([a0, a1, a2, a3, a4, a5, a6, a7], [b0, b1, b2, b3]) = (*a, *b);
    [
        float::add_product(s0, a0, b0),
        float::add_product(s1, a1, b1),
        float::add_product(s2, a2, b2),
        float::add_product(s3, a3, b3),
        float::add_product(s4, a4, b0),
        float::add_product(s5, a5, b1),
        float::add_product(s6, a6, b2),
        float::add_product(s7, a7, b3),
    ]
}

/// Σ a b over groups, lane by lane, for two profiles.
#[inline(always)]
pub(crate) fn product<'a>(
    a: impl IntoIterator<Item = &'a Two>,
    b: impl IntoIterator<Item = &'a [f32; LANES]>,
) -> Two {
    let mut sum = [0.0; 2 * LANES];
    for (a, b) in a.into_iter().zip(b) {
        sum = multiply_add_two(sum, a, b);
    }
    sum
}

/// The rest of a slice, padded with zeros to a block.
pub(crate) fn padded<const N: usize>(rest: &[f32]) -> [f32; N] {
    let mut block = [0.0; N];
    for (to, &from) in block.iter_mut().zip(rest) {
        *to = from;
    }
    block
}

/// The sum across the lanes of each profile.
#[inline(always)]
pub(crate) fn sums([a0, a1, a2, a3, b0, b1, b2, b3]: Two) -> [f32; 2] {
    [(a0 + a1) + (a2 + a3), (b0 + b1) + (b2 + b3)]
}

/// Rows of `width` numbers, without what is left over at the end; none if `width` is 0.
pub(crate) fn rows<T>(numbers: &[T], width: usize) -> impl Iterator<Item = &[T]> {
    let mut rest = if width > 0 { numbers } else { &[] };
    core::iter::from_fn(move || {
        let (row, after) = rest.split_at_checked(width.max(1))?;
        rest = after;
        Some(row)
    })
}

pub(crate) fn rows_mut<T>(numbers: &mut [T], width: usize) -> impl Iterator<Item = &mut [T]> {
    let mut rest = if width > 0 { numbers } else { &mut [] };
    core::iter::from_fn(move || {
        let (row, after) = core::mem::take(&mut rest).split_at_mut_checked(width.max(1))?;
        rest = after;
        Some(row)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_whole() {
        let mut numbers = [1, 2, 3, 4, 5];
        assert!(rows(&numbers, 2).eq([[1, 2], [3, 4]]));
        rows_mut(&mut numbers, 2).for_each(<[i32]>::reverse);
        assert_eq!(numbers, [2, 1, 4, 3, 5]);
        for width in [0, 6] {
            assert!(
                rows(&numbers, width).next().is_none()
                    && rows_mut(&mut numbers, width).next().is_none()
            );
        }
    }
}
