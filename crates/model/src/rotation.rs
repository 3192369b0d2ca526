//! Rotation of real spherical harmonics: D_l^mn(α, β, γ) of (5), all nine sign
//! cases.
//!
//! R = Rz(β) Ry(α) Rz(γ). From (44), (45) and (48); with s = mβ + nγ and
//! t = mβ - nγ for n > 0:
//!
//! | | n > 0 | n = 0 | column -n, n > 0 |
//! |---|---|---|---|
//! | m > 0 | P^mn cos s + (-1)^n P^m,-n cos t | √2 P^m0 cos mβ | (-1)^n P^mn sin s - P^m,-n sin t |
//! | m = 0 | √2 P^0n cos nγ | P^00 | (-1)^n √2 P^0n sin nγ |
//! | m < 0 | P^mn sin s + (-1)^n P^m,-n sin t | √2 P^m0 sin mβ | -(-1)^n P^mn cos s + P^m,-n cos t |

use crate::special::wigner;
use eigenshade_table::light;
use std::f64::consts::SQRT_2;

/// Euler angles, radians: R = Rz(`beta`) Ry(`alpha`) Rz(`gamma`).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rotation {
    /// Angle about y, applied second.
    pub alpha: f64,
    /// Angle about z, applied last.
    pub beta: f64,
    /// Angle about z, applied first.
    pub gamma: f64,
}

impl Rotation {
    /// R as a row-major matrix.
    #[must_use]
    pub fn matrix(self) -> [[f64; 3]; 3] {
        let (sa, ca) = self.alpha.sin_cos();
        let (sb, cb) = self.beta.sin_cos();
        let (sg, cg) = self.gamma.sin_cos();
        [
            [cb * ca * cg - sb * sg, -cb * ca * sg - sb * cg, cb * sa],
            [sb * ca * cg + cb * sg, -sb * ca * sg + cb * cg, sb * sa],
            [-sa * cg, sa * sg, ca],
        ]
    }

    /// D_l^mn for l = max(|m|, |n|)..=degree.
    #[must_use]
    pub fn column(self, degree: usize, m: isize, n: isize) -> Vec<f64> {
        let size = n.abs();
        let plus = wigner::column(degree, m, size, self.alpha);
        let minus = wigner::column(degree, m, -size, self.alpha);
        let [a, b] = self.azimuth_factors(m, n);
        plus.iter().zip(&minus).map(|(plus, minus)| a * plus + b * minus).collect()
    }

    /// The factors of P^m,|n| and P^m,-|n| in D^mn.
    fn azimuth_factors(self, m: isize, n: isize) -> [f64; 2] {
        let size = n.abs() as f64;
        let (sum, difference) =
            (m as f64 * self.beta + size * self.gamma, m as f64 * self.beta - size * self.gamma);
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        match (m.signum(), n.signum()) {
            (1, 1) => [sum.cos(), sign * difference.cos()],
            (1, 0) => [SQRT_2 * sum.cos(), 0.0],
            (1, _) => [sign * sum.sin(), -difference.sin()],
            (0, 1) => [SQRT_2 * sum.cos(), 0.0],
            (0, 0) => [1.0, 0.0],
            (0, _) => [sign * SQRT_2 * sum.sin(), 0.0],
            (_, 1) => [sum.sin(), sign * difference.sin()],
            (_, 0) => [SQRT_2 * sum.sin(), 0.0],
            (_, _) => [-sign * sum.cos(), difference.cos()],
        }
    }

    /// The coefficients of the light rotated by R: L'(Rω) = L(ω), so L'_m = Σ_n D_l^mn L_n.
    ///
    /// `light` and the result have (degree + 1)² coefficients in the order of
    /// [`eigenshade_table::light`]. The rotation is orthogonal, so it preserves the energy of each
    /// degree.
    #[must_use]
    pub fn turn(self, degree: usize, light: &[f64]) -> Vec<f64> {
        self.apply(degree, light, |m, n| (m, n))
    }

    /// The coefficients of the light rotated back by R^-1: L'(ω) = L(Rω), (5).
    #[must_use]
    pub fn turn_back(self, degree: usize, light: &[f64]) -> Vec<f64> {
        self.apply(degree, light, |m, n| (n, m))
    }

    fn apply(
        self,
        degree: usize,
        light: &[f64],
        roles: impl Fn(isize, isize) -> (isize, isize),
    ) -> Vec<f64> {
        let mut turned = vec![0.0; light::count(degree)];
        let top = degree.cast_signed();
        for m in -top..=top {
            for n in -top..=top {
                let (to, from) = roles(m, n);
                let lowest = m.unsigned_abs().max(n.unsigned_abs());
                for (l, d) in (lowest..).zip(self.column(degree, m, n)) {
                    turned[light::position(l, to)] += d * light[light::position(l, from)];
                }
            }
        }
        turned
    }
}
