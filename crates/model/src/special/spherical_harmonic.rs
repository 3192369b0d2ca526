//! Real spherical harmonics Y_l^m of (46), their normalized associated Legendre functions N_l^m
//! P_l^m of (43), with the Condon-Shortley phase, and their azimuth functions Φ_m of (47).

use eigenshade_table::light;
use std::f64::consts::{PI, SQRT_2};

/// Φ_m(φ) of (47), with the signed m taken literally: √2 cos mφ, 1, √2 sin mφ.
#[must_use]
pub fn azimuth(m: isize, phi: f64) -> f64 {
    let angle = m as f64 * phi;
    match m {
        0 => 1.0,
        1.. => SQRT_2 * angle.cos(),
        _ => SQRT_2 * angle.sin(),
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
    let column = legendre(l, m.unsigned_abs(), theta.cos(), theta.sin().abs());
    reflection(m) * column.last().expect("|m| <= l") * azimuth(m, phi)
}

/// All Y_l^m up to `degree` in the order of [`light`], in the unit direction
/// (x, y, z).
#[must_use]
pub fn all(degree: usize, [x, y, z]: [f64; 3]) -> Vec<f64> {
    let (sine, phi) = (x.hypot(y), y.atan2(x));
    let mut values = vec![0.0; light::count(degree)];
    for m in 0..=degree {
        let column = legendre(degree, m, z, sine);
        for order in if m == 0 { vec![0] } else { vec![m.cast_signed(), -m.cast_signed()] } {
            let factor = reflection(order) * azimuth(order, phi);
            for (l, value) in (m..).zip(&column) {
                values[light::position(l, order)] = factor * value;
            }
        }
    }
    values
}

/// N_l^m P_l^m(z) for l = m..=degree of one order m >= 0.
///
/// Domain: z in \[-1, 1\]. `sine` = √(1 - z²) in \[0, 1\] is a separate argument, so that no
/// accuracy is lost near the poles. Absolute error below 1e-13 up to degree 9, 5e-13 up to 64.
/// Empty if m > degree.
///
/// The three-term recurrence in l runs on the normalized functions and starts from N_m^m P_m^m =
/// (-1)^m √((2m+1)!! / (4π (2m)!!)) sin^m.
#[must_use]
pub fn legendre(degree: usize, m: usize, z: f64, sine: f64) -> Vec<f64> {
    let mut values = Vec::with_capacity((degree + 1).saturating_sub(m));
    if m > degree {
        return values;
    }
    let start = (1..=m).fold((0.25 / PI).sqrt(), |value, k| {
        let k = k as f64;
        -value * ((2.0 * k + 1.0) / (2.0 * k)).sqrt() * sine
    });
    values.push(start);
    let m = m as f64;
    let ratio = |l: f64| ((4.0 * l * l - 1.0) / (l * l - m * m)).sqrt();
    let (mut before, mut value) = (0.0, start);
    for l in (m as usize + 1)..=degree {
        let l = l as f64;
        let next = if l == m + 1.0 {
            ratio(l) * z * value
        } else {
            ratio(l) * (z * value - before / ratio(l - 1.0))
        };
        (before, value) = (value, next);
        values.push(value);
    }
    values
}
