//! A dense matrix times a vector in f32, by three libraries in the layouts that suit them, and by
//! hand-written loops.

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

/// Numbers in a vector of the target.
const LANES: usize = if cfg!(target_feature = "avx512f") {
    16
} else if cfg!(target_feature = "avx") {
    8
} else {
    4
};

/// Rows whose sums are taken at once.
const ROWS: usize = 4;

/// So many numbers and zeros, to whole vectors.
pub const fn padded(count: usize) -> usize {
    count.next_multiple_of(LANES)
}

/// A matrix of `K` rows or fewer, `padded`.
pub struct ByHand<const K: usize> {
    columns: Vec<[f32; K]>,
    /// Row by row, in groups of [`ROWS`], each row of whole vectors.
    rows: Vec<[Vec<[f32; LANES]>; ROWS]>,
}

impl<const K: usize> ByHand<K> {
    /// Of rows of one length.
    pub fn new(rows: &[Vec<f32>]) -> Self {
        let number = |row: usize, column: usize| {
            rows.get(row).and_then(|row| row.get(column)).copied().unwrap_or(0.0)
        };
        let length = rows[0].len();
        let columns = (0..length).map(|column| std::array::from_fn(|row| number(row, column)));
        let vectors = |row: usize| {
            let vector = |k: usize| std::array::from_fn(|lane| number(row, LANES * k + lane));
            (0..length.div_ceil(LANES)).map(vector).collect()
        };
        let group = |first: usize| std::array::from_fn(|row| vectors(ROWS * first + row));
        Self {
            columns: columns.collect(),
            rows: (0..rows.len().div_ceil(ROWS)).map(group).collect(),
        }
    }

    /// The product, a column after the other: all sums at once. What is beyond the rows is 0.
    #[inline(never)]
    pub fn by_columns(&self, by: &[f32]) -> [f32; K] {
        let mut sums = [0.0; K];
        for (column, &by) in self.columns.iter().zip(by) {
            for (sum, &number) in sums.iter_mut().zip(column) {
                *sum = add_product(*sum, number, by);
            }
        }
        sums
    }

    /// The product, [`ROWS`] rows after the others. `by` is [`padded`].
    #[inline(never)]
    pub fn by_rows(&self, by: &[f32]) -> [f32; K] {
        let (by, _) = by.as_chunks::<LANES>();
        let mut products = [0.0; K];
        for (to, rows) in products.chunks_mut(ROWS).zip(&self.rows) {
            let mut sums = [[0.0; LANES]; ROWS];
            let [a, b, c, d] = rows;
            for ((((by, a), b), c), d) in by.iter().zip(a).zip(b).zip(c).zip(d) {
                for (sums, row) in sums.iter_mut().zip([a, b, c, d]) {
                    for ((sum, &number), &by) in sums.iter_mut().zip(row).zip(by) {
                        *sum = add_product(*sum, number, by);
                    }
                }
            }
            for (to, sums) in to.iter_mut().zip(sums) {
                *to = sums.iter().sum();
            }
        }
        products
    }
}

/// sum + a b, fused where the target fuses.
#[inline(always)]
fn add_product(sum: f32, a: f32, b: f32) -> f32 {
    if cfg!(target_feature = "fma") { a.mul_add(b, sum) } else { sum + a * b }
}
