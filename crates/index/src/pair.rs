//! Pairs (p, q): one Zernike radial polynomial R_p^q, p >= q >= 0, p - q even.
//!
//! The order is 00, 11, 20, 22, 31, 33, ...: by p, then by q.

/// The largest order whose pairs are counted: 32 bits hold their number.
const MOST: usize = 65_535;

/// Number of pairs up to and including `order`, or `usize::MAX` for an order above
/// 65,535.
#[inline]
#[must_use]
pub const fn count(order: usize) -> usize {
    if order > MOST {
        return usize::MAX;
    }
    position(order + 1, 0)
}

/// Position of the pair (p, q).
///
/// Domain: q <= p, p - q even. Outside it the answer is meaningless.
#[inline]
#[must_use]
pub const fn position(p: usize, q: usize) -> usize {
    // Below p there are floor(p'/2) + 1 pairs for each p' < p.
    p / 2 * (p / 2 + 1) + if p % 2 == 1 { p / 2 + 1 } else { 0 } + q / 2
}

/// All pairs (p, q) up to `order`, in storage order.
#[inline]
pub fn indices(order: usize) -> impl Iterator<Item = (usize, usize)> {
    let mut next = (0, 0);
    core::iter::from_fn(move || {
        let (p, q) = next;
        next = if q < p { (p, q + 2) } else { (p + 1, (p + 1) % 2) };
        (p <= order).then_some((p, q))
    })
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
}
