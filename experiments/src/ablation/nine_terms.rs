//! The nine-term formula of Ramamoorthi and Hanrahan: the irradiance of a Lambertian material under
//! light up to degree 2, and its error compared with light of all degrees.

use super::pictures::{direct, sphere};
use super::scenes::{self, Scene};
use crate::sphere::Picture;
use eigenshade_index::effect::Effects;
use eigenshade_model::database::Named;
use nalgebra::{DMatrix, DVector};

/// Coefficients of 1, x, y, z, xy, yz, xz, 3 z² - 1, x² - y² for the white Lambertian, f = 1/π: Σ
/// (A_l / π) L_lm Y_lm, A = π, 2π/3, π/4, in this project's sign convention.
pub fn coefficients(light: &[f64]) -> [f64; 9] {
    let pi = std::f64::consts::PI;
    let constant = (1.0 / (4.0 * pi)).sqrt();
    let linear = 2.0 / 3.0 * (3.0 / (4.0 * pi)).sqrt();
    let square = 0.25 * (15.0 / (4.0 * pi)).sqrt();
    let pole = 0.25 * (5.0 / (16.0 * pi)).sqrt();
    // Degree 1 has the order y, z, x; degree 2 has the order xy, yz, z², xz, x² - y².
    [
        constant * light[0],
        -linear * light[3],
        -linear * light[1],
        linear * light[2],
        -square * light[4],
        -square * light[5],
        -square * light[7],
        pole * light[6],
        0.5 * square * light[8],
    ]
}

/// The irradiance at a normal.
pub fn shade(c: &[f64; 9], [x, y, z]: [f64; 3]) -> f64 {
    c[0] + c[1] * x
        + c[2] * y
        + c[3] * z
        + c[4] * x * y
        + c[5] * y * z
        + c[6] * x * z
        + c[7] * (3.0 * z * z - 1.0)
        + c[8] * (x * x - y * y)
}

/// Errors of nine terms against the direct sum of degree 9 under each shipped light: root mean
/// square over the sphere, relative to the peak. Gives the error of the formula and that of the
/// best nine coefficients.
pub fn errors() -> Vec<[f64; 2]> {
    let scene = Scene::named("park_lambertian");
    let sphere = sphere();
    let roots: Vec<f64> = sphere.weights.iter().map(|weight| weight.sqrt()).collect();
    let unit = |term: usize| std::array::from_fn(|k| f64::from(u8::from(k == term)));
    let of_term = |k: usize, term: usize| roots[k] * shade(&unit(term), sphere.normals[k]);
    let terms = DMatrix::from_fn(roots.len(), 9, of_term).svd(true, true);
    let lights = scene.lights(9);
    let material = scenes::material(&scene.whole_table(), 0);
    let error = |(light, whole): (&Named, &Picture)| {
        let expected = DVector::from_fn(roots.len(), |k, _| roots[k] * whole[0][k]);
        // No cut-off is needed: the nine terms are independent.
        let best = terms.solve(&expected, 0.0).expect("both sides of the decomposition");
        let best = std::array::from_fn(|term| best[term]);
        [coefficients(&light.rgb[0]), best].map(|c| {
            let nine: Vec<f64> = sphere.normals.iter().map(|&normal| shade(&c, normal)).collect();
            sphere.error(&[nine.clone(), nine.clone(), nine], whole)
        })
    };
    let pictures = direct(&sphere, &lights, &material, Effects::ALL);
    lights.entries.iter().zip(&pictures).map(error).collect()
}
