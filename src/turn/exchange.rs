//! The matrices that exchange y and z: (Ef)(x, y, z) = f(x, z, y), for degrees 1 to 16.
//!
//! Without the phase, that is, in the basis of
//! [`graphics_sign`](eigenshade_table::light::graphics_sign), let c_m and s_m be the harmonics of
//! orders m and -m. E is its own inverse and therefore symmetric. E maps functions that are even in
//! y to functions that are even in z, and preserves the parity in x, so three quarters of its
//! elements are zero. The others are four square blocks.
//!
//! E maps a rotation about z to one about -y, so E D_z = -D_y E for their generators. The result is
//! a recurrence along each column, which starts with the order l, (x + iz)^l, and proceeds toward
//! smaller orders, in which direction it is stable.

use crate::index::light::MAX_DEGREE;

pub(crate) const ELEMENTS: usize = {
    let (mut elements, mut l) = (0, 1);
    while l <= MAX_DEGREE {
        let (even, odd) = (l / 2, l.div_ceil(2));
        elements += (even + 1) * (even + 1) + even * even + 2 * odd * odd;
        l += 1;
    }
    elements
};

/// -E for each degree in turn. Each has four square blocks, row by row: the rows of c_m for even m
/// and for odd m, and the rows of s_m for even m and for odd m.
///
/// The sign drops out wherever E is applied twice. The sign makes -1 of the elements that are 1,
/// which a fraction of 2^15 in 16 bits represents exactly.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
pub(crate) const EXCHANGE: [f64; ELEMENTS] = {
    let (mut elements, mut place, mut l) = ([0.0; ELEMENTS], 0, 1);
    while l <= MAX_DEGREE {
        let ladder = ladder(l);
        let mut block = 0;
        while block < 4 {
            let is_sine = block >= 2;
            // The orders of the rows, and those of the columns. No sine has order 0.
            let mut m = if block == 2 { 2 } else { block % 2 };
            while m <= l {
                let mut n = if is_sine { (l + 1) % 2 } else { l % 2 };
                if n == 0 && (l - m) % 2 == 1 {
                    n = 2;
                }
                while n <= l {
                    elements[place] = -element(l, m, n, &ladder);
                    (place, n) = (place + 1, n + 2);
                }
                m += 2;
            }
            block += 1;
        }
        l += 1;
    }
    assert!(place == ELEMENTS);
    elements
};

/// The element of order m in the image of order n, by the recurrence from order l down.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn element(l: usize, m: usize, n: usize, ladder: &[f64; MAX_DEGREE + 1]) -> f64 {
    // 2^(1-l) √binomial(2l, l - n), over √2 for order 0; (x + iz)^l has the signs + + - -.
    let (mut binomial, mut k) = (if n == 0 { 2.0 } else { 4.0 }, 0);
    while k < l {
        binomial *= 0.25;
        k += 1;
    }
    k = 0;
    while k < l - n {
        binomial *= (2 * l - k) as f64 / (k + 1) as f64;
        k += 1;
    }
    let (mut before, mut now) = (0.0, root(binomial));
    if (l - n) / 2 % 2 == 1 {
        now = -now;
    }
    let mut order = l;
    while order > m {
        let sign = if (l - order).is_multiple_of(2) { 2.0 } else { -2.0 };
        let above = if order < l { ladder[order] } else { 0.0 };
        (before, now) = (now, (sign * n as f64 * now + above * before) / ladder[order - 1]);
        order -= 1;
    }
    now
}

/// The ladder: the generator's elements between each order and the next, times two.
#[expect(clippy::indexing_slicing, reason = "a constant function has no iterators")]
const fn ladder(l: usize) -> [f64; MAX_DEGREE + 1] {
    let (mut ladder, mut m) = ([0.0; MAX_DEGREE + 1], 0);
    while m < l {
        let square = (l - m) * (l + m + 1);
        ladder[m] = root(if m == 0 { 2 * square } else { square } as f64);
        m += 1;
    }
    ladder
}

/// √x for x > 0, by Newton's method from above, until it stops decreasing.
const fn root(x: f64) -> f64 {
    let mut root = if x > 1.0 { x } else { 1.0 };
    loop {
        let next = 0.5 * (root + x / root);
        if next >= root {
            return root;
        }
        root = next;
    }
}
