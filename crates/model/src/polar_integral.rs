//! The polar integral C_lo^q of (11), times the normalization N_l^q of the harmonics, and the gain
//! K_lop^q of (13) without that factor.

use crate::special::quadrature::gauss_legendre;
use crate::special::spherical_harmonic::legendre;
use crate::special::zernike;
use eigenshade_table::pair;

/// N_l^q C_lo^q for every pair (o, q) up to an order and every l up to a degree.
///
/// At high degree N_l^q alone underflows and C_lo^q alone overflows, so only the product is
/// computed. Absolute error below 2e-14 up to degree and order 64.
#[derive(Clone, Debug, PartialEq)]
pub struct PolarIntegrals {
    degree: usize,
    values: Vec<f64>,
}

impl PolarIntegrals {
    /// All integrals up to `degree` l and `order` o.
    ///
    /// Uses Gauss-Legendre quadrature in z = cos θ on \[0, 1\]. With ρ² = 1 - z the integrand is
    /// (1 - z)^q (1 + z)^(q/2) times a polynomial of degree l - q + (o - q)/2 + 1. The quadrature
    /// is exact for even q. For odd q the branch point at z = -1 is so far away that 24 nodes more
    /// than the polynomial needs make the error negligible.
    #[must_use]
    pub fn new(degree: usize, order: usize) -> Self {
        let mut values = vec![0.0; pair::count(order) * (degree + 1)];
        for (z, weight) in gauss_legendre((degree + order) / 2 + 26, 0.0, 1.0) {
            let (rho, sine) = ((1.0 - z).sqrt(), ((1.0 - z) * (1.0 + z)).sqrt());
            for q in 0..=order.min(degree) {
                let harmonics = legendre(degree, q, z, sine);
                for (o, radial) in (q..).step_by(2).zip(zernike::column(order, q, rho)) {
                    let row = pair::position(o, q) * (degree + 1);
                    for (l, harmonic) in (q..).zip(&harmonics) {
                        values[row + l] += weight * z * radial * harmonic;
                    }
                }
            }
        }
        Self { degree, values }
    }

    /// N_l^q C_lo^q of the pair (o, q) for l = 0..=degree; 0 for l < q.
    #[must_use]
    pub fn row(&self, o: usize, q: usize) -> &[f64] {
        let start = pair::position(o, q) * (self.degree + 1);
        &self.values[start..=start + self.degree]
    }

    /// All rows, in the order of [`pair`].
    #[must_use]
    pub fn rows(&self) -> &[f64] {
        &self.values
    }
}

/// C_lo^q of (11) itself, without N_l^q.
///
/// Domain: q <= l, q <= o, o - q even. Relative to N_l^q C as accurate as [`PolarIntegrals`]. The
/// value overflows to infinity where |C| exceeds f64, beyond degree 64.
#[must_use]
pub fn value(l: usize, o: usize, q: usize) -> f64 {
    PolarIntegrals::new(l, o).row(o, q)[l] / normalization(l, q)
}

/// N_l^q of (43), for q >= 0.
#[must_use]
pub fn normalization(l: usize, q: usize) -> f64 {
    let ratio: f64 = (l - q + 1..=l + q).map(|k| (k as f64).sqrt().recip()).product();
    ((2 * l + 1) as f64 / (4.0 * std::f64::consts::PI)).sqrt() * ratio
}

/// K_lop^q / N_l^q = (-1)^q √((o+1)(p+1) / (2 (1 + δ_op))).
#[must_use]
pub fn gain(o: usize, p: usize, q: usize) -> f64 {
    let doubled = if o == p { 4.0 } else { 2.0 };
    let size = (((o + 1) * (p + 1)) as f64 / doubled).sqrt();
    if q.is_multiple_of(2) { size } else { -size }
}
