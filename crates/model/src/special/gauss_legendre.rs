//! Gauss-Legendre quadrature.

use std::f64::consts::PI;

/// `count` ascending nodes and their weights on \[low, high\], exact for polynomials of degree 2
/// `count` - 1 to a few ulp.
///
/// Newton's method on the three-term recurrence, from the usual cosine guess. It converges
/// quadratically, so a few steps reach the last bit.
#[must_use]
pub fn rule(count: usize, low: f64, high: f64) -> Vec<(f64, f64)> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    (0..count)
        .rev()
        .map(|k| {
            let mut x = (PI * (k as f64 + 0.75) / (count as f64 + 0.5)).cos();
            for _ in 0..8 {
                let (value, slope) = legendre(count, x);
                x -= value / slope;
            }
            let (_, slope) = legendre(count, x);
            (middle + half * x, half * 2.0 / ((1.0 - x * x) * slope * slope))
        })
        .collect()
}

/// P_n(x) and its derivative.
fn legendre(n: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (0.0, 1.0);
    for k in 0..n {
        let k = k as f64;
        (before, value) = (value, ((2.0 * k + 1.0) * x * value - k * before) / (k + 1.0));
    }
    (value, n as f64 * (x * value - before) / (x * x - 1.0))
}
