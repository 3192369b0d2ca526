//! Images of the shipped basis, component by component, and their differences from scenes.

use crate::fixtures::{self, normal};
use crate::largest;
use eigenshade::truncation::Shape;
use eigenshade::{Light, Material, Normal, Scene, sphere};
use eigenshade_model::database::Named;
use std::f64::consts::TAU;

/// d for a light and a material.
pub fn coefficients(light: &[f32], material: &[f32]) -> sphere::Coefficients {
    let light = Light::new(light).expect("coefficients");
    let material = Material::new(material).expect("coefficients");
    sphere::project(&light, &material).expect("it fits")
}

pub fn single(values: Vec<f64>) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

/// d for the luminance of a light and of a material.
pub fn on(light: &Named, material: &Named) -> sphere::Coefficients {
    coefficients(&single(light.luminance()), &single(material.luminance()))
}

/// A shape of all components, with these lengths of the polynomials.
pub fn shape(lengths: &[u16]) -> Shape<'_> {
    Shape { components: sphere::COMPONENTS, lengths }
}

/// Unit vectors and weights of a quadrature rule for squares of images over a sphere.
pub fn vectors() -> Vec<([f64; 3], f64)> {
    fixtures::rule(24, 2 * sphere::DEGREE + 2)
}

/// The same rule with normals instead of vectors.
pub fn rule() -> Vec<(Normal, f64)> {
    vectors().into_iter().map(|(at, weight)| (normal(at), weight)).collect()
}

/// The image of all components, summed component by component, and its peak.
pub struct Image {
    pub values: Vec<f64>,
    pub peak: f64,
}

impl Image {
    pub fn new(d: &[f32], rule: &[(Normal, f64)]) -> Self {
        let at = |normal| f64::from(sphere::BASIS.reconstruct(d, normal).expect("components"));
        let values: Vec<f64> = rule.iter().map(|&(normal, _)| at(normal)).collect();
        // The rule contains neither the pole nor the rim and is too coarse to find the peak.
        let scene = sphere::BASIS.collapse::<{ sphere::SCENE }>(d).expect("it fits");
        let slants = (0..=48).map(|k| (TAU / 4.0 / 48.0 * f64::from(k)).sin_cos());
        let finer = slants.flat_map(|(sine, z)| {
            let around = (0..64).map(|k| (TAU / 64.0 * f64::from(k)).sin_cos());
            around.map(move |(y, x)| [sine * x, sine * y, z.max(0.0)])
        });
        let peak = largest(finer.map(|at| scene.shade(normal(at)).into()));
        Self { values, peak }
    }

    /// Root mean square difference between a scene and this image.
    pub fn apart<B: AsRef<[f32]>>(&self, scene: &Scene<'_, B>, rule: &[(Normal, f64)]) -> f64 {
        let squares = rule.iter().zip(&self.values).map(|(&(normal, weight), value)| {
            weight * (f64::from(scene.shade(normal)) - value).powi(2)
        });
        squares.sum::<f64>().sqrt()
    }
}

/// Multiply-adds per pixel for polynomials of these lengths, counted as in benches: Horner's
/// rule, complex products for the azimuths, t = 2 z - 1.
pub fn products(lengths: &[u16]) -> usize {
    let of = |length: u16| usize::from(length).saturating_sub(1);
    let (&pole, around) = lengths.split_first().unwrap_or((&0, &[]));
    let polynomials = of(pole) + around.iter().map(|&length| 2 * of(length)).sum::<usize>();
    polynomials + (4 * around.len()).saturating_sub(2) + usize::from(polynomials > 0)
}
