//! Principal components of an object's images, (24)-(33), with shadows.
//!
//! With a [root](LightRoot) R of the light's covariance, E{L Lᵀ} = R Rᵀ, the images of all light have the
//! covariance F Fᵀ, F = T R. With the singular values F = U Σ Vᵀ the columns of U are the eigenimages, and
//! an image is T L = A d, where A = U Σ = F V has a row for each pixel and d = Vᵀ R⁻¹ L has unit variances.

use crate::light_root::LightRoot;
use eigenshade_model::error::{Error, Result};
use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par, Scale};

/// Eigenimages of an object on some materials.
pub struct Eigenimages {
    /// A: the eigenimages at each pixel, N x r, each times the deviation of its coefficient.
    pub pixels: Mat<f64>,
    /// For each material the rows that give d from a light, r x n.
    pub rows: Vec<Mat<f64>>,
    /// The variances of the images along each eigenimage, largest first, and those left out.
    pub variances: Vec<f64>,
}

/// The first `rank` eigenimages of transports, one matrix for each material, which have these weights.
///
/// # Errors
///
/// If the singular values are not found.
pub fn eigenimages(
    transports: &[MatRef<'_, f32>],
    weights: &[f64],
    light: &LightRoot,
    rank: usize,
) -> Result<Eigenimages> {
    let of_light = light.root.ncols();
    let count = transports[0].nrows();
    let mut all = Mat::<f64>::zeros(count, of_light * transports.len());
    for ((number, transport), weight) in transports.iter().enumerate().zip(weights) {
        let transport = Mat::from_fn(count, of_light, |row, k| f64::from(transport[(row, k)]));
        matmul(
            all.as_mut().subcols_mut(number * of_light, of_light),
            Accum::Replace,
            &transport,
            &light.root,
            *weight,
            Par::Seq,
        );
    }
    // F has the singular values and V of its triangular factor: nothing is squared.
    let qr = all.qr();
    let decomposed = qr.thin_R().thin_svd();
    let decomposed = decomposed
        .map_err(|_| Error::new("no singular values of the images", "check the object"))?;
    let singular = decomposed.S().column_vector();
    let variances: Vec<f64> = singular.iter().map(|one| one * one / count as f64).collect();
    let vectors = decomposed.V().get(.., ..rank.min(variances.len()));
    let rows = weights.iter().enumerate().map(|(number, weight)| {
        let own = vectors.subrows(number * of_light, of_light);
        own.transpose() * &light.inverse / Scale(*weight)
    });
    Ok(Eigenimages { pixels: &all * vectors, rows: rows.collect(), variances })
}
