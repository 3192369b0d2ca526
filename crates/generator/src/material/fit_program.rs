//! The quadratic program of a fit: least squares with inequality constraints.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus,
};

use eigenshade_model::error::{Error, Result};

/// Minimizes ½ bᵀ P b - gᵀ b subject to rowᵀ b <= limit for every row.
pub(super) struct Programme {
    /// The columns of the upper triangle of P; column j has j + 1 numbers.
    curvature: Vec<Vec<f64>>,
    /// The rows and their limits.
    inequalities: Vec<(Vec<f64>, f64)>,
}

/// Relative and absolute accuracy of the interior point method.
const ACCURACY: f64 = 1e-10;

impl Programme {
    /// A program without inequalities. `curvature` holds the columns of the upper triangle of P,
    /// which is positive definite.
    pub(super) fn new(curvature: Vec<Vec<f64>>) -> Self {
        Self { curvature, inequalities: Vec::new() }
    }

    /// Adds the inequality rowᵀ b <= limit.
    pub(super) fn require(&mut self, row: Vec<f64>, limit: f64) {
        self.inequalities.push((row, limit));
    }

    /// Drops the inequalities that b satisfies with a margin above `slack`.
    pub(super) fn relax(&mut self, coefficients: &[f64], slack: f64) {
        self.inequalities.retain(|(row, limit)| {
            let value: f64 = row.iter().zip(coefficients).map(|(r, b)| r * b).sum();
            limit - value <= slack
        });
    }

    /// The minimizing b for this g.
    pub(super) fn solve(&self, gradient: &[f64]) -> Result<Vec<f64>> {
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
        format!("the quadratic programme of the fit was not solved: {reason:?}"),
        "look for gross outliers among the measurements, or ask for a lower order",
    )
}
