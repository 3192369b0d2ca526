//! The database's prior of the light, as matrices over the coefficients of one table.

use crate::light::statistics::LightStatistics;
use eigenshade_index::light;
use eigenshade_table::scene::Criterion;
use faer::{Col, Mat};

/// The moments of the light, with one row for each coefficient L_l^m, in the order of
/// [`eigenshade_index::light`].
#[derive(Clone, Debug)]
pub struct LightPrior {
    /// E{L}.
    pub mean: Col<f64>,
    /// V with E{LLᵀ} = V Vᵀ.
    pub second: Mat<f64>,
    /// V such that V Vᵀ is the covariance of L.
    pub centred: Mat<f64>,
}

impl LightPrior {
    /// Extends or truncates these statistics to `degree`; missing coefficients are zero.
    #[must_use]
    pub fn new(statistics: &LightStatistics, degree: usize) -> Self {
        let count = light::count(degree);
        let at = |vector: &[f64], place: usize| vector.get(place).copied().unwrap_or(0.0);
        let matrix = |vectors: &[Vec<f64>]| {
            Mat::from_fn(count, vectors.len(), |place, t| at(&vectors[t], place))
        };
        Self {
            mean: Col::from_fn(count, |place| at(&statistics.mean, place)),
            second: matrix(&statistics.second),
            centred: matrix(&statistics.centred),
        }
    }

    /// The factor that a criterion uses: of E{LLᵀ}, or of the covariance.
    #[must_use]
    pub fn vectors(&self, criterion: Criterion) -> &Mat<f64> {
        match criterion {
            Criterion::ImageCentered => &self.second,
            Criterion::Standard => &self.centred,
        }
    }
}
