//! Estimates d of an image, by scalar product or by weighted least squares.

use super::observation::Observation;
use eigenshade_model::error::{Error, Result};
use faer::linalg::solvers::Svd;
use faer::{Col, ColRef, Mat};

/// Default cut-off: singular values of √W E below this fraction of the largest count as zero. It is
/// ten times the error of the profiles in the shipped table; below it, values are as much profile
/// rounding as image.
pub const CUTOFF: f64 = 1e-6;

/// d_i = I • U_i, the paper's estimate: the weighted mean of (I - m) U_i over the pixels, for one
/// channel.
///
/// Correct if the weighted pixels have the same distribution as the normals of the table's scene:
/// for a sphere table, the whole disc of a sphere with equal weights. Otherwise it is biased,
/// because the eigenimages are not orthogonal over the pixels.
#[must_use]
pub fn scalar_product(observation: &Observation, channel: usize) -> Vec<f64> {
    let sums = observation.design.transpose() * observation.centred(channel);
    sums.iter().map(|sum| sum / observation.weight).collect()
}

/// Weighted least squares for the components of an observation.
#[derive(Debug)]
pub struct LeastSquares {
    svd: Svd<f64>,
    rank: usize,
    condition: f64,
}

impl LeastSquares {
    /// Decomposes √W E. Singular values up to `cutoff` times the largest count as zero: directions
    /// that the pixels do not determine stay at zero (the solution of least norm).
    ///
    /// # Errors
    ///
    /// If the singular values do not converge, which means that a number is not finite.
    pub fn new(observation: &Observation, cutoff: f64) -> Result<Self> {
        let svd = decompose(&observation.design)?;
        let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
        let largest = values.first().copied().unwrap_or(0.0);
        let rank = values.iter().filter(|value| **value > cutoff * largest).count();
        let condition = values.last().map_or(1.0, |smallest| largest / smallest);
        Ok(Self { svd, rank, condition })
    }

    /// Number of directions that the pixels determine.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Ratio of the largest to the smallest singular value, before the cut-off: how much errors in
    /// the pixels may grow in d.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The d of least norm that minimizes |√W (target - E d)|.
    #[must_use]
    pub fn solve(&self, target: ColRef<'_, f64>) -> Vec<f64> {
        let rank = self.rank;
        let mut along = self.svd.U().get(.., ..rank).transpose() * target;
        for (value, singular) in along.iter_mut().zip(self.svd.S().column_vector().iter()) {
            *value /= singular;
        }
        (self.svd.V().get(.., ..rank) * along).iter().copied().collect()
    }
}

/// The thin singular value decomposition.
///
/// # Errors
///
/// If it does not converge.
pub(super) fn decompose(matrix: &Mat<f64>) -> Result<Svd<f64>> {
    matrix.thin_svd().map_err(|_| {
        Error::new(
            "the singular values of the pixels' eigenimages do not converge",
            "look for numbers that are not finite, or far out of range, in image and normals",
        )
    })
}

/// Converts numbers to a column.
pub(super) fn column(values: &[f64]) -> Col<f64> {
    Col::from_fn(values.len(), |i| values[i])
}
