//! Groups of numbers, written so that a compiler puts each group in one register, and slices split
//! into rows of equal length.
//!
//! The loops over rows compile without a path to a panic. The standard library's chunk iterators
//! reject a length of 0, and divide by the length when zipped.

use crate::index::layout::LANES;
use crate::scalar::Scalar;

/// sum + a b, lane by lane. The lanes are named and passed by value: compilers leave the same sum
/// scalar if it is a loop over mutable elements.
#[inline(always)]
pub(crate) fn multiply_add<S: Scalar>(
    sum: [S; LANES],
    a: &[S; LANES],
    b: &[S; LANES],
) -> [S; LANES] {
    let ([s0, s1, s2, s3], [a0, a1, a2, a3], [b0, b1, b2, b3]) = (sum, *a, *b);
    [s0.add_product(a0, b0), s1.add_product(a1, b1), s2.add_product(a2, b2), s3.add_product(a3, b3)]
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
pub(crate) type Two<S> = [S; 2 * LANES];

/// sum + a b, lane by lane, with both groups of `a` times the same b.
#[inline(always)]
pub(crate) fn multiply_add_two<S: Scalar>(sum: Two<S>, a: &Two<S>, b: &[S; LANES]) -> Two<S> {
    let [s0, s1, s2, s3, s4, s5, s6, s7] = sum;
    let ([a0, a1, a2, a3, a4, a5, a6, a7], [b0, b1, b2, b3]) = (*a, *b);
    [
        s0.add_product(a0, b0),
        s1.add_product(a1, b1),
        s2.add_product(a2, b2),
        s3.add_product(a3, b3),
        s4.add_product(a4, b0),
        s5.add_product(a5, b1),
        s6.add_product(a6, b2),
        s7.add_product(a7, b3),
    ]
}

/// Σ a b over groups, lane by lane, for two profiles.
#[inline(always)]
pub(crate) fn product<'a, S: Scalar>(
    a: impl IntoIterator<Item = &'a Two<S>>,
    b: impl IntoIterator<Item = &'a [S; LANES]>,
) -> Two<S> {
    let mut sum = [S::ZERO; 2 * LANES];
    for (a, b) in a.into_iter().zip(b) {
        sum = multiply_add_two(sum, a, b);
    }
    sum
}

/// The rest of a slice, padded with zeros to a block.
pub(crate) fn padded<S: Scalar, const N: usize>(rest: &[S]) -> [S; N] {
    let mut block = [S::ZERO; N];
    for (to, &from) in block.iter_mut().zip(rest) {
        *to = from;
    }
    block
}

/// The sum across the lanes of each profile.
#[inline(always)]
pub(crate) fn sums<S: Scalar>([a0, a1, a2, a3, b0, b1, b2, b3]: Two<S>) -> [S; 2] {
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
