//! Zernike radial polynomials R_o^q(ρ), as in (8).

/// R_o^q(ρ) for o = q, q + 2, ..., <= order.
///
/// Domain: ρ in \[0, 1\]. Absolute error below 1e-13 up to order 9, 5e-13 up to 64. Empty if q >
/// order.
///
/// R_{q+2k}^q = (-1)^k ρ^q P_k^(q,0)(1 - 2ρ²), by the three-term recurrence of the Jacobi
/// polynomials, starting from ρ^q.
#[must_use]
pub fn column(order: usize, q: usize, rho: f64) -> Vec<f64> {
    if q > order {
        return Vec::new();
    }
    let mut values = Vec::with_capacity((order - q) / 2 + 1);
    let x = 1.0 - 2.0 * rho * rho;
    let a = q as f64;
    let (mut before, mut value) = (0.0, rho.powi(q as i32));
    for k in 0..=(order - q) / 2 {
        values.push(if k % 2 == 0 { value } else { -value });
        // From P_k to P_k+1, with n = k + 1 in the usual notation and b = 0.
        let n = k as f64 + 1.0;
        let next = if k == 0 {
            0.5 * ((a + 2.0) * x + a) * value
        } else {
            let s = 2.0 * n + a;
            ((s - 1.0) * (s * (s - 2.0) * x + a * a) * value
                - 2.0 * (n + a - 1.0) * (n - 1.0) * s * before)
                / (2.0 * n * (n + a) * (s - 2.0))
        };
        (before, value) = (value, next);
    }
    values
}

/// R_o^q(ρ) of one order; 0 if q > o or o - q is odd.
#[must_use]
pub fn value(o: usize, q: usize, rho: f64) -> f64 {
    if q > o || (o - q) % 2 == 1 {
        return 0.0;
    }
    column(o, q, rho).last().copied().unwrap_or(0.0)
}

/// The radius ρ in (8) of a direction with polar angle θ: √2 sin(θ/2), from 0 at the normal to 1 at
/// the rim.
#[must_use]
pub fn radius(theta: f64) -> f64 {
    std::f64::consts::SQRT_2 * (0.5 * theta).sin()
}
