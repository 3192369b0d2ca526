//! Normals at which images are compared with the direct sum (15) over all 3,704 modes in f64.

use eigenshade::{Normals, sphere};
use eigenshade_benches::shipped::Axes;
use eigenshade_model::reference::{DirectSum, Modes};
use eigenshade_model::special::quadrature::gauss_legendre;
use std::f64::consts::TAU;

const RIM: usize = 64;

/// Normals, with the modes of each.
pub struct View {
    /// Unit, z >= 0.
    pub normals: Vec<[f64; 3]>,
    /// That integrate squares over a sphere's disc; 0 at the pole and the rim, where only a peak
    /// may be.
    weights: Vec<f64>,
    axes: Axes,
}

impl View {
    pub fn new() -> Self {
        let around = 2 * sphere::DEGREE + 2;
        let (mut normals, mut weights) = (Vec::new(), Vec::new());
        for (z, weight) in gauss_legendre(24, 0.0, 1.0) {
            let sine = (1.0 - z * z).sqrt();
            for k in 0..around {
                let (y, x) = (TAU * k as f64 / around as f64).sin_cos();
                normals.push([sine * x, sine * y, z]);
                weights.push(2.0 * z * weight / around as f64);
            }
        }
        normals.push([0.0, 0.0, 1.0]);
        normals.extend((0..RIM).map(|k| {
            let (y, x) = (TAU * k as f64 / RIM as f64).sin_cos();
            [x, y, 0.0]
        }));
        weights.resize(normals.len(), 0.0);
        Self { axes: Axes::new(&normals), normals, weights }
    }

    /// The modes at each normal.
    pub fn modes<'a>(&self, sum: &'a DirectSum) -> Vec<Modes<'a>> {
        self.normals.iter().map(|&normal| sum.at(normal)).collect()
    }

    /// The image that something draws.
    pub fn drawn(&self, draw: impl FnOnce(Normals<'_>, &mut [f32])) -> Vec<f64> {
        let mut image = vec![0.0; self.normals.len()];
        draw(self.axes.normals(), &mut image);
        image.into_iter().map(f64::from).collect()
    }

    /// Root mean square of the difference over a sphere, relative to the peak of the reference.
    /// Several channels follow each other.
    pub fn error(&self, reference: &[f64], image: &[f64]) -> f64 {
        let channels = reference.len() as f64 / self.weights.len() as f64;
        let peak = reference.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        let squares = reference.iter().zip(image).zip(self.weights.iter().cycle());
        let sum: f64 = squares.map(|((a, b), weight)| weight * (a - b).powi(2)).sum();
        (sum / channels).sqrt() / peak
    }

    /// The error of an image times the albedo that brings it nearest to the reference.
    pub fn error_with_best_albedo(&self, reference: &[f64], image: &[f64]) -> f64 {
        let product = |a: &[f64], b: &[f64]| -> f64 {
            let both = a.iter().zip(b).zip(self.weights.iter().cycle());
            both.map(|((a, b), weight)| weight * a * b).sum()
        };
        let albedo = product(reference, image) / product(image, image);
        let image: Vec<f64> = image.iter().map(|value| albedo * value).collect();
        self.error(reference, &image)
    }
}

/// The true image of a light on a material.
pub fn reference(modes: &[Modes<'_>], light: &[f64], material: &[f64]) -> Vec<f64> {
    modes.iter().map(|at| at.irradiance(light, &at.scatter(material))).collect()
}
