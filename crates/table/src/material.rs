//! Material: Koenderink-van Doorn coefficients b_op^q of (7), o >= p >= q >= 0, o - q and p - q
//! even.
//!
//! The coefficients are sorted by o, then p, then q: 000, 111, 200, 220, 222, 311, 331, 333, ...

/// The largest order for which `count` is exact: the count fits in 32 bits.
pub(crate) const MAX_ORDER: usize = 2047;

/// Number of coefficients up to and including `order`, or `usize::MAX` for an order above 2047.
#[inline]
#[must_use]
pub const fn count(order: usize) -> usize {
    if order > MAX_ORDER {
        return usize::MAX;
    }
    position(order + 1, (order + 1) % 2, 0)
}

/// Position of the coefficient (o, p, q).
///
/// Domain: q <= p <= o, all of the same parity, o <= 2047. Outside it the result is meaningless,
/// but the function does not panic.
#[inline]
#[must_use]
pub const fn position(o: usize, p: usize, q: usize) -> usize {
    // An o with h = floor(o/2) has T(h+1) = (h+1)(h+2)/2 coefficients. Below an even o there are
    // two orders of each smaller h; below an odd o there is one more of its own h.
    let half = o / 2;
    let of_half = (half + 1).wrapping_mul(half + 2);
    let below = half.wrapping_mul(of_half) / 3;
    let below = if o % 2 == 1 { below.wrapping_add(of_half / 2) } else { below };
    below.wrapping_add((p / 2).wrapping_mul(p / 2 + 1) / 2).wrapping_add(q / 2)
}

/// All (o, p, q) up to `order`, in storage order.
#[inline]
pub fn indices(order: usize) -> impl Iterator<Item = (usize, usize, usize)> {
    let mut next = (0, 0, 0);
    core::iter::from_fn(move || {
        let (o, p, q) = next;
        next = following((o, p, q));
        (o <= order).then_some((o, p, q))
    })
}

/// The (o, p, q) that follows another in storage order.
#[inline]
#[must_use]
pub const fn following((o, p, q): (usize, usize, usize)) -> (usize, usize, usize) {
    match (q < p, p < o) {
        (true, _) => (o, p, q + 2),
        (false, true) => (o, p + 2, o % 2),
        (false, false) => (o + 1, (o + 1) % 2, (o + 1) % 2),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_up() {
        for order in 0..12 {
            assert!(indices(order).enumerate().all(|(k, (o, p, q))| position(o, p, q) == k));
            assert_eq!(indices(order).count(), count(order));
        }
        assert_eq!(count(7), 40);
        assert_eq!(count(usize::MAX), usize::MAX);
    }
    #[test]
    fn invalid_positions_do_not_panic() {
        for large in [usize::MAX, usize::MAX - 1, 1 << (usize::BITS / 2)] {
            let _ = position(large, large, large);
        }
    }
}
