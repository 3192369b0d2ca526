//! Groups of numbers, written so that a compiler puts each group in one register.

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

/// The sum across the lanes of each profile.
#[inline(always)]
pub(crate) fn sums([a0, a1, a2, a3, b0, b1, b2, b3]: Two) -> [f32; 2] {
    [(a0 + a1) + (a2 + a3), (b0 + b1) + (b2 + b3)]
}
