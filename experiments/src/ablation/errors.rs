//! Truncation and rounding errors of the scenes' tables, against the direct sum.

use super::pictures::{Picture, Sphere, difference, peak};
use super::scenes::{self, Scene};
use super::shares::SPACING;
use eigenshade::{Q15, Tolerance};
use eigenshade_shading::integer_shader::IntegerShader;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::owned_quantised::Integer;
use eigenshade_shading::shader::{OwnedNormals, Shader};

/// Errors of a scene's table: root mean square over the sphere, relative to the peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// In f32, under the scene's own light.
    pub f32: f64,
    /// In f32, under the shipped light with the largest error.
    pub worst: f64,
    /// In Q15, under the scene's own light.
    pub q15: f64,
}

/// The errors of a scene with the boards' polynomials.
pub fn errors(scene: &Scene) -> Errors {
    let table = scene.whole_table();
    let sphere = Sphere::new(SPACING);
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order);
    let basis = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&sphere.normals);
    let truth =
        |light: &[Vec<f64>]| sphere.direct((degree, light), (order, &material), table.effects());
    let error = |found: &Picture, expected: &Picture| {
        sphere.rms(&difference(found, expected)) / peak(expected)
    };
    let mut in_f32 = |light: &[Vec<f64>]| -> Picture {
        let of_channel = |light: &Vec<f64>| -> Vec<f64> {
            let picture = shader.polynomial((degree, light), (order, &material), &normals);
            picture.expect("it fits").into_iter().map(f64::from).collect()
        };
        light.iter().map(of_channel).collect()
    };
    let mut worst = 0.0f64;
    for light in &scenes::lights(degree).entries {
        let light = scene.channels_of(light);
        worst = worst.max(error(&in_f32(&light), &truth(&light)));
    }
    let light = scene.light(degree);
    let expected = truth(&light);
    let mut shader = IntegerShader::<Q15>::new(&table, table.count()).expect("Q15 serves it");
    let normals: Vec<_> =
        sphere.normals.iter().map(|&normal| Q15::normal(normal).expect("a normal")).collect();
    let q15: Picture = light
        .iter()
        .map(|light| shader.polynomial((degree, light), (order, &material), &normals))
        .collect::<Result<_, _>>()
        .expect("it fits");
    Errors { f32: error(&in_f32(&light), &expected), worst, q15: error(&q15, &expected) }
}

/// The number of terms that the runtime keeps of a scene within a tolerance relative to the peak,
/// under each shipped light.
pub fn terms_within(scene: &Scene, tolerance: f32) -> Vec<usize> {
    let table = scene.whole_table();
    let (degree, order) = (table.gram.degree, table.gram.order);
    let material = scenes::material(&table, order);
    let basis = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(basis.basis().expect("a basis"), table.count());
    let normals = OwnedNormals::new(&[[0.0, 0.0, 1.0]]);
    let lights = scenes::lights(degree).entries;
    let terms = lights.iter().map(|light| {
        let light = light.luminance();
        let channel = ((degree, light.as_slice()), (order, material.as_slice()));
        let within = shader.within(&[channel], &normals, Tolerance::OfPeak(tolerance));
        within.expect("a tolerance above zero")[0].1.terms
    });
    terms.collect()
}
