//! Images of every light on every material by the direct sum (15), the reference for the error of a
//! method.

use super::materials::Scope;
use eigenshade::{Light, NineTerms};
use eigenshade_index::{light, material};
use eigenshade_model::database::Named;
use eigenshade_model::error::Result;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::special::spherical_harmonic::azimuth;
use eigenshade_shading::parallel;
use eigenshade_shading::shader::fault;
use eigenshade_shading::sphere_rings::{Ring, rings};
use indicatif::ProgressBar;
use std::f64::consts::{FRAC_PI_2, TAU};

/// The widest spacing of the normals: in radians, and in radians over the highest degree.
const WIDEST: f64 = 0.08;
/// See [`WIDEST`].
const IN_DEGREES: f64 = 1.5;
/// The number of normals on the rim: they count for the largest error but not for the rms.
const RIM: usize = 64;

/// A light on a material.
#[derive(Clone)]
pub struct Pair {
    /// Luminance of the light.
    pub light: Vec<f64>,
    /// Luminance of the material.
    pub material: Vec<f64>,
}

/// One image.
pub struct Image {
    /// Its light and its material.
    pub pair: Pair,
    /// Whether the basis was made from this material.
    pub seen: bool,
    /// The irradiance at each normal.
    pub reference: Vec<f64>,
    /// The largest |I|.
    pub peak: f64,
}

/// Degree or order, and coefficients.
pub type Channel<'a> = (usize, &'a [f64]);

impl Pair {
    /// The light and the material up to a degree and an order, at most its own.
    pub fn within(&self, degree: usize, order: usize) -> (Channel<'_>, Channel<'_>) {
        let light = &self.light[..light::count(degree)];
        ((degree, light), (order, &self.material[..material::count(order)]))
    }

    /// The nine-term formula, with the material treated as Lambertian.
    pub fn nine_terms(&self) -> Result<NineTerms<f32>> {
        let degree = (self.light.len().isqrt() - 1).min(2);
        let ((_, light), _) = self.within(degree, 0);
        let light = Light::new(light).map_err(fault)?;
        // b_00^0 is twice the albedo.
        let formula = NineTerms::lambertian(&light, 0.5 * self.material[0]);
        Ok(NineTerms::new(formula.coefficients().map(|value| value as f32)))
    }
}

/// Every light on every material.
pub struct Images {
    /// Unit normals of a sphere.
    pub normals: Vec<[f64; 3]>,
    /// The weight of each normal, for the density cos α / π.
    pub weights: Vec<f64>,
    /// The images.
    pub images: Vec<Image>,
}

impl Images {
    /// Computes the sums.
    pub fn new(scope: &Scope) -> Self {
        let (degree, order) = (scope.degree, scope.order);
        let mut rings = rings(WIDEST.min(IN_DEGREES / degree.max(1) as f64));
        let tilts = (0..RIM).map(|k| TAU * k as f64 / RIM as f64).collect();
        rings.push(Ring { slant: FRAC_PI_2, tilts, weight: 0.0 });
        rings.push(Ring { slant: 0.0, tilts: vec![0.0], weight: 0.0 });
        let normals: Vec<[f64; 3]> = rings.iter().flat_map(Ring::normals).collect();
        let weights = rings.iter().flat_map(|one| std::iter::repeat_n(one.weight, one.tilts.len()));
        let weights = weights.collect();
        let reference = DirectSum::new(degree, order);
        let lights: Vec<Vec<f64>> = scope.lights.entries.iter().map(Named::luminance).collect();
        let entries = scope.seen.entries.iter().chain(&scope.unseen.entries);
        let materials: Vec<Vec<f64>> = entries.map(Named::luminance).collect();
        let hidden = ProgressBar::hidden();
        // By ring, then by material, then by light: a coefficient for each azimuth.
        let profiles = parallel::map(rings.len(), &hidden, |k| {
            let (sine, cosine) = rings[k].slant.sin_cos();
            // At the rim, cos(π/2) is not exactly zero.
            let modes = reference.at([sine, 0.0, cosine.max(0.0)]);
            let of = |material: &Vec<f64>| {
                let scattered = modes.scatter(material);
                lights.iter().map(|light| modes.profile(light, &scattered)).collect::<Vec<_>>()
            };
            materials.iter().map(of).collect::<Vec<_>>()
        });
        let top = degree.cast_signed();
        let waves: Vec<Vec<Vec<f64>>> = rings
            .iter()
            .map(|ring| {
                let of = |tilt: &f64| (-top..=top).map(|m| azimuth(m, *tilt)).collect();
                ring.tilts.iter().map(of).collect()
            })
            .collect();
        let images = parallel::map(lights.len() * materials.len(), &hidden, |k| {
            let (material, light) = (k / lights.len(), k % lights.len());
            let mut values = Vec::with_capacity(normals.len());
            for (profiles, waves) in profiles.iter().zip(&waves) {
                let profile = &profiles[material][light];
                let sum = |waves: &Vec<f64>| waves.iter().zip(profile).map(|(a, b)| a * b).sum();
                values.extend(waves.iter().map(sum).collect::<Vec<f64>>());
            }
            let peak = values.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
            Image {
                pair: Pair { light: lights[light].clone(), material: materials[material].clone() },
                seen: material < scope.seen.entries.len(),
                reference: values,
                peak,
            }
        });
        Self { normals, weights, images }
    }
}
