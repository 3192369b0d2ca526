//! Naive methods: eigenvalues and eigenvectors of squares.

use eigenshade_testing::largest;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

/// The distance of WᵀW from the identity.
pub fn off_orthonormal(vectors: &DMatrix<f64>) -> f64 {
    let count = vectors.ncols();
    largest((vectors.tr_mul(vectors) - DMatrix::identity(count, count)).iter().copied())
}

/// M^(-1/2) by eigenvalues, (28) and (33).
pub struct GramRoot {
    /// Eigenvalues that are negative, and their number.
    pub negative: [usize; 2],
    /// Elements of M^(-1/2) that are NaN, and their number.
    pub not_numbers: [usize; 2],
    /// |UᵀMU - I| for U = M^(-1/2) of the eigenvalues' absolute values.
    pub off: f64,
}

impl GramRoot {
    /// The root for M = AᵀA.
    pub fn new(a: &DMatrix<f64>) -> Self {
        let gram = a.tr_mul(a);
        let count = gram.ncols();
        let SymmetricEigen { eigenvalues: values, eigenvectors: vectors } =
            gram.clone().symmetric_eigen();
        let inverse_root = |size: fn(f64) -> f64| {
            let roots = values.map(|value| size(value).sqrt().recip());
            &vectors * DMatrix::from_diagonal(&roots) * vectors.transpose()
        };
        let (literal, whitened) = (inverse_root(|value| value), inverse_root(f64::abs));
        let product = &whitened * &gram * &whitened - DMatrix::identity(count, count);
        let negative = values.iter().filter(|value| **value < 0.0).count();
        let elements = (0..count * count).map(|k| (k / count, k % count));
        let not_numbers = elements.clone().filter(|&at| literal[at].is_nan());
        Self {
            negative: [negative, count],
            not_numbers: [not_numbers.count(), count * count],
            off: largest(elements.map(|at| product[at])),
        }
    }
}

/// Left singular vectors of the images as products with the eigenvectors of their squares, divided
/// by the roots of the eigenvalues' absolute values. Also returns the eigenvalues, descending.
pub fn left_vectors(images: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let eigen = images.tr_mul(images).symmetric_eigen();
    let mut order: Vec<usize> = (0..images.ncols()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let values: Vec<f64> = order.iter().map(|&k| eigen.eigenvalues[k]).collect();
    let columns: Vec<DVector<f64>> = order
        .iter()
        .map(|&k| images * eigen.eigenvectors.column(k) / eigen.eigenvalues[k].abs().sqrt())
        .collect();
    (DMatrix::from_columns(&columns), values)
}
