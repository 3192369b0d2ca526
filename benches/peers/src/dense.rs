//! A dense matrix times a vector in f32, by three libraries, as each may like it best.

use faer::linalg::matmul::matmul;
use faer::{Accum, ColRef, Mat, Par};
use nalgebra::{DMatrix, DVector};
use ndarray::linalg::general_mat_vec_mul;
use ndarray::{Array1, Array2, ShapeBuilder};
use std::hint::black_box;

/// One matrix in six ways.
pub struct Dense {
    faer: [Mat<f32>; 2],
    nalgebra: [DMatrix<f32>; 2],
    ndarray: [Array2<f32>; 2],
}

/// A vector in three ways.
pub struct Vector {
    faer: Vec<f32>,
    nalgebra: DVector<f32>,
    ndarray: Array1<f32>,
}

/// The ways, by name.
pub const WAYS: [&str; 6] = [
    "faer, by columns",
    "faer, by rows",
    "nalgebra, by columns",
    "nalgebra, by rows",
    "ndarray, by columns",
    "ndarray, by rows",
];

impl Vector {
    pub fn new(values: &[f32]) -> Self {
        Self {
            faer: values.to_vec(),
            nalgebra: DVector::from_row_slice(values),
            ndarray: Array1::from_vec(values.to_vec()),
        }
    }

    pub fn zeros(count: usize) -> Self {
        Self::new(&vec![0.0; count])
    }

    /// Takes the first of these values for its own, as faer holds them.
    pub fn fill(&mut self, values: &[f32]) {
        let count = self.faer.len();
        self.faer.copy_from_slice(&values[..count]);
    }

    /// What the last product by this way gave.
    pub fn of(&self, way: usize) -> &[f32] {
        match way / 2 {
            0 => &self.faer,
            1 => self.nalgebra.as_slice(),
            _ => self.ndarray.as_slice().expect("contiguous"),
        }
    }
}

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
            ndarray: [
                Array2::from_shape_fn((k, n).f(), |(i, j)| rows[i][j]),
                Array2::from_shape_fn((k, n), |(i, j)| rows[i][j]),
            ],
        }
    }

    /// The product by one of [`WAYS`].
    pub fn multiply(&self, way: usize, by: &Vector, out: &mut Vector) {
        let by = black_box(by);
        match way {
            0 | 1 => {
                let count = out.faer.len();
                let out = faer::ColMut::from_slice_mut(&mut out.faer).as_mat_mut();
                let matrix =
                    if way == 0 { self.faer[0].as_ref() } else { self.faer[1].transpose() };
                assert_eq!(matrix.nrows(), count);
                let by = ColRef::from_slice(&by.faer).as_mat();
                matmul(out, Accum::Replace, matrix, by, 1.0, Par::Seq);
            }
            2 => out.nalgebra.gemv(1.0, &self.nalgebra[0], &by.nalgebra, 0.0),
            3 => out.nalgebra.gemv_tr(1.0, &self.nalgebra[1], &by.nalgebra, 0.0),
            _ => {
                general_mat_vec_mul(1.0, &self.ndarray[way - 4], &by.ndarray, 0.0, &mut out.ndarray)
            }
        }
    }
}
