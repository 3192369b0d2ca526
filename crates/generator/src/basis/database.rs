//! The databases of a scene as its table needs them: truncated, in range, and their peak.

use crate::basis::gram;
use crate::basis::moments::{self, LightMoments, MaterialMoments, comparable};
use eigenshade_model::database::{self, Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::reference::DirectSum;
use eigenshade_table::scene::{Criterion, MaterialNormalize};
use eigenshade_table::{GramFactor, Scene, mode};
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

/// The weights of a scene's materials in the statistics, [made comparable](comparable_weights).
///
/// # Errors
///
/// If the weights are invalid or a light cannot be normalized.
pub fn material_weights(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<Vec<f64>> {
    let of_lights = database::weights(&lights.entries, &scene.light.weights)?;
    let weights = database::weights(&materials.entries, &scene.material.weights)?;
    comparable_weights(scene, (lights, &of_lights), (materials, weights))
}

/// Materials' weights, which sum to 1, as a scene's [`MaterialNormalize`] changes them.
///
/// With [`MaterialNormalize::EqualVariance`], each weight is divided by the variance of the
/// material's images: the second moment (36) is then that of materials scaled to variance 1. A
/// black material has weight 0, unless all of them are black.
///
/// # Errors
///
/// If a light cannot be normalized.
pub fn comparable_weights(
    scene: &Scene,
    lights: (&Lights, &[f64]),
    (materials, weights): (&Materials, Vec<f64>),
) -> Result<Vec<f64>> {
    if scene.material.normalize == MaterialNormalize::None {
        return Ok(weights);
    }
    let variances = variances(scene, lights, materials)?;
    let varied = variances.iter().copied().filter(|variance| *variance > 0.0);
    let least = varied.fold(f64::INFINITY, f64::min);
    // At most the weight itself: nothing overflows.
    let scaled = |variance: f64| if variance > 0.0 { least / variance } else { 0.0 };
    let scaled: Vec<f64> = weights
        .iter()
        .zip(&variances)
        .map(|(weight, variance)| weight * scaled(*variance))
        .collect();
    let sum: f64 = scaled.iter().sum();
    Ok(if sum > 0.0 { scaled.iter().map(|weight| weight / sum).collect() } else { weights })
}

/// The mean variance of each material's images over the normals of a sphere, under the scene's
/// lights, turned by all rotations: Σ_l E{(L_l^m)²} Σ_m |A b|² about the mean over the normals.
fn variances(
    scene: &Scene,
    (lights, weights): (&Lights, &[f64]),
    materials: &Materials,
) -> Result<Vec<f64>> {
    let light = LightMoments::weighted(lights, scene.light.normalize, weights)?;
    let gram = gram::of_sphere(lights.degree, materials.order);
    let count = materials.entries.len();
    let equal = MaterialMoments::weighted(materials, vec![1.0; count]);
    let mut variances = vec![0.0; count];
    for azimuth in 0..=gram.degree {
        let signs = if azimuth == 0 { 1.0 } else { 2.0 };
        let columns = gram.columns(azimuth);
        let modes: Vec<_> = mode::indices(gram.degree, gram.order, azimuth).collect();
        let all = moments::deviations(&light, &equal, Criterion::ImageCentered, azimuth);
        // For each degree with light, one deviation of each material in turn.
        for (number, deviation) in all.iter().enumerate() {
            let mut image = vec![0.0; gram.nodes.len()];
            for (column, &(l, o, p, q)) in columns.iter().zip(&modes) {
                if l == deviation.degree {
                    let b = deviation.material[eigenshade_table::material::position(o, p, q)];
                    image.iter_mut().zip(column).for_each(|(image, one)| *image += b * one);
                }
            }
            if azimuth == 0 {
                center(&gram, &mut image);
            }
            variances[number % count] += signs * image.iter().map(|x| x * x).sum::<f64>();
        }
    }
    Ok(variances)
}

/// Subtracts the mean over the normals of an image at the nodes, weighted by their roots.
fn center(gram: &GramFactor, image: &mut [f64]) {
    let roots = &gram.root_weights;
    let mean: f64 = image.iter().zip(roots).map(|(value, root)| value * root).sum();
    image.iter_mut().zip(roots).for_each(|(value, root)| *value -= mean * root);
}

/// The peak of a scene's databases, to which tolerances are relative: the root of the mean square
/// of each image's largest |I|, over the lights as captured and the materials.
///
/// It is computed for the scene's weights and exposures, at the databases' degree and order as far as
/// the scene's effects reach. It samples 24 slants by 48 tilts, including the pole and the rim.
///
/// # Errors
///
/// If the weights are invalid or a light cannot be normalized.
pub fn peak(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<f64> {
    let effects = scene.effects.set();
    let lights = &lights.truncated(effects.degree(lights.degree));
    let materials = &materials.truncated(effects.order(materials.order));
    let reference = DirectSum::new(lights.degree, materials.order);
    let weights = database::weights(&lights.entries, &scene.light.weights)?;
    let (scaled, of_lights): (Vec<Vec<f64>>, Vec<f64>) =
        comparable(lights, scene.light.normalize, &weights)?.into_iter().unzip();
    let weights = material_weights(scene, lights, materials)?;
    let MaterialMoments { vectors, weights: of_materials, .. } =
        MaterialMoments::weighted(materials, weights);
    let mut peaks = vec![0.0f64; scaled.len() * vectors.len()];
    for slant in 0..24 {
        let (sine, z) = (0.5 * PI * f64::from(slant) / 23.0).sin_cos();
        for tilt in 0..48 {
            let (y, x) = (2.0 * PI * f64::from(tilt) / 48.0).sin_cos();
            let modes = reference.at([sine * x, sine * y, z.max(0.0)]);
            let mut peak = peaks.iter_mut();
            for material in &vectors {
                let scattered = modes.scatter(material);
                for (light, peak) in scaled.iter().zip(&mut peak) {
                    *peak = peak.max(modes.irradiance(light, &scattered).abs());
                }
            }
        }
    }
    let weights = of_materials.iter().flat_map(|b| of_lights.iter().map(move |l| b * l));
    let squares = peaks.iter().zip(weights).map(|(peak, weight)| weight * peak * peak);
    Ok(squares.sum::<f64>().sqrt())
}
