//! Groups of numbers, written so that a compiler takes each in one register.

use crate::index::layout::LANES;
use crate::scalar::Scalar;

/// sum + a b, lane by lane.
///
/// By value and by name: as a loop over mutable places the same sum stays scalar.
#[inline(always)]
pub(crate) fn multiply_add<S: Scalar>(
    sum: [S; LANES],
    a: &[S; LANES],
    b: &[S; LANES],
) -> [S; LANES] {
    let ([s0, s1, s2, s3], [a0, a1, a2, a3], [b0, b1, b2, b3]) = (sum, *a, *b);
    [s0.add_product(a0, b0), s1.add_product(a1, b1), s2.add_product(a2, b2), s3.add_product(a3, b3)]
}

/// a + b, lane by lane.
#[inline(always)]
pub(crate) fn add<S: Scalar>(a: [S; LANES], b: [S; LANES]) -> [S; LANES] {
    let ([a0, a1, a2, a3], [b0, b1, b2, b3]) = (a, b);
    [a0 + b0, a1 + b1, a2 + b2, a3 + b3]
}

/// Σ a b over groups, lane by lane, of a length known when it is compiled.
#[inline(always)]
pub(crate) fn product<S: Scalar, const V: usize>(
    a: &[[S; LANES]; V],
    b: &[[S; LANES]; V],
) -> [S; LANES] {
    let mut sum = [S::ZERO; LANES];
    for (a, b) in a.iter().zip(b) {
        sum = multiply_add(sum, a, b);
    }
    sum
}

/// Σ a b over groups, lane by lane; in four sums at a time, so that no sum waits
/// for the one before.
///
/// Apart from its caller: a compiler that sees the lanes summed takes them apart.
#[inline(never)]
pub(crate) fn long_product<S: Scalar>(a: &[[S; LANES]], b: &[[S; LANES]]) -> [S; LANES] {
    let zero = [S::ZERO; LANES];
    let (mut first, mut second, mut third, mut fourth) = (zero, zero, zero, zero);
    let ((a, a_rest), (b, b_rest)) = (a.as_chunks::<4>(), b.as_chunks::<4>());
    for ([a0, a1, a2, a3], [b0, b1, b2, b3]) in a.iter().zip(b) {
        first = multiply_add(first, a0, b0);
        second = multiply_add(second, a1, b1);
        third = multiply_add(third, a2, b2);
        fourth = multiply_add(fourth, a3, b3);
    }
    for (a, b) in a_rest.iter().zip(b_rest) {
        first = multiply_add(first, a, b);
    }
    add(add(first, second), add(third, fourth))
}

/// Sum across the lanes.
#[inline(always)]
pub(crate) fn sum<S: Scalar>([a0, a1, a2, a3]: [S; LANES]) -> S {
    (a0 + a1) + (a2 + a3)
}
