//! Light: spherical harmonic coefficients L_l^m, l = 0..=degree, m = -l..=l.
//!
//! The storage order is 00, 1-1, 10, 11, 2-2, ...: degree l and order m are at position l² + l + m.

/// Largest degree of a light that turns, and of a light on an object with shadows.
pub const MAX_DEGREE: usize = 16;

/// Number of coefficients up to and including `degree`: (degree + 1)², or `usize::MAX` on overflow.
#[inline]
#[must_use]
pub const fn count(degree: usize) -> usize {
    let orders = degree.saturating_add(1);
    orders.saturating_mul(orders)
}

/// Position of the coefficient of `degree` l and `order` m.
///
/// Domain: |m| <= l and l² + 2l <= `usize::MAX`. Outside it the result is meaningless, but the
/// function does not panic.
#[inline]
#[must_use]
pub const fn position(degree: usize, order: isize) -> usize {
    degree.wrapping_mul(degree).wrapping_add(degree).wrapping_add_signed(order)
}

/// All (degree, order) up to `degree`, in storage order.
pub fn indices(degree: usize) -> impl Iterator<Item = (usize, isize)> {
    (0..=degree).flat_map(|l| (-l.cast_signed()..=l.cast_signed()).map(move |m| (l, m)))
}

/// Factor between the paper's coefficient of order m and the coefficient of the usual graphics
/// convention (three.js, Filament, Ramamoorthi): (-1)^m for m > 0, -1 for m < 0, +1 for m = 0.
///
/// The paper's harmonics include the Condon-Shortley phase and use the signed m in sin(m phi), so
/// Y_1^-1 = -√(3/4π) y, Y_1^0 = +√(3/4π) z, Y_1^1 = -√(3/4π) x. The factor is its own inverse, so
/// it converts in both directions.
#[inline]
#[must_use]
pub const fn graphics_sign(order: isize) -> i8 {
    if order < 0 || order % 2 == 1 { -1 } else { 1 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_count_up() {
        assert!(indices(12).enumerate().all(|(k, (l, m))| position(l, m) == k));
        assert_eq!(indices(12).count(), count(12));
        assert_eq!(count(usize::MAX), usize::MAX);
    }

    /// 2^32 squared is 2^64.
    #[test]
    fn invalid_positions_do_not_panic() {
        for large in [1 << (usize::BITS / 2), usize::MAX] {
            for order in [isize::MIN, -1, 0, 1, isize::MAX] {
                let _ = position(large, order);
            }
        }
    }

    #[test]
    fn graphics_signs_are_those_of_the_nine_term_tables() {
        let signs = indices(2).map(|(_, m)| graphics_sign(m));
        assert!(signs.eq([1, -1, 1, -1, -1, -1, 1, -1, 1]));
    }
}
