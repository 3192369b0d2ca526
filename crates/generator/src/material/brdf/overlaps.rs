//! The modes (8) under the measure cos θ_i cos θ_r dω_i dω_r, in which they are not orthogonal.
//!
//! For each q, Σ b I = Σ_op B_op R_o(θ_i) R_p(θ_r) cos qΔφ with symmetric B, and modes of different
//! q are orthogonal. Let A_op = ∫ R_o R_p cos θ sin θ dθ, and let c be 2π times the integral of
//! cos² qΔφ over the full turn. If f is Σ b I, the matrix F of the integrals of f R_o R_p cos qΔφ
//! is c A B A. So B = A⁻¹ F A⁻¹ / c gives the sum nearest to any f, and the energy of Σ b I is c
//! times the trace of (B A)².

use eigenshade_model::scattering::norm;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_model::special::zernike;
use eigenshade_table::material;
use faer::Mat;
use faer::linalg::solvers::Solve;
use std::f64::consts::{PI, TAU};

/// A for every q up to an order.
pub(super) struct Overlaps(Vec<Mat<f64>>);

impl Overlaps {
    /// Computes A with a quadrature rule that is exact: the integrands are polynomials in cos θ.
    pub(super) fn new(order: usize) -> Self {
        let nodes = gauss_legendre(order / 2 + 2, 0.0, 1.0);
        let matrix = |q: usize| {
            let count = (order - q) / 2 + 1;
            let mut matrix = Mat::zeros(count, count);
            for &(z, weight) in &nodes {
                let radials = zernike::column(order, q, (1.0 - z).sqrt());
                for (j, first) in radials.iter().enumerate() {
                    for (k, second) in radials.iter().enumerate() {
                        matrix[(j, k)] += weight * z * first * second;
                    }
                }
            }
            matrix
        };
        Self((0..=order).map(matrix).collect())
    }

    /// The coefficients b of the sum Σ b I nearest to f, from the integrals of f with the modes, ∫∫
    /// f I cos θ_i cos θ_r dω_i dω_r.
    pub(super) fn nearest(&self, integrals: &[f64]) -> Vec<f64> {
        let mut coefficients = vec![0.0; integrals.len()];
        for (q, overlap) in self.0.iter().enumerate() {
            let right = Mat::from_fn(overlap.nrows(), overlap.ncols(), |j, k| {
                let (o, p) = (q + 2 * j.max(k), q + 2 * j.min(k));
                integrals[material::position(o, p, q)] / (2.0 * norm(o, p, q) * turn(q))
            });
            let lu = overlap.partial_piv_lu();
            let half = lu.solve(&right);
            let matrix = lu.solve(half.transpose().to_owned());
            for j in 0..overlap.nrows() {
                for k in 0..=j {
                    let (o, p) = (q + 2 * j, q + 2 * k);
                    let mean = 0.5 * (matrix[(j, k)] + matrix[(k, j)]);
                    coefficients[material::position(o, p, q)] = mean / factor(o, p, q);
                }
            }
        }
        coefficients
    }

    /// ∫∫ (Σ b I)² cos θ_i cos θ_r dω_i dω_r.
    pub(super) fn energy(&self, coefficients: &[f64]) -> f64 {
        let of = |(q, overlap): (usize, &Mat<f64>)| {
            let b = Mat::from_fn(overlap.nrows(), overlap.ncols(), |j, k| {
                let (o, p) = (q + 2 * j.max(k), q + 2 * j.min(k));
                factor(o, p, q) * coefficients[material::position(o, p, q)]
            });
            let product = b * overlap;
            let squared = &product * &product;
            turn(q) * (0..squared.nrows()).map(|j| squared[(j, j)]).sum::<f64>()
        };
        self.0.iter().enumerate().map(of).sum()
    }
}

/// B_op / b_op^q. For o = p the two products are the same.
fn factor(o: usize, p: usize, q: usize) -> f64 {
    norm(o, p, q) * if o == p { 2.0 } else { 1.0 }
}

/// 2π times the integral of cos² qΔφ over the full turn.
fn turn(q: usize) -> f64 {
    TAU * if q == 0 { TAU } else { PI }
}
