//! The fit of one color channel to measured values: least squares with inequality constraints, by
//! cutting planes and quadratic programs.

use crate::material::fit_constraints::{DirectionGrid, HIGHEST, LOWEST};
use crate::material::measurements::Measurement;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus,
};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::scattering;
use eigenshade_model::task::checkpoint;
use eigenshade_table::material;
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

/// Relative and absolute accuracy of the interior point method.
const ACCURACY: f64 = 1e-10;

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
                "check the unit and the columns: BRDFs are positive except for noise",
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
        let mut program = Program::new(self.curvature());
        let slack = 0.5 * INSET;
        for _ in 0..ROUNDS {
            checkpoint();
            let points = grid.excesses(&coefficients, LOWEST + slack, HIGHEST - slack);
            if points.is_empty() {
                return Ok(coefficients);
            }
            for point in &points {
                let bound = if point.sign > 0.0 { HIGHEST } else { -LOWEST };
                let modes = grid.modes(point);
                program
                    .require(modes.iter().map(|mode| point.sign * mode).collect(), bound - INSET);
            }
            coefficients = program.solve(&gradient)?;
            program.relax(&coefficients, FAR);
        }
        let (measurements, coefficients) = (self.matrix.nrows(), self.matrix.ncols());
        if measurements < coefficients {
            let what =
                format!("{measurements} measurements do not determine {coefficients} coefficients");
            return Err(Error::new(what, "measure more directions, or ask for a lower order"));
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

/// Minimizes ½ bᵀ P b - gᵀ b subject to rowᵀ b <= limit for every row.
struct Program {
    /// The columns of the upper triangle of P; column j has j + 1 numbers.
    curvature: Vec<Vec<f64>>,
    /// The rows and their limits.
    inequalities: Vec<(Vec<f64>, f64)>,
}

impl Program {
    /// A program without inequalities. `curvature` holds the columns of the upper triangle of P,
    /// which is positive definite.
    fn new(curvature: Vec<Vec<f64>>) -> Self {
        Self { curvature, inequalities: Vec::new() }
    }

    /// Adds the inequality rowᵀ b <= limit.
    fn require(&mut self, row: Vec<f64>, limit: f64) {
        self.inequalities.push((row, limit));
    }

    /// Drops the inequalities that b satisfies with a margin above `slack`.
    fn relax(&mut self, coefficients: &[f64], slack: f64) {
        self.inequalities.retain(|(row, limit)| {
            let value: f64 = row.iter().zip(coefficients).map(|(r, b)| r * b).sum();
            limit - value <= slack
        });
    }

    /// The minimizing b for this g.
    fn solve(&self, gradient: &[f64]) -> Result<Vec<f64>> {
        let (unknowns, count) = (self.curvature.len(), self.inequalities.len());
        let upper = columns(unknowns, unknowns, |column| {
            self.curvature[column].iter().copied().enumerate().collect()
        });
        let rows = columns(count, unknowns, |column| {
            self.inequalities.iter().map(|(row, _)| row[column]).enumerate().collect()
        });
        let linear: Vec<f64> = gradient.iter().map(|g| -g).collect();
        let settings = DefaultSettingsBuilder::default()
            .verbose(false)
            .max_threads(1)
            .tol_gap_abs(ACCURACY)
            .tol_gap_rel(ACCURACY)
            .tol_feas(ACCURACY)
            .build()
            .map_err(|error| failed(&error))?;
        let limits: Vec<f64> = self.inequalities.iter().map(|(_, limit)| *limit).collect();
        let cones = [NonnegativeConeT(count)];
        let mut solver = DefaultSolver::new(&upper, &linear, &rows, &limits, &cones, settings)
            .map_err(|error| failed(&error))?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ok(solver.solution.x.clone()),
            status => Err(failed(&status)),
        }
    }
}

/// A sparse matrix from the (row, value) entries of its columns, with rising rows.
fn columns(
    rows: usize,
    count: usize,
    entries: impl Fn(usize) -> Vec<(usize, f64)>,
) -> CscMatrix<f64> {
    let (mut starts, mut indices, mut values) = (vec![0], Vec::new(), Vec::new());
    for column in 0..count {
        for (row, value) in entries(column) {
            indices.push(row);
            values.push(value);
        }
        starts.push(indices.len());
    }
    CscMatrix::new(rows, count, starts, indices, values)
}

fn failed(reason: &dyn std::fmt::Debug) -> Error {
    Error::new(
        format!("the quadratic program of the fit was not solved: {reason:?}"),
        "look for gross outliers among the measurements, or ask for a lower order",
    )
}
