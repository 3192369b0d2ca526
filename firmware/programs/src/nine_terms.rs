//! The nine-term formula of Ramamoorthi and Hanrahan, as a baseline: what a Lambertian
//! material under light of degree 2 takes without any table.
//!
//! Coefficients are of 1, y, z, x, xy, yz, z² and x² - y², constants folded in.

/// In f32.
#[must_use]
#[inline]
pub fn shade(c: &[f32; 8], [x, y, z]: [f32; 3]) -> f32 {
    let [c0, c1, c2, c3, c4, c5, c6, c7] = *c;
    c0 + c1 * y + c2 * z + c3 * x + (c4 * x + c5 * z) * y + c6 * z * z + c7 * (x * x - y * y)
}

/// In Q15: normals and coefficients i16, products rounded to Q15.
#[must_use]
#[inline]
pub fn shade_q15(c: &[i16; 8], [x, y, z]: [i16; 3]) -> i32 {
    let [c0, c1, c2, c3, c4, c5, c6, c7] = c.map(i32::from);
    let [x, y, z] = [x, y, z].map(i32::from);
    let product = |a: i32, b: i32| (a * b + (1 << 14)) >> 15;
    let squares = product(x, x) - product(y, y);
    c0 + product(c1, y)
        + product(c2, z)
        + product(c3, x)
        + product(product(c4, x) + product(c5, z), y)
        + product(c6, product(z, z))
        + product(c7, squares)
}
