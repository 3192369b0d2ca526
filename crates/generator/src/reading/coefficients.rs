//! d of an image, by scalar product and by weighted least squares.

use super::observation::Observation;
use eigenshade_model::error::{Error, Result};
use faer::linalg::solvers::Svd;
use faer::{Col, ColRef, Mat};

/// Singular values of √W E below this, relative to the largest, count as zero
/// unless a caller says otherwise: ten times the profiles' own error in the shipped
/// table, so what lies below is as much rounding of the profiles as image.
pub const CUTOFF: f64 = 1e-6;

/// d_i = I • U_i, the paper's estimate: the weighted mean of (I - m) U_i over the
/// pixels, for one channel.
///
/// Right where the weighted pixels are distributed as the normals of the table's
/// scene: for a sphere table the whole disc of a sphere, every pixel of the same
/// weight. Elsewhere it is biased, since the eigenimages are not orthogonal there.
#[must_use]
pub fn scalar_product(observation: &Observation, channel: usize) -> Vec<f64> {
    let sums = observation.design.transpose() * observation.centred(channel);
    sums.iter().map(|sum| sum / observation.weight).collect()
}

/// Weighted least squares in the components of an observation.
#[derive(Debug)]
pub struct LeastSquares {
    svd: Svd<f64>,
    rank: usize,
    condition: f64,
}

impl LeastSquares {
    /// Decomposes √W E. Singular values up to `cutoff` times the largest count as
    /// zero: what the pixels do not determine is left at zero (the least norm).
    ///
    /// # Errors
    ///
    /// If the singular values do not converge (a number that is not finite).
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

    /// Largest singular value over smallest, before the cut-off: how much an error
    /// of the pixels may grow in d.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The d of least norm that minimises |√W (target - E d)|.
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

/// Numbers as a column.
pub(super) fn column(values: &[f64]) -> Col<f64> {
    Col::from_fn(values.len(), |i| values[i])
}
