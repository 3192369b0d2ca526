//! The quadratic programme of a fit: least squares under inequalities.

use clarabel::algebra::CscMatrix;
use clarabel::solver::{
    DefaultSettingsBuilder, DefaultSolver, IPSolver, NonnegativeConeT, SolverStatus,
};

use crate::error::{Error, Result};

/// Minimise ½ bᵀ P b - gᵀ b subject to rowᵀ b <= limit for every row.
pub(super) struct Programme {
    /// The columns of the upper triangle of P: entry j has j + 1 numbers.
    curvature: Vec<Vec<f64>>,
    rows: Vec<Vec<f64>>,
    limits: Vec<f64>,
}

/// Relative and absolute accuracy asked of the interior point method.
const ACCURACY: f64 = 1e-10;

impl Programme {
    /// Without inequalities yet. `curvature` has the columns of the upper
    /// triangle of P, positive definite.
    pub(super) fn new(curvature: Vec<Vec<f64>>) -> Self {
        Self {
            curvature,
            rows: Vec::new(),
            limits: Vec::new(),
        }
    }

    /// Adds rowᵀ b <= limit.
    pub(super) fn require(&mut self, row: Vec<f64>, limit: f64) {
        self.rows.push(row);
        self.limits.push(limit);
    }

    /// The minimum for this g.
    pub(super) fn solve(&self, gradient: &[f64]) -> Result<Vec<f64>> {
        let (unknowns, count) = (self.curvature.len(), self.rows.len());
        let upper = columns(unknowns, unknowns, |column| {
            self.curvature[column].iter().copied().enumerate().collect()
        });
        let inequalities = columns(count, unknowns, |column| {
            self.rows
                .iter()
                .map(|row| row[column])
                .enumerate()
                .collect()
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
        let cones = [NonnegativeConeT(count)];
        let mut solver = DefaultSolver::new(
            &upper,
            &linear,
            &inequalities,
            &self.limits,
            &cones,
            settings,
        )
        .map_err(|error| failed(&error))?;
        solver.solve();
        match solver.solution.status {
            SolverStatus::Solved | SolverStatus::AlmostSolved => Ok(solver.solution.x.clone()),
            status => Err(failed(&status)),
        }
    }
}

/// A sparse matrix from the (row, value) entries of its columns, rows rising.
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
