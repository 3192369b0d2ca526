//! Groups of numbers, written so that a compiler puts each group in one register.

use crate::index::layout::LANES;
use crate::scalar::Scalar;

/// sum + a b, lane by lane.
///
/// The lanes are named and passed by value: compilers leave the same sum scalar if it is a loop
/// over mutable elements.
#[inline(always)]
pub(crate) fn multiply_add<S: Scalar>(
    sum: [S; LANES],
    a: &[S; LANES],
    b: &[S; LANES],
) -> [S; LANES] {
    let ([s0, s1, s2, s3], [a0, a1, a2, a3], [b0, b1, b2, b3]) = (sum, *a, *b);
    [s0.add_product(a0, b0), s1.add_product(a1, b1), s2.add_product(a2, b2), s3.add_product(a3, b3)]
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

/// The sum across the lanes of each profile.
#[inline(always)]
pub(crate) fn sums<S: Scalar>([a0, a1, a2, a3, b0, b1, b2, b3]: Two<S>) -> [S; 2] {
    [(a0 + a1) + (a2 + a3), (b0 + b1) + (b2 + b3)]
}
