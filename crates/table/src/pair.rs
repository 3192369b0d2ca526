//! Pairs (p, q): one Zernike radial polynomial R_p^q, p >= q >= 0, p - q even.
//!
//! The pairs are sorted by p, then q: 00, 11, 20, 22, 31, 33, ...

/// Number of pairs up to and including `order`, or `usize::MAX` for an order above 2047, like
/// [`material::count`](crate::material::count).
#[inline]
#[must_use]
pub const fn count(order: usize) -> usize {
    if order > crate::material::MAX_ORDER {
        return usize::MAX;
    }
    position(order + 1, 0)
}

/// Position of the pair (p, q).
///
/// Domain: q <= p, p - q even, p <= 2048. Outside it the result is meaningless, but the function
/// does not panic.
#[inline]
#[must_use]
pub const fn position(p: usize, q: usize) -> usize {
    // Each p' < p has floor(p'/2) + 1 pairs.
    let half = p / 2 + 1;
    let below = (p / 2).wrapping_mul(half);
    let below = if p % 2 == 1 { below.wrapping_add(half) } else { below };
    below.wrapping_add(q / 2)
}

/// All pairs (p, q) up to `order`, in storage order.
pub fn indices(order: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..=order).flat_map(|p| (p % 2..=p).step_by(2).map(move |q| (p, q)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_up() {
        for order in 0..12 {
            assert!(indices(order).enumerate().all(|(k, (p, q))| position(p, q) == k));
            assert_eq!(indices(order).count(), count(order));
        }
        assert_eq!(count(usize::MAX), usize::MAX);
    }
    #[test]
    fn invalid_positions_do_not_panic() {
        for large in [usize::MAX, usize::MAX - 1, 1 << (usize::BITS / 2)] {
            let _ = position(large, large);
        }
    }
}
