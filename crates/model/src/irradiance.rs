//! The irradiance modes E_lop^mq of (14): E(α, β) = f(α) Φ_m(β).

use crate::polar_integral::{PolarIntegrals, gain};
use crate::special::{spherical_harmonic, wigner, zernike};
use eigenshade_table::pair;

/// D_l^mq(α, β, 0) / Φ_m(β) of (49), for l = max(|m|, q)..=degree, q >= 0.
///
/// The values for -m are (-1)^m times those for m.
#[must_use]
pub fn slant_rotation(degree: usize, m: isize, q: usize, alpha: f64) -> Vec<f64> {
    let n = q.cast_signed();
    let plus = wigner::column(degree, m, n, alpha);
    if q == 0 {
        return plus;
    }
    let sign = if q.is_multiple_of(2) { 1.0 } else { -1.0 };
    let minus = wigner::column(degree, m, -n, alpha);
    plus.iter()
        .zip(minus)
        .map(|(plus, minus)| (plus + sign * minus) * std::f64::consts::FRAC_1_SQRT_2)
        .collect()
}

/// R_p^q(√2 sin(α/2)) for every pair up to `order`, in the order of [`pair`].
#[must_use]
pub fn slant_radials(order: usize, alpha: f64) -> Vec<f64> {
    let rho = zernike::radius(alpha);
    let mut values = vec![0.0; pair::count(order)];
    for q in 0..=order {
        for (p, value) in (q..).step_by(2).zip(zernike::column(order, q, rho)) {
            values[pair::position(p, q)] = value;
        }
    }
    values
}

/// E_lop^mq(α, β) of (14).
///
/// Domain: |m| <= l, q <= l, q <= p <= o of the same parity, α in \[0, π/2\]. The result is 0 if
/// |m| > l or q > l. Absolute error below 1e-13 up to degree 9, 5e-13 up to 32.
#[must_use]
pub fn value(l: usize, m: isize, o: usize, p: usize, q: usize, alpha: f64, beta: f64) -> f64 {
    let Some(&rotation) = slant_rotation(l, m, q, alpha).last() else {
        return 0.0;
    };
    let integrals = PolarIntegrals::new(l, o);
    let rho = zernike::radius(alpha);
    let scattered = integrals.row(o, q)[l] * zernike::value(p, q, rho)
        + integrals.row(p, q)[l] * zernike::value(o, q, rho);
    gain(o, p, q) * rotation * scattered * spherical_harmonic::azimuth(m, beta)
}
