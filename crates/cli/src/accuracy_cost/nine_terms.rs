//! The nine-term formula (Ramamoorthi and Hanrahan 2001): the measure of all costs.

use eigenshade_index::light;
use std::f64::consts::PI;

/// The coefficients of 1, x, y, z, x² - y², xy, xz, yz, z² of the irradiance of a Lambertian
/// material, from a light to degree 2 at least and b_00^0.
#[must_use]
pub fn coefficients(light: &[f64], matte: f64) -> [f64; 9] {
    // b_00^0 is twice the albedo; the clamped cosine, over π, has the weights 1, 2/3, 1/4.
    let albedo = 0.5 * matte;
    let of = |l: usize, m: isize, weight: f64, norm: f64| {
        let sign = f64::from(light::graphics_sign(m));
        albedo * weight * sign * norm * light.get(light::position(l, m)).copied().unwrap_or(0.0)
    };
    let root = |square: f64| square.sqrt();
    let (first, second) = (root(3.0 / (4.0 * PI)), root(15.0 / (4.0 * PI)));
    let upright = of(2, 0, 0.25, 0.5 * root(5.0 / (4.0 * PI)));
    [
        of(0, 0, 1.0, 0.5 / PI.sqrt()) - upright,
        of(1, 1, 2.0 / 3.0, first),
        of(1, -1, 2.0 / 3.0, first),
        of(1, 0, 2.0 / 3.0, first),
        of(2, 2, 0.25, 0.5 * second),
        of(2, -2, 0.25, second),
        of(2, 1, 0.25, second),
        of(2, -1, 0.25, second),
        3.0 * upright,
    ]
}

/// The formula over slices of one length.
pub fn shade(c: &[f32; 9], [x, y, z]: [&[f32]; 3], out: &mut [f32]) {
    for (((out, &x), &y), &z) in out.iter_mut().zip(x).zip(y).zip(z) {
        let linear = c[0] + c[1] * x + c[2] * y + c[3] * z;
        let square = c[4] * (x * x - y * y) + c[5] * (x * y) + (c[6] * x + c[7] * y) * z;
        *out = linear + square + c[8] * (z * z);
    }
}
