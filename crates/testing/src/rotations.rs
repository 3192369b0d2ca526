//! Rotations as matrices, and irradiance in a rotated frame.

use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::special::zernike;
use eigenshade_table::{light, material};
use std::f64::consts::PI;

/// ∫ L f cos θ_i dω_i in the local frame, with f of (8) and the view at (θ_r, φ_r).
pub fn irradiance(
    integrals: &PolarIntegrals,
    local: &[f64],
    (order, coefficients): (usize, &[f64]),
    theta_r: f64,
    phi_r: f64,
) -> f64 {
    let degree = (local.len() as f64).sqrt() as usize - 1;
    let rho = zernike::radius(theta_r);
    let mut sum = 0.0;
    for ((o, p, q), b) in material::indices(order).zip(coefficients) {
        let doubled = |equal: bool| if equal { 2.0 } else { 1.0 };
        let norm =
            (((o + 1) * (p + 1)) as f64 / (doubled(o == p) * doubled(q == 0))).sqrt() / (2.0 * PI);
        let (of_p, of_o) = (zernike::value(p, q, rho), zernike::value(o, q, rho));
        for l in q..=degree {
            let polar = integrals.row(o, q)[l] * of_p + integrals.row(p, q)[l] * of_o;
            let m = q.cast_signed();
            let around = if q == 0 {
                2.0 * PI * local[light::position(l, 0)]
            } else {
                // ∫ √2 cos qφ cos q(φ - φ_r) and ∫ √2 sin(-qφ) cos q(φ - φ_r); the Legendre
                // function of the second includes (-1)^q.
                let (sine, cosine) = (q as f64 * phi_r).sin_cos();
                let sign = if q % 2 == 0 { 1.0 } else { -1.0 };
                2f64.sqrt()
                    * PI
                    * (cosine * local[light::position(l, m)]
                        - sign * sine * local[light::position(l, -m)])
            };
            sum += b * norm * polar * around;
        }
    }
    sum
}

pub fn rotation([alpha, beta, gamma]: [f64; 3]) -> Rotation {
    Rotation { alpha, beta, gamma }
}

pub fn product(a: [[f64; 3]; 3], b: [[f64; 3]; 3]) -> [[f64; 3]; 3] {
    a.map(|row| [0, 1, 2].map(|k| (0..3).map(|i| row[i] * b[i][k]).sum()))
}

/// The Euler angles of a rotation matrix. If the first and the last rotation share an axis, the
/// last angle is 0.
pub fn euler(matrix: [[f64; 3]; 3]) -> Rotation {
    let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = matrix;
    let sine = xz.hypot(yz);
    if sine < 1e-6 {
        let beta = if zz > 0.0 { (yx - xy).atan2(xx + yy) } else { (-yx - xy).atan2(yy - xx) };
        return Rotation { alpha: sine.atan2(zz), beta, gamma: 0.0 };
    }
    Rotation { alpha: sine.atan2(zz), beta: yz.atan2(xz), gamma: zy.atan2(-zx) }
}
