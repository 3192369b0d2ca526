//! The fit of one color channel to measured values.

use crate::material::fit::{HIGHEST, LOWEST};
use crate::material::fit_constraints::DirectionGrid;
use crate::material::fit_program::Programme;
use crate::material::measurements::Measurement;
use eigenshade_index::material;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::scattering;
use faer::{Col, Mat};

/// How much tighter the inequalities are than the checked range, in units of the measured maximum.
/// This makes the iteration end and leaves little out of range between grid points.
const INSET: f64 = 4e-3;
/// The weight of |b| relative to |X b|, in units of the largest singular value of X.
const RIDGE: f64 = 1e-5;
/// An inequality with more slack than this, in units of the measured maximum, is dropped until it
/// is violated again. This keeps the programs small.
const FAR: f64 = 0.05;
/// Maximum number of rounds of adding inequalities.
const ROUNDS: usize = 100;

/// X, the modes (8) at the measured directions, and its decomposition U S Vᵀ.
pub(super) struct Design {
    matrix: Mat<f64>,
    left: Mat<f64>,
    right: Mat<f64>,
    /// Singular values S, falling.
    singular: Vec<f64>,
}

/// One fitted channel.
#[derive(Clone)]
pub(super) struct Channel {
    pub(super) coefficients: Vec<f64>,
    /// |X b - y| / |y|.
    pub(super) residual: f64,
    /// Range over the grid, in units of the measured maximum.
    pub(super) lowest: f64,
    pub(super) highest: f64,
}

impl Design {
    pub(super) fn new(samples: &[Measurement], order: usize) -> Result<Self> {
        let mut matrix = Mat::zeros(samples.len(), material::count(order));
        for (row, sample) in samples.iter().enumerate() {
            let modes = scattering::modes(order, sample.theta_i, sample.theta_r, sample.delta_phi);
            for (column, mode) in modes.into_iter().enumerate() {
                matrix[(row, column)] = mode;
            }
        }
        let finite = samples
            .iter()
            .all(|sample| (sample.theta_i + sample.theta_r + sample.delta_phi).is_finite());
        let decomposition = (finite && !samples.is_empty())
            .then(|| matrix.thin_svd().ok())
            .flatten()
            .ok_or_else(|| {
                Error::new(
                    "there are no measurements, or some have directions that are not finite",
                    "give at least one measurement, with finite angles",
                )
            })?;
        Ok(Self {
            left: decomposition.U().to_owned(),
            right: decomposition.V().to_owned(),
            singular: decomposition.S().column_vector().iter().copied().collect(),
            matrix,
        })
    }

    /// The condition number of X; infinite if X leaves coefficients undetermined up to rounding.
    pub(super) fn condition(&self) -> f64 {
        let smallest = self.singular.last().copied().unwrap_or(0.0);
        let rounding = f64::EPSILON * self.matrix.nrows() as f64 * self.largest();
        if self.matrix.nrows() < self.matrix.ncols() || smallest <= rounding {
            return f64::INFINITY;
        }
        self.largest() / smallest
    }

    fn largest(&self) -> f64 {
        self.singular.first().copied().unwrap_or(0.0)
    }

    /// Fits `values` with bounds on the grid.
    pub(super) fn fit(&self, values: &[f64], grid: &DirectionGrid) -> Result<Channel> {
        let maximum = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        if values.iter().all(|&value| value == 0.0) {
            return Ok(Channel {
                coefficients: vec![0.0; self.matrix.ncols()],
                residual: 0.0,
                lowest: 0.0,
                highest: 0.0,
            });
        }
        if maximum <= 0.0 || !values.iter().all(|value| value.is_finite()) {
            return Err(Error::new(
                "a channel has no positive value, or one that is not finite",
                "check the unit and the columns: BRDFs are positive but for noise",
            ));
        }
        let scaled = Col::from_fn(values.len(), |row| values[row] / maximum);
        let unit = self.in_range(&scaled, grid)?;
        let fitted = &self.matrix * Col::from_fn(unit.len(), |k| unit[k]);
        let (lowest, highest) = grid.range(&unit);
        Ok(Channel {
            coefficients: unit.iter().map(|b| b * maximum).collect(),
            residual: (fitted - &scaled).norm_l2() / scaled.norm_l2(),
            lowest,
            highest,
        })
    }

    /// Cutting planes: points out of range on the grid become inequalities.
    fn in_range(&self, values: &Col<f64>, grid: &DirectionGrid) -> Result<Vec<f64>> {
        let mut coefficients = self.unconstrained(values);
        let gradient: Vec<f64> =
            (self.matrix.transpose() * values).iter().map(|g| g / self.largest().powi(2)).collect();
        let mut programme = Programme::new(self.curvature());
        let slack = 0.5 * INSET;
        for _ in 0..ROUNDS {
            let points = grid.excesses(&coefficients, LOWEST + slack, HIGHEST - slack);
            if points.is_empty() {
                return Ok(coefficients);
            }
            for point in &points {
                let bound = if point.sign > 0.0 { HIGHEST } else { -LOWEST };
                let modes = grid.modes(point);
                programme
                    .require(modes.iter().map(|mode| point.sign * mode).collect(), bound - INSET);
            }
            coefficients = programme.solve(&gradient)?;
            programme.relax(&coefficients, FAR);
        }
        Err(Error::new(
            format!("the fit is still out of range after {ROUNDS} rounds"),
            "look for gross outliers among the measurements, or ask for a lower order",
        ))
    }

    /// The minimum without inequalities: V S / (S² + λ) Uᵀ y.
    fn unconstrained(&self, values: &Col<f64>) -> Vec<f64> {
        let ridge = (RIDGE * self.largest()).powi(2);
        let projected = self.left.transpose() * values;
        let damped = Col::from_fn(self.singular.len(), |k| {
            let singular = self.singular[k];
            projected[k] * singular / (singular * singular + ridge)
        });
        (&self.right * damped).iter().copied().collect()
    }

    /// The columns of the upper triangle of XᵀX / σ² + RIDGE².
    fn curvature(&self) -> Vec<Vec<f64>> {
        let square = self.matrix.transpose() * &self.matrix;
        let scale = self.largest().powi(2);
        (0..square.ncols())
            .map(|column| {
                let mut entries: Vec<f64> =
                    (0..=column).map(|row| square[(row, column)] / scale).collect();
                entries[column] += RIDGE * RIDGE;
                entries
            })
            .collect()
    }
}
