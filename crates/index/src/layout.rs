//! Layout of the runtime's rows, so that a compiler can take [`LANES`] numbers at
//! a time.
//!
//! Polar integrals and factors of UᵀM run along l, in groups from l = 0 on: for
//! each group, for each pair, one group of numbers, zero where l is below q or |m|
//! or above the degree. Factors of azimuth |m| start at the group of l = |m|.
//!
//! Transfers run along m: a pass takes the orders m = first..first + [`LANES`],
//! `first` a multiple of [`LANES`], and at most [`PASS`] profiles of each; for
//! each l from [`lowest_degree`] on, for each of its profiles, one group.

/// Numbers in one group.
pub const LANES: usize = 4;

/// Most profiles of one order in a pass.
pub const PASS: usize = 8;

/// Groups over l = 0..=degree.
#[inline]
#[must_use]
pub const fn groups(degree: usize) -> usize {
    degree / LANES + 1
}

/// The group of l = azimuth, the first of its factors.
#[inline]
#[must_use]
pub const fn first_group(azimuth: usize) -> usize {
    azimuth / LANES
}

/// The least l of a pass whose orders start at `first`: the least |m| of them.
#[inline]
#[must_use]
pub const fn lowest_degree(first: isize) -> usize {
    let last = first + LANES.cast_signed() - 1;
    if first >= 0 { first.unsigned_abs() } else { last.unsigned_abs() }
}

/// The `first` of the pass that holds order m.
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
            assert_eq!(groups(degree) - 1, first_group(degree));
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
}
