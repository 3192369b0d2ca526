//! Principal components of an object's images, (24)-(33), with shadows.
//!
//! Light that turns over all rotations has a diagonal covariance. With its root R, E{L Lᵀ} = R Rᵀ, the
//! images of all light have the covariance F Fᵀ, F = T R. Its eigenvectors are the eigenimages. With V
//! those of FᵀF, an image is T L = A d, where A = F V has a row for each pixel and d = Vᵀ R⁻¹ L has unit
//! variances.

use eigenshade_model::database::{Lights, Named};
use eigenshade_model::error::{Error, Result};
use faer::{Mat, MatRef, Side};

/// The root of the covariance of lights that turn freely: a deviation for each coefficient. Each light
/// is scaled to the same mean radiance.
///
/// # Errors
///
/// If a light is dark, or none has a coefficient of some degree.
pub fn light_root(lights: &Lights) -> Result<Vec<f64>> {
    let last = lights.degree;
    let lights: Vec<Vec<f64>> = lights.entries.iter().map(Named::luminance).collect();
    if lights.iter().any(|light| light[0] <= 0.0) {
        return Err(Error::new("a light is dark", "leave it out"));
    }
    let mut root = Vec::new();
    for degree in 0..=last {
        let of_light = |light: &Vec<f64>| {
            let powers = light[degree * degree..(degree + 1).pow(2)].iter().map(|one| one * one);
            powers.sum::<f64>() / (light[0] * light[0])
        };
        let power: f64 = lights.iter().map(of_light).sum();
        if power <= 0.0 {
            let what = format!("no light has a coefficient of degree {degree}");
            return Err(Error::new(what, "give other lights, or a lower degree"));
        }
        let orders = 2 * degree + 1;
        root.extend(vec![(power / orders as f64).sqrt(); orders]);
    }
    Ok(root)
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
    root: &[f64],
    rank: usize,
) -> Result<Eigenimages> {
    let of_light = root.len();
    let count = transports[0].nrows();
    let mut all = Mat::<f32>::zeros(count, of_light * transports.len());
    for ((number, transport), weight) in transports.iter().enumerate().zip(weights) {
        for (k, deviation) in root.iter().enumerate() {
            let factor = (weight * deviation) as f32;
            for row in 0..count {
                all[(row, number * of_light + k)] = factor * transport[(row, k)];
            }
        }
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
    let pixels = &all * Mat::from_fn(size, rank, |row, k| vectors[(row, k)] as f32);
    let rows = (0..transports.len())
        .map(|number| {
            Mat::from_fn(rank, of_light, |j, k| {
                vectors[(number * of_light + k, j)] / (root[k] * weights[number])
            })
        })
        .collect();
    Ok(Eigenimages { pixels, rows, variances })
}
