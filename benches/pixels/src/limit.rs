//! What a target's arithmetic cannot do without: docs/performance.md has it in words.

/// Independent sums that hide the latency of a multiplication and an addition: which of these
/// is the fastest differs between processors.
pub const CHAINS: [usize; 4] = [8, 10, 12, 14];

/// Numbers in a vector of the target.
pub const LANES: usize = if cfg!(target_feature = "avx512f") {
    16
} else if cfg!(target_feature = "avx") {
    8
} else {
    4
};

/// Instructions of a multiply-add.
pub const INSTRUCTIONS: usize = if cfg!(target_feature = "fma") { 1 } else { 2 };

/// What docs/performance.md calls the target.
pub const TARGET: &str = if cfg!(target_feature = "avx512f") {
    "AVX-512"
} else if cfg!(target_feature = "fma") {
    "AVX2"
} else {
    "default"
};

/// sum + a b as the runtime has it: fused where the target has it.
#[inline(always)]
pub fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    if cfg!(target_feature = "fma") { a.mul_add(b, sum) } else { sum + a * b }
}

/// Multiply-adds on registers, nothing else: `repeats` of them in each of `N` numbers.
#[inline(never)]
pub fn multiply_adds<const N: usize>(repeats: usize, term: f32, t: f32) -> [f32; N] {
    let mut sums = [1.0; N];
    for _ in 0..repeats {
        for sum in &mut sums {
            *sum = add_product(term, *sum, t);
        }
    }
    sums
}

/// Multiply-adds that a pixel of polynomials of these lengths cannot do without.
pub fn necessary(lengths: &[u16]) -> usize {
    let of = |length: u16| usize::from(length).saturating_sub(1);
    let (&pole, around) = lengths.split_first().unwrap_or((&0, &[]));
    // As one polynomial of the normal, a second azimuth in three.
    match (pole, around) {
        (..=3, [first @ ..=2]) => return of(pole) + 2 * usize::from(*first),
        (..=3, [first @ ..=2, ..=1]) => return of(pole) + 2 * usize::from(*first) + 3,
        _ => {}
    }
    let polynomials = of(pole) + around.iter().map(|&length| 2 * of(length)).sum::<usize>();
    let azimuths = (4 * around.len()).saturating_sub(2);
    // t = 2z - 1 is one more.
    polynomials + azimuths + usize::from(polynomials > 0)
}
