//! The space of slant profiles of one azimuth: u(α) = sin^|m|(α) h(z), where h is a polynomial in
//! z = cos α.
//!
//! Every f_s of (14) is sin^|m| times a polynomial times a power of ((1 + z)/2)^(1/2). That root is
//! analytic on \[0, 1\], so its Chebyshev series falls by a factor of 3 + √8 per term. The space is
//! orthonormal under the density of the normals. The whole computation takes place in it, so the
//! results are polynomials.

use eigenshade_table::GramFactor;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// Number of terms of h: the polynomial part of f_s needs degree - |m| + order/2 + 1, and the root
/// needs another 16 to reach rounding.
#[must_use]
pub fn terms(degree: usize, order: usize, azimuth: usize) -> usize {
    degree - azimuth + order.div_ceil(2) + 17
}

/// The space of one azimuth.
#[derive(Clone, Debug)]
pub struct ProfileSpace {
    /// Orthonormal columns: √w_k u_j(α_k).
    basis: Mat<f64>,
    /// The Chebyshev series of a profile is the inverse of this matrix times its coordinates.
    triangle: Mat<f64>,
}

impl ProfileSpace {
    /// The space of `azimuth` |m| on the nodes of `gram`.
    #[must_use]
    pub fn new(gram: &GramFactor, azimuth: usize) -> Self {
        let terms = terms(gram.degree, gram.order, azimuth);
        let weighted = Mat::from_fn(gram.nodes.len(), terms, |k, j| {
            let z = gram.nodes[k];
            let sine = ((1.0 - z) * (1.0 + z)).sqrt();
            gram.root_weights[k] * sine.powi(azimuth as i32) * chebyshev(j, 2.0 * z - 1.0)
        });
        let qr = weighted.qr();
        Self { basis: qr.compute_thin_Q(), triangle: qr.thin_R().to_owned() }
    }

    /// Dimension of the space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.basis.ncols()
    }

    /// Coordinates of columns of weighted node values. Exact for profiles in the space; a
    /// projection onto it for others.
    #[must_use]
    pub fn coordinates(&self, columns: &Mat<f64>) -> Mat<f64> {
        self.basis.transpose() * columns
    }

    /// Weighted node values √w_k u(α_k) of the profiles with these coordinates.
    #[must_use]
    pub fn node_values(&self, coordinates: &Mat<f64>) -> Mat<f64> {
        &self.basis * coordinates
    }

    /// Chebyshev coefficients in 2z - 1 of h, for the profiles with these coordinates.
    #[must_use]
    pub fn chebyshev(&self, coordinates: &Mat<f64>) -> Mat<f64> {
        self.triangle.partial_piv_lu().solve(coordinates)
    }
}

/// T_j(t) for t in \[-1, 1\].
fn chebyshev(j: usize, t: f64) -> f64 {
    (j as f64 * t.clamp(-1.0, 1.0).acos()).cos()
}

/// Evaluates h(z) from its Chebyshev series in 2z - 1 by Clenshaw's recurrence.
#[must_use]
pub fn evaluate(series: &[f64], z: f64) -> f64 {
    let t = 2.0 * z - 1.0;
    let (mut next, mut after) = (0.0, 0.0);
    for coefficient in series.iter().skip(1).rev() {
        (next, after) = (coefficient + 2.0 * t * next - after, next);
    }
    series.first().copied().unwrap_or(0.0) + t * next - after
}

/// The smallest number of terms whose profile stays within `tolerance` times the largest |u| of the
/// whole series, over α in \[0, π/2\].
///
/// The error is the dropped tail, evaluated on 257 slants.
#[must_use]
pub fn trimmed_length(series: &[f64], azimuth: usize, tolerance: f64) -> usize {
    let slants: Vec<(f64, f64)> = (0..=256)
        .map(|k| {
            let (sine, z) = (std::f64::consts::FRAC_PI_2 * f64::from(k) / 256.0).sin_cos();
            (z, sine.powi(azimuth as i32))
        })
        .collect();
    let largest = |series: &[f64]| {
        slants
            .iter()
            .fold(0.0, |most: f64, (z, sine)| most.max((sine * evaluate(series, *z)).abs()))
    };
    let allowed = tolerance * largest(series);
    let mut tail = vec![0.0; series.len()];
    for length in (1..series.len()).rev() {
        tail[length] = series[length];
        if largest(&tail) > allowed {
            return length + 1;
        }
    }
    1
}
