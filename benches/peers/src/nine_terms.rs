//! The formula of nine terms (Ramamoorthi and Hanrahan 2001): irradiance of a matte as a
//! polynomial of the normal.

use eigenshade_index::light::{graphics_sign, indices};
use std::f64::consts::PI;

/// Coefficients of 1, x, y, z, x² - y², xy, xz, yz, z² for a light in the paper's convention
/// on a matte of f = 1/π.
pub fn coefficients(light: &[f64]) -> [f64; 9] {
    let mut c = [0.0; 9];
    for ((coefficient, &light), (l, m)) in c.iter_mut().zip(light).zip(indices(2)) {
        // The cosine lobe's own coefficients, over π.
        let lobe = [1.0, 2.0 / 3.0, 0.25][l];
        *coefficient = lobe * light * f64::from(graphics_sign(m));
    }
    let [c00, c1n1, c10, c11, c2n2, c2n1, c20, c21, c22] = c;
    let constant = (0.25 / PI).sqrt();
    let linear = (0.75 / PI).sqrt();
    let mixed = (3.75 / PI).sqrt();
    let along = (0.3125 / PI).sqrt();
    [
        constant * c00 - along * c20,
        linear * c11,
        linear * c1n1,
        linear * c10,
        0.5 * mixed * c22,
        mixed * c2n2,
        mixed * c21,
        mixed * c2n1,
        3.0 * along * c20,
    ]
}

/// Many normals in f32: all x, all y, all z.
pub fn slice(c: &[f32; 9], [x, y, z]: [&[f32]; 3], out: &mut [f32]) {
    for (((out, &x), &y), &z) in out.iter_mut().zip(x).zip(y).zip(z) {
        let linear = c[0] + c[1] * x + c[2] * y + c[3] * z;
        let square = c[4] * (x * x - y * y) + c[5] * (x * y) + (c[6] * x + c[7] * y) * z;
        *out = linear + square + c[8] * (z * z);
    }
}

/// The image times what brings it nearest to the truth: no albedo serves the formula better.
pub fn with_best_albedo(image: &[f64], truth: &[f64], weights: &[f64]) -> Vec<f64> {
    let (mut both, mut own) = (0.0, 0.0);
    for ((image, truth), weight) in image.iter().zip(truth).zip(weights) {
        both += weight * image * truth;
        own += weight * image * image;
    }
    image.iter().map(|value| both / own * value).collect()
}
