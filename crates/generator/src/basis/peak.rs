//! The peak of a scene's database, to which tolerances are relative: the root of the mean square of
//! each image's largest |I|, over the lights as captured and the materials.

use crate::basis::moments::{MaterialMoments, comparable};
use eigenshade_model::database::{self, Lights, Materials};
use eigenshade_model::effects;
use eigenshade_model::error::Result;
use eigenshade_model::truth::Truth;
use eigenshade_table::Scene;
use std::f64::consts::PI;

/// Computes the peak for the scene's effects, weights and exposures at the databases' degree and
/// order. It samples 24 slants by 48 tilts, including the pole and the rim.
///
/// # Errors
///
/// If the weights are invalid or a light cannot be normalized.
pub fn of(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<f64> {
    let truth = Truth::new(lights.degree, materials.order);
    let (wanted, weights) =
        (scene.effects.set(), database::weights(&lights.entries, &scene.light.weights)?);
    let (scaled, of_lights): (Vec<Vec<f64>>, Vec<f64>) =
        comparable(lights, scene.light.normalize, &weights)?.into_iter().unzip();
    let weights = database::weights(&materials.entries, &scene.material.weights)?;
    let MaterialMoments { vectors, weights: of_materials, .. } =
        MaterialMoments::weighted(materials, weights);
    let (degree, order) = (lights.degree, materials.order);
    let scaled: Vec<_> =
        scaled.iter().map(|light| effects::lights(degree, light, wanted)).collect();
    let materials: Vec<_> =
        vectors.iter().map(|material| effects::materials(order, material, wanted)).collect();
    let mut peaks = vec![0.0f64; scaled.len() * materials.len()];
    for slant in 0..24 {
        let (sine, z) = (0.5 * PI * f64::from(slant) / 23.0).sin_cos();
        for tilt in 0..48 {
            let (y, x) = (2.0 * PI * f64::from(tilt) / 48.0).sin_cos();
            let modes = truth.at([sine * x, sine * y, z.max(0.0)]);
            let mut peak = peaks.iter_mut();
            for material in &materials {
                let scattered: Vec<_> = material.iter().map(|one| modes.scatter(one)).collect();
                for (light, peak) in scaled.iter().zip(&mut peak) {
                    let products = light.iter().zip(&scattered);
                    let irradiance: f64 =
                        products.map(|(light, scattered)| modes.irradiance(light, scattered)).sum();
                    *peak = peak.max(irradiance.abs());
                }
            }
        }
    }
    let weights = of_materials.iter().flat_map(|b| of_lights.iter().map(move |l| b * l));
    let squares = peaks.iter().zip(weights).map(|(peak, weight)| weight * peak * peak);
    Ok(squares.sum::<f64>().sqrt())
}
