//! Real spherical harmonics Y_l^m of (46), and azimuth functions Φ_m of (47).

use super::legendre;
use eigenshade_index::light;

/// Φ_m(φ) of (47), with the signed m taken literally: √2 cos mφ, 1, √2 sin mφ.
#[must_use]
pub fn azimuth(m: isize, phi: f64) -> f64 {
    let angle = m as f64 * phi;
    match m {
        0 => 1.0,
        1.. => std::f64::consts::SQRT_2 * angle.cos(),
        _ => std::f64::consts::SQRT_2 * angle.sin(),
    }
}

/// Factor between the Legendre functions of -m and m: N_l^-m P_l^-m = (-1)^m N_l^m P_l^m.
fn reflection(m: isize) -> f64 {
    if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 }
}

/// Y_l^m(θ, φ) of degree l and order m, |m| <= l.
///
/// Absolute error below 1e-13 up to degree 9, 5e-13 up to 64.
///
/// # Panics
///
/// If |m| > l.
#[must_use]
pub fn value(l: usize, m: isize, theta: f64, phi: f64) -> f64 {
    let column = legendre::normalized(l, m.unsigned_abs(), theta.cos(), theta.sin().abs());
    reflection(m) * column.last().expect("|m| <= l") * azimuth(m, phi)
}

/// All Y_l^m up to `degree` in the order of [`light`], in the unit direction
/// (x, y, z).
#[must_use]
pub fn all(degree: usize, [x, y, z]: [f64; 3]) -> Vec<f64> {
    let (sine, phi) = (x.hypot(y), y.atan2(x));
    let mut values = vec![0.0; light::count(degree)];
    for m in 0..=degree {
        let column = legendre::normalized(degree, m, z, sine);
        for order in if m == 0 { vec![0] } else { vec![m.cast_signed(), -m.cast_signed()] } {
            let factor = reflection(order) * azimuth(order, phi);
            for (l, legendre) in (m..).zip(&column) {
                values[light::position(l, order)] = factor * legendre;
            }
        }
    }
    values
}
