//! Normalized associated Legendre functions: N_l^m P_l^m(z) of (43), with the Condon-Shortley
//! phase. Notation follows (43) and (46).

use std::f64::consts::PI;

/// N_l^m P_l^m(z) for l = m..=degree of one order m >= 0.
///
/// Domain: z in \[-1, 1\]. `sine` = √(1 - z²) in \[0, 1\] is a separate argument, so that no
/// accuracy is lost near the poles. Absolute error below 1e-13 up to degree 9, 5e-13 up to 64.
/// Empty if m > degree.
///
/// The three-term recurrence in l runs on the normalized functions and starts from N_m^m P_m^m =
/// (-1)^m √((2m+1)!! / (4π (2m)!!)) sin^m.
#[must_use]
pub fn normalized(degree: usize, m: usize, z: f64, sine: f64) -> Vec<f64> {
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
