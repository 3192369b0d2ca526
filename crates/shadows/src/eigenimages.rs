//! Principal components of an object's images, (24)-(33), with shadows.
//!
//! With the root R of the light's covariance, E{L Lᵀ} = R Rᵀ, the images of all light have the
//! covariance F Fᵀ, F = T R. Its eigenvectors are the eigenimages. With V those of FᵀF, an image is
//! T L = A d, where A = F V has a row for each pixel and d = Vᵀ R⁻¹ L has unit variances.

use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::rotation::Rotation;
use faer::{Mat, MatRef, Side};
use std::f64::consts::{PI, TAU};

/// The smallest eigenvalue of a light's covariance that counts, relative to the largest.
const LEAST: f64 = 1e-7;

/// How the light turns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Turning {
    /// Over all rotations.
    Freely,
    /// About the vertical axis, then tilted by up to this angle, in radians, about any axis: a watch
    /// on a wrist.
    Tilts(f64),
}

/// A root of a covariance and its pseudo-inverse.
pub struct Root {
    /// n x k.
    pub root: Mat<f64>,
    /// k x n.
    pub inverse: Mat<f64>,
}

/// The root of the covariance of lights that turn. Each is scaled to the same mean radiance.
///
/// # Errors
///
/// If a light is dark, or the eigenvalues are not found.
pub fn light_root(lights: &Lights, turning: Turning) -> Result<Root> {
    let count = (lights.degree + 1).pow(2);
    let mut covariance = Mat::<f64>::zeros(count, count);
    let luminance = |rgb: &[Vec<f64>; 3]| -> Vec<f64> {
        (0..count).map(|k| 0.2126 * rgb[0][k] + 0.7152 * rgb[1][k] + 0.0722 * rgb[2][k]).collect()
    };
    for light in &lights.entries {
        let mut light = luminance(&light.rgb);
        let ambient = light[0];
        if ambient <= 0.0 {
            return Err(Error::new("a light is dark", "leave it out"));
        }
        light.iter_mut().for_each(|one| *one /= ambient);
        match turning {
            Turning::Freely => {
                for degree in 0..=lights.degree {
                    let places = degree * degree..(degree + 1).pow(2);
                    let power: f64 = places.clone().map(|k| light[k] * light[k]).sum();
                    places.for_each(|k| covariance[(k, k)] += power / (2 * degree + 1) as f64);
                }
            }
            Turning::Tilts(most) => {
                for turned in
                    tilts(most).into_iter().map(|each| turned(each, lights.degree, &light))
                {
                    for a in 0..count {
                        for b in 0..count {
                            covariance[(a, b)] += turned[a] * turned[b];
                        }
                    }
                }
            }
        }
    }
    let decomposed = covariance.self_adjoint_eigen(Side::Lower);
    let decomposed =
        decomposed.map_err(|_| Error::new("no eigenvalues of the light", "check the lights"))?;
    let values: Vec<f64> = (0..count).map(|k| decomposed.S()[k]).collect();
    let largest = values.iter().fold(0.0, |most: f64, one| most.max(*one));
    let kept: Vec<usize> = (0..count).filter(|&k| values[k] > LEAST * largest).collect();
    let vectors = decomposed.U();
    Ok(Root {
        root: Mat::from_fn(count, kept.len(), |row, k| {
            vectors[(row, kept[k])] * values[kept[k]].sqrt()
        }),
        inverse: Mat::from_fn(kept.len(), count, |k, column| {
            vectors[(column, kept[k])] / values[kept[k]].sqrt()
        }),
    })
}

/// Rotations: a turn about the vertical axis y, and then a tilt.
fn tilts(most: f64) -> Vec<[Rotation; 2]> {
    let mut all = Vec::new();
    for k in 0..96 {
        let share = |step: f64| (step * k as f64).fract();
        // A turn about y by t is Rz(π/2) Rx(..)...: as Euler angles, Ry(t) is alpha = t alone.
        let turn = Rotation { alpha: TAU * share(0.618_034), beta: 0.0, gamma: 0.0 };
        // About the axis at angle a in the plane of the picture: Rz(a) Ry(tilt) Rz(-a).
        let axis = TAU * share(0.754_878);
        let tilt = most * share(0.569_840);
        all.push([turn, Rotation { alpha: tilt, beta: axis, gamma: -axis }]);
        let axis = axis + PI;
        all.push([turn, Rotation { alpha: tilt, beta: axis, gamma: -axis }]);
    }
    all
}

fn turned([first, then]: [Rotation; 2], degree: usize, light: &[f64]) -> Vec<f64> {
    then.turn(degree, &first.turn(degree, light))
}

/// Eigenimages of an object on some materials.
pub struct Eigenimages {
    /// A: the eigenimages at each pixel, N x r, each times the deviation of its coefficient.
    pub pixels: Mat<f32>,
    /// For each material the rows that give d from a light, r x n.
    pub rows: Vec<Mat<f64>>,
    /// The variances of the images along each eigenimage, largest first, and those left out.
    pub variances: Vec<f64>,
}

/// The first `rank` eigenimages of transports, one matrix for each material, which have these weights.
///
/// # Errors
///
/// If the eigenvalues are not found.
pub fn eigenimages(
    transports: &[MatRef<'_, f32>],
    weights: &[f64],
    root: &Root,
    rank: usize,
) -> Result<Eigenimages> {
    let single = |from: MatRef<'_, f64>| {
        Mat::from_fn(from.nrows(), from.ncols(), |row, column| from[(row, column)] as f32)
    };
    let of_light = root.root.ncols();
    let of_root = single(root.root.as_ref());
    let count = transports[0].nrows();
    let mut all = Mat::<f32>::zeros(count, of_light * transports.len());
    for ((number, transport), weight) in transports.iter().enumerate().zip(weights) {
        let part = transport * &of_root;
        let mut to = all.as_mut().subcols_mut(number * of_light, of_light);
        to.copy_from(&part * faer::Scale(*weight as f32));
    }
    let gram = all.transpose() * &all;
    let gram = Mat::from_fn(gram.nrows(), gram.ncols(), |a, b| f64::from(gram[(a, b)]));
    let decomposed = gram.self_adjoint_eigen(Side::Lower);
    let decomposed =
        decomposed.map_err(|_| Error::new("no eigenvalues of the images", "check the object"))?;
    let size = gram.nrows();
    let variances: Vec<f64> =
        (0..size).rev().map(|k| decomposed.S()[k].max(0.0) / count as f64).collect();
    let rank = rank.min(size).min(count);
    let vectors = Mat::from_fn(size, rank, |row, k| decomposed.U()[(row, size - 1 - k)]);
    let pixels = &all * single(vectors.as_ref());
    let rows = (0..transports.len())
        .map(|number| {
            let vectors = vectors.as_ref().subrows(number * of_light, of_light);
            (vectors.transpose() * &root.inverse) * faer::Scale(1.0 / weights[number])
        })
        .collect();
    Ok(Eigenimages { pixels, rows, variances })
}
