//! The databases of a scene as its table needs them: truncated, in range, and their peak.

use crate::basis::moments::{MaterialMoments, comparable};
use eigenshade_model::database::{self, Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::reference::{DirectSum, light_products, material_products};
use eigenshade_table::Scene;
use std::f64::consts::PI;

/// Range of image sizes whose squares fit in f64.
const RANGE: std::ops::Range<f64> = 1e-120..1e140;

/// Truncates the databases to a scene's degree and order.
///
/// # Errors
///
/// If there are no materials, or if the materials or lights do not reach the degree and order.
pub(crate) fn fitted(
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Lights, Materials)> {
    let (degree, order) = (scene.degree(), scene.order());
    if materials.entries.is_empty() {
        return Err(Error::new("no materials", "give a material database with at least one"));
    }
    if lights.degree < degree || materials.order < order {
        let (found, of) = (lights.degree, materials.order);
        let what = format!("lights of degree {found} and materials of order {of}");
        return Err(Error::new(
            what,
            format!("ask for at most that, not degree {degree} and order {order}"),
        ));
    }
    Ok((lights.truncated(degree), materials.truncated(order)))
}

/// Checks that images of this size have eigenvalues in range, from the square of `size` down to the
/// square of its rounding.
pub(crate) fn in_range(size: f64) -> Result<()> {
    if size == 0.0 || RANGE.contains(&size) {
        return Ok(());
    }
    Err(Error::new(
        format!("images of size {size:e}, whose squares are out of range"),
        "scale the lights or the materials, toward 1",
    ))
}

/// The peak of a scene's databases, to which tolerances are relative: the root of the mean square
/// of each image's largest |I|, over the lights as captured and the materials.
///
/// It is computed for the scene's effects, weights and exposures at the databases' degree and
/// order. It samples 24 slants by 48 tilts, including the pole and the rim.
///
/// # Errors
///
/// If the weights are invalid or a light cannot be normalized.
pub fn peak(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<f64> {
    let reference = DirectSum::new(lights.degree, materials.order);
    let (wanted, weights) =
        (scene.effects.set(), database::weights(&lights.entries, &scene.light.weights)?);
    let (scaled, of_lights): (Vec<Vec<f64>>, Vec<f64>) =
        comparable(lights, scene.light.normalize, &weights)?.into_iter().unzip();
    let weights = database::weights(&materials.entries, &scene.material.weights)?;
    let MaterialMoments { vectors, weights: of_materials, .. } =
        MaterialMoments::weighted(materials, weights);
    let (degree, order) = (lights.degree, materials.order);
    let scaled: Vec<_> = scaled.iter().map(|light| light_products(degree, light, wanted)).collect();
    let materials: Vec<_> =
        vectors.iter().map(|material| material_products(order, material, wanted)).collect();
    let mut peaks = vec![0.0f64; scaled.len() * materials.len()];
    for slant in 0..24 {
        let (sine, z) = (0.5 * PI * f64::from(slant) / 23.0).sin_cos();
        for tilt in 0..48 {
            let (y, x) = (2.0 * PI * f64::from(tilt) / 48.0).sin_cos();
            let modes = reference.at([sine * x, sine * y, z.max(0.0)]);
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
