//! The database's prior of d, and of the light.
//!
//! By (28) and (33) the components of U are uncorrelated over the database, with the eigenvalues as
//! variances. The constant of image-centered PCA is an exception: its coefficient, the mean of an
//! image, has E{d_0²} = eᵀ V_c e. It is correlated with the other components of m = 0, because
//! bright images have stronger shading. So the full second moments V_d = Uᵀ M V_c M U are used (Σ_c
//! for the standard criterion), stored as a factor like the others: V_d = F Fᵀ.

use super::linear::{Reduction, decompose};
use super::transfer::Transfers;
use crate::basis::light_statistics::LightStatistics;
use crate::basis::moments::MaterialMoments;
use eigenshade_index::light;
use eigenshade_model::error::{Error, Result};
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use faer::{Col, ColRef, Mat};

/// Columns of F shorter than this fraction of the longest are rounding.
const ROUNDING: f64 = 1e-13;

/// The statistics of d at exposure 1, which is that of the database's own light.
#[derive(Clone, Debug)]
pub struct Prior {
    /// F, with one row for each component and columns of falling length.
    pub factor: Mat<f64>,
    /// d of the table's mean image; zeros if it has none.
    pub mean: Vec<f64>,
    /// Mean energy of the database's images outside the components.
    pub left: f64,
    /// Whether deviations are from zero or from the mean.
    pub criterion: Criterion,
    /// The moments of the light.
    pub light: LightPrior,
    /// The materials' luminance coefficients and their weights.
    pub materials: MaterialMoments,
}

impl Prior {
    /// The prior for these materials under light with these statistics.
    ///
    /// # Errors
    ///
    /// If there are no materials or a number is not finite.
    pub fn new(
        table: &Table,
        transfers: &Transfers,
        light: &LightStatistics,
        materials: MaterialMoments,
    ) -> Result<Self> {
        if materials.vectors.is_empty() {
            return Err(Error::new("no materials", "give a material database with at least one"));
        }
        let (components, criterion) = (transfers.components(), table.scene.basis.criterion);
        let light = LightPrior::new(light, transfers.degree());
        let mean_transfer = transfers.of(&materials.mean);
        let mut reduction = Reduction::new(components);
        let mut push = |d: ColRef<'_, f64>, share: f64| {
            let row: Vec<f64> = d.iter().map(|d| share * d).collect();
            reduction.push(&row);
        };
        for (vector, share) in materials.rooted() {
            let transfer = transfers.of(vector);
            (&transfer * light.vectors(criterion)).col_iter().for_each(|d| push(d, share));
            if criterion == Criterion::Standard {
                push(((transfer - &mean_transfer) * &light.mean).as_ref(), share);
            }
        }
        let svd = decompose(&reduction.finish())?;
        let singular = svd.S().column_vector();
        let factor =
            Mat::from_fn(components, singular.nrows(), |i, j| svd.V()[(i, j)] * singular[j]);
        let mut mean = match (&table.general, &table.mean) {
            (Some(general), _) => general.mean_coefficients.clone(),
            (None, Some(mean)) => mean.coefficients.clone(),
            (None, None) => Vec::new(),
        };
        mean.resize(components, 0.0);
        let left = table.energy_left(components);
        Ok(Self { factor, mean, left, criterion, light, materials })
    }

    /// Whether all images are black. Then none resembles an image that contains light, and no
    /// exposure can change that.
    #[must_use]
    pub fn is_black(&self) -> bool {
        let is_zero = |values: &Vec<f64>| values.iter().all(|value| *value == 0.0);
        let no_images = self.factor.norm_max() == 0.0 && is_zero(&self.mean);
        no_images || self.materials.vectors.iter().all(is_zero)
    }

    /// x with V_d x = F a: F divided by its squared column lengths, times a, with columns below
    /// rounding left out.
    #[must_use]
    pub fn dual(&self, coordinates: &[f64]) -> Col<f64> {
        let squares: Vec<f64> = self.factor.col_iter().map(|f| f.squared_norm_l2()).collect();
        let largest = squares.first().copied().unwrap_or(0.0);
        let scaled = Col::from_fn(squares.len(), |k| {
            if squares[k] > ROUNDING * ROUNDING * largest {
                coordinates[k] / squares[k]
            } else {
                0.0
            }
        });
        &self.factor * scaled
    }

    /// V_d.
    #[must_use]
    pub fn second_moment(&self) -> Mat<f64> {
        &self.factor * self.factor.transpose()
    }
}

/// The moments of the light, with one row for each coefficient L_l^m, in the order of
/// [`eigenshade_index::light`].
#[derive(Clone, Debug)]
pub struct LightPrior {
    /// E{L}.
    pub mean: Col<f64>,
    /// V with E{LLᵀ} = V Vᵀ.
    pub second: Mat<f64>,
    /// V such that V Vᵀ is the covariance of L.
    pub centered: Mat<f64>,
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
            centered: matrix(&statistics.centered),
        }
    }

    /// The factor that a criterion uses: of E{LLᵀ}, or of the covariance.
    #[must_use]
    pub fn vectors(&self, criterion: Criterion) -> &Mat<f64> {
        match criterion {
            Criterion::ImageCentered => &self.second,
            Criterion::Standard => &self.centered,
        }
    }
}
