//! Many rows to few with the same inner products of columns: the triangle of a
//! QR decomposition, taken block by block as the rows come.
//!
//! Orthogonal transformations alone: nothing is squared, and memory does not grow
//! with the number of rows.

use faer::Mat;

/// Rows of a block, beside those of the triangle.
const BLOCK: usize = 2048;

/// Takes rows, keeps their triangle.
#[derive(Clone, Debug)]
pub struct Reduction {
    rows: Mat<f64>,
    filled: usize,
}

impl Reduction {
    /// For rows of so many numbers.
    #[must_use]
    pub fn new(columns: usize) -> Self {
        Self { rows: Mat::zeros(BLOCK + columns, columns), filled: 0 }
    }

    /// One more row; all that is beyond the number of columns is left out.
    pub fn push(&mut self, row: &[f64]) {
        if self.filled == self.rows.nrows() {
            self.reduce();
        }
        for (column, value) in row.iter().enumerate().take(self.rows.ncols()) {
            self.rows[(self.filled, column)] = *value;
        }
        self.filled += 1;
    }

    /// At most as many rows as columns; XᵀX is that of the rows that were pushed.
    #[must_use]
    pub fn finish(mut self) -> Mat<f64> {
        if self.filled > self.rows.ncols() {
            self.reduce();
        }
        self.rows.get(..self.filled, ..).to_owned()
    }

    fn reduce(&mut self) {
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
