//! The formula that every renderer knows.

use crate::limit::add_product;

/// Multiply-adds of a pixel: 13 multiplications, 9 additions.
pub const MULTIPLY_ADDS: usize = 11;

/// What its times are taken with.
pub const COEFFICIENTS: [f32; 9] = [0.9, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07];

/// The nine-term formula (Ramamoorthi and Hanrahan 2001), as a polynomial of the normal.
#[inline(never)]
pub fn shade(c: &[f32; 9], [x, y, z]: [&[f32]; 3], out: &mut [f32]) {
    for (((out, &x), &y), &z) in out.iter_mut().zip(x).zip(y).zip(z) {
        let linear = add_product(add_product(add_product(c[0], c[1], x), c[2], y), c[3], z);
        let square = add_product(x * x, -y, y);
        let sum = add_product(add_product(linear, c[4], square), c[5], x * y);
        *out = add_product(add_product(sum, add_product(c[6] * x, c[7], y), z), c[8], z * z);
    }
}
