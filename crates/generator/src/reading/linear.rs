//! Linear algebra that the estimates share: a few rows in place of many, and singular values.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::task::checkpoint;
use faer::linalg::solvers::Svd;
use faer::{Col, Mat};

/// Rows of a block, in addition to those of the triangle.
const BLOCK: usize = 2048;

/// Reduces many rows to a few with the same inner products of columns: the triangle of a QR
/// decomposition, computed block by block as rows arrive.
///
/// Only orthogonal transformations are used: nothing is squared, and memory does not grow with the
/// number of rows.
#[derive(Clone, Debug)]
pub struct Reduction {
    rows: Mat<f64>,
    filled: usize,
}

impl Reduction {
    /// A reduction for rows with this number of columns.
    #[must_use]
    pub fn new(columns: usize) -> Self {
        Self { rows: Mat::zeros(BLOCK + columns, columns), filled: 0 }
    }

    /// Adds a row; entries beyond the number of columns are ignored.
    pub fn push(&mut self, row: &[f64]) {
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
        for (column, value) in row.iter().enumerate().take(self.rows.ncols()) {
            self.rows[(self.filled, column)] = *value;
        }
        self.filled += 1;
    }

    /// Returns a matrix X with at most as many rows as columns and the same XᵀX as the rows that
    /// were pushed.
    #[must_use]
    pub fn finish(mut self) -> Mat<f64> {
        if self.filled > self.rows.ncols() {
            self.reduce();
        }
        self.rows.get(..self.filled, ..).to_owned()
    }

    fn reduce(&mut self) {
        checkpoint();
        let triangle = self.rows.get(..self.filled, ..).qr().thin_R().to_owned();
        for column in 0..triangle.ncols() {
            for row in 0..triangle.nrows() {
                let upper = row <= column;
                self.rows[(row, column)] = if upper { triangle[(row, column)] } else { 0.0 };
            }
        }
        self.filled = triangle.nrows();
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
