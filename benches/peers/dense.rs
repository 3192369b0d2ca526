//! A dense matrix times a vector in f32, by two libraries in two layouts each, and by hand.

use faer::linalg::matmul::matmul;
use faer::{Accum, ColMut, ColRef, Mat, Par};
use nalgebra::{DMatrix, DVectorView, DVectorViewMut};
use std::hint::black_box;

/// One matrix, by columns and by rows.
pub struct Dense {
    faer: [Mat<f32>; 2],
    nalgebra: [DMatrix<f32>; 2],
}

/// Ways to multiply.
pub const FAER: [usize; 2] = [0, 1];
pub const NALGEBRA: [usize; 2] = [2, 3];

impl Dense {
    /// Of rows of one length.
    pub fn new(rows: &[Vec<f32>]) -> Self {
        let (k, n) = (rows.len(), rows[0].len());
        Self {
            faer: [Mat::from_fn(k, n, |i, j| rows[i][j]), Mat::from_fn(n, k, |j, i| rows[i][j])],
            nalgebra: [
                DMatrix::from_fn(k, n, |i, j| rows[i][j]),
                DMatrix::from_fn(n, k, |j, i| rows[i][j]),
            ],
        }
    }

    /// The product by one of the ways.
    pub fn multiply(&self, way: usize, by: &[f32], out: &mut [f32]) {
        let (by, out) = (black_box(by), black_box(out));
        let [by_columns, by_rows] = &self.nalgebra;
        match way {
            2 => DVectorViewMut::from_slice(out, out.len()).gemv(
                1.0,
                by_columns,
                &DVectorView::from_slice(by, by.len()),
                0.0,
            ),
            3 => DVectorViewMut::from_slice(out, out.len()).gemv_tr(
                1.0,
                by_rows,
                &DVectorView::from_slice(by, by.len()),
                0.0,
            ),
            _ => {
                let [by_columns, by_rows] = &self.faer;
                let matrix = if way == 0 { by_columns.as_ref() } else { by_rows.transpose() };
                let (by, out) = (ColRef::from_slice(by), ColMut::from_slice_mut(out));
                matmul(out.as_mat_mut(), Accum::Replace, matrix, by.as_mat(), 1.0, Par::Seq);
            }
        }
    }
}

/// A matrix of `K` rows or fewer, column after column: all sums grow at once.
pub struct ByHand<const K: usize>(Vec<[f32; K]>);

impl<const K: usize> ByHand<K> {
    /// Of rows of one length.
    pub fn new(rows: &[Vec<f32>]) -> Self {
        let number = |row: usize, column: usize| rows.get(row).map_or(0.0, |row| row[column]);
        let column = |column: usize| std::array::from_fn(|row| number(row, column));
        Self((0..rows[0].len()).map(column).collect())
    }

    /// The product.
    #[inline(never)]
    pub fn multiply(&self, by: &[f32]) -> [f32; K] {
        let mut sums = [0.0; K];
        for (column, &by) in self.0.iter().zip(by) {
            for (sum, &number) in sums.iter_mut().zip(column) {
                let fused = cfg!(target_feature = "fma");
                *sum = if fused { number.mul_add(by, *sum) } else { *sum + number * by };
            }
        }
        sums
    }
}
