//! Light: spherical harmonic coefficients L_l^m, l = 0..=degree, m = -l..=l.
//!
//! The order is 00, 1-1, 10, 11, 2-2, ...: degree l and order m stand at
//! l² + l + m.

/// Number of coefficients up to and including `degree`: (degree + 1)², or
/// `usize::MAX` where that overflows.
#[inline]
#[must_use]
pub const fn count(degree: usize) -> usize {
    let orders = degree.saturating_add(1);
    orders.saturating_mul(orders)
}

/// Position of the coefficient of `degree` l and `order` m.
///
/// Domain: |m| <= l, l² + 2l at most `usize::MAX`. Outside it the answer is meaningless, but
/// never a panic.
#[inline]
#[must_use]
pub const fn position(degree: usize, order: isize) -> usize {
    degree.wrapping_mul(degree).wrapping_add(degree).wrapping_add_signed(order)
}

/// All (degree, order) up to `degree`, in storage order.
pub fn indices(degree: usize) -> impl Iterator<Item = (usize, isize)> {
    (0..=degree).flat_map(|l| (-l.cast_signed()..=l.cast_signed()).map(move |m| (l, m)))
}

/// Factor between the paper's coefficient of order m and the graphics
/// convention's (three.js, Filament, Ramamoorthi): (-1)^m for m > 0, -1 for
/// m < 0, +1 for m = 0.
///
/// The paper's harmonics carry the Condon-Shortley phase and take the signed m
/// in sin(m phi), so Y_1^-1 = -√(3/4π) y, Y_1^0 = +√(3/4π) z,
/// Y_1^1 = -√(3/4π) x. The factor is its own inverse: it converts both ways.
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
    fn positions_that_nothing_has_are_no_panic() {
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
