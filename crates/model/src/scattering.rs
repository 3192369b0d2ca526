//! The scattering modes I_op^q(θ_i, θ_r, Δφ) of (8), whose sum (7) is a BRDF.
//!
//! Notation follows (8). Δφ = φ_i - φ_r is zero for backscatter and π in the mirror plane. The
//! modes are orthonormal over the pair of hemispheres under plain solid angle, dω_i dω_r, without
//! cosines: ρ = √2 sin(θ/2) maps the hemisphere to the unit disc with equal areas. The modes are
//! symmetric in θ_i and θ_r (6).

use std::f64::consts::TAU;

use crate::irradiance::slant_radials;
use eigenshade_table::{material, pair};

/// I_op^q(θ_i, θ_r, Δφ) \[1/sr per unit of b_op^q\] for every mode up to `order`, in the order of
/// [`material`].
///
/// Domain: θ_i, θ_r in \[0, π/2\], any Δφ. Orthonormal to 1e-12 up to order 12.
#[must_use]
pub fn modes(order: usize, theta_i: f64, theta_r: f64, delta_phi: f64) -> Vec<f64> {
    let cosines: Vec<f64> = (0..=order).map(|q| (q as f64 * delta_phi).cos()).collect();
    let mut values = polar_parts(order, theta_i, theta_r);
    for (value, (_, _, q)) in values.iter_mut().zip(material::indices(order)) {
        *value *= cosines[q];
    }
    values
}

/// I_op^q(θ_i, θ_r, 0): the modes of (8) without the factor cos qΔφ, in the order of [`material`].
#[must_use]
pub fn polar_parts(order: usize, theta_i: f64, theta_r: f64) -> Vec<f64> {
    let (incident, reflected) = (slant_radials(order, theta_i), slant_radials(order, theta_r));
    material::indices(order)
        .map(|(o, p, q)| {
            let (first, second) = (pair::position(o, q), pair::position(p, q));
            norm(o, p, q)
                * (incident[first] * reflected[second] + incident[second] * reflected[first])
        })
        .collect()
}

/// f(θ_i, θ_r, Δφ) of (7) in 1/sr, from the coefficients b_op^q up to `order`.
///
/// Missing coefficients count as zero.
#[must_use]
pub fn brdf(order: usize, coefficients: &[f64], theta_i: f64, theta_r: f64, delta_phi: f64) -> f64 {
    modes(order, theta_i, theta_r, delta_phi)
        .iter()
        .zip(coefficients)
        .map(|(mode, coefficient)| mode * coefficient)
        .sum()
}

/// The fraction of uniform light from all directions that a material reflects: ∫∫ f cos θ_i cos θ_r
/// dω_i dω_r / π.
///
/// Missing coefficients count as zero. The albedo of a Lambertian material is b_00^0 / 2. The
/// albedo is in \[0, 1\] for every physically possible material.
#[must_use]
pub fn albedo(coefficients: &[f64]) -> f64 {
    // With s = ρ² the cosine is 1 - s = (R_0^0 - R_2^0) / 2, and dω = 2π ds. The integral of R_o^0
    // R_p^0 over s is δ_op / (o + 1).
    let means = [(0, 0.5), (2, -1.0 / 6.0)];
    let pairs = means.iter().flat_map(|&o| means.iter().map(move |&p| (o, p)));
    let terms = pairs.filter(|((o, _), (p, _))| p <= o).map(|((o, of_o), (p, of_p))| {
        let b = coefficients.get(material::position(o, p, 0)).copied().unwrap_or(0.0);
        b * norm(o, p, 0) * of_o * of_p
    });
    4.0 * TAU * terms.sum::<f64>()
}

/// The norm of the mode: √((o+1)(p+1) / ((1+δ_op)(1+δ_q0))) / 2π.
#[must_use]
pub fn norm(o: usize, p: usize, q: usize) -> f64 {
    let doubled = |equal: bool| if equal { 2.0 } else { 1.0 };
    (((o + 1) * (p + 1)) as f64 / (doubled(o == p) * doubled(q == 0))).sqrt() / TAU
}
