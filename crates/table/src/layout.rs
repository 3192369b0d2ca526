//! Memory layout of the runtime's rows, arranged so that a compiler can process [`LANES`] numbers
//! at a time.
//!
//! Polar integrals run along l: each pair has a row of [`groups`] groups, padded with zeros beyond
//! the degree. Factors of UᵀM run along the pairs: each l >= |m| has a row of [`row`] numbers,
//! padded with zeros. The profiles of an azimuth are stored in twos, with their groups interleaved.
//! If their number is odd, the last profile is paired with zeros.
//!
//! Transfers run along m. A pass covers the orders m = first..first + [`LANES`], where `first` is a
//! multiple of [`LANES`], and at most [`PASS`] profiles of each order. A pass holds one group for
//! each l from [`lowest_degree`] on and each of its profiles.

/// Largest degree of the light in a table of the runtime. Sharper light takes small
/// sources beside it.
pub const MAX_DEGREE: usize = 12;

/// Largest order of the BRDF in a table of the runtime.
pub const MAX_ORDER: usize = 12;

/// Maximum number of terms of a profile's polynomial in f32. Tables of [`MAX_DEGREE`] and
/// [`MAX_ORDER`] have 20 at the usual tolerance of profiles.
pub const MAX_TERMS: usize = 40;

/// Maximum number of terms of a polynomial in integers, which is in powers of t = 2z - 1. The
/// powers cancel: with n terms by up to (1 + √2)^n to one.
pub const MAX_INTEGER_TERMS: usize = 16;

/// Maximum number of weights in one integer sum: one for +m and one for -m of each profile. The
/// limit includes headroom for rounding. The weights of a scene are off by half a unit each, which
/// adds up to at most 2^23 in the scene's 31-bit sums; the limit keeps a 64th of the range free. A
/// transfer's row has half as many numbers, whose rounding is a 256th of the row's largest possible
/// sum.
pub const MAX_WEIGHTS: usize = 1023;

/// Numbers in one group.
pub const LANES: usize = 4;

/// Maximum number of profiles of one order in a pass.
pub const PASS: usize = 8;

/// Number of groups over l = 0..=degree.
#[inline]
#[must_use]
pub const fn groups(degree: usize) -> usize {
    degree / LANES + 1
}

/// Length of a row over the pairs of an order.
///
/// Domain: order <= 2047. For larger orders the result is meaningless, but the function does not
/// panic.
#[inline]
#[must_use]
pub const fn row(order: usize) -> usize {
    crate::pair::count(order).div_ceil(LANES).saturating_mul(LANES)
}

/// Number of rows of factors of `profiles` profiles of `azimuth`; `usize::MAX` on overflow, 0 unless
/// azimuth <= degree.
#[inline]
#[must_use]
pub const fn rows(degree: usize, azimuth: usize, profiles: usize) -> usize {
    let degrees = degree.saturating_add(1).saturating_sub(azimuth);
    profiles.div_ceil(2).saturating_mul(2).saturating_mul(degrees)
}

/// The smallest l of a pass whose orders start at `first`: the smallest |m| in the pass.
///
/// Domain: `first` is a multiple of [`LANES`].
#[inline]
#[must_use]
pub const fn lowest_degree(first: isize) -> usize {
    let last = first + LANES.cast_signed() - 1;
    if first >= 0 { first.unsigned_abs() } else { last.unsigned_abs() }
}

/// The `first` of the pass that contains order m.
#[inline]
#[must_use]
pub const fn first_order(order: isize) -> isize {
    order.div_euclid(LANES.cast_signed()) * LANES.cast_signed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_hold_every_degree() {
        for degree in 0..70 {
            assert!(LANES * groups(degree) > degree);
            assert!(LANES * (groups(degree) - 1) <= degree);
        }
    }

    #[test]
    fn every_order_has_a_lane() {
        for order in -70..=70_isize {
            let first = first_order(order);
            assert!((0..LANES.cast_signed()).contains(&(order - first)));
            let least = (first..first + LANES.cast_signed()).map(isize::unsigned_abs).min();
            assert_eq!(Some(lowest_degree(first)), least);
        }
    }
    #[test]
    fn impossible_sizes_do_not_panic() {
        assert_eq!(rows(usize::MAX, 0, 2), usize::MAX);
        assert_eq!(rows(7, 0, usize::MAX), usize::MAX);
        assert_eq!(rows(7, 8, 2), 0);
        assert!(row(usize::MAX) > row(2047));
    }
}
