//! Materials whose transports are integrated: formulas, or series of coefficients.

use eigenshade_generator::material::brdf::{Brdf, Geometry};
use eigenshade_model::scattering::{self, norm};
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_model::special::zernike;
use eigenshade_table::material;
use std::f64::consts::PI;

/// One channel of a material.
#[derive(Clone, Copy)]
pub enum Material<'a> {
    /// A BRDF by a formula.
    Formula(&'a dyn Brdf),
    /// The coefficients of a BRDF, to an order of at most 16; those beyond are ignored.
    Series(&'a [f64]),
}

impl Material<'_> {
    /// The share of uniform light that it reflects, from 0 to 1: ∫∫ f cos θ_i cos θ_r dω_i dω_r / π.
    #[must_use]
    pub fn albedo(&self) -> f64 {
        let albedo = match self {
            Self::Formula(brdf) => integrated(*brdf),
            Self::Series(coefficients) => scattering::albedo(coefficients),
        };
        albedo.clamp(0.0, 1.0)
    }
}

/// By Gauss-Legendre quadrature in the squares of the sines, and equal steps in azimuth.
fn integrated(brdf: &dyn Brdf) -> f64 {
    const AZIMUTHS: usize = 96;
    let nodes = gauss_legendre(48, 0.0, 1.0);
    let mut sum = 0.0;
    for (a, first) in &nodes {
        for (b, second) in &nodes {
            let of_azimuth = (0..AZIMUTHS).map(|k| {
                let azimuth = PI * (k as f64 + 0.5) / AZIMUTHS as f64;
                brdf.value(Geometry::from_angles(a.sqrt().asin(), b.sqrt().asin(), azimuth))
            });
            sum += first * second * of_azimuth.sum::<f64>();
        }
    }
    // cos θ sin θ dθ = d(sin² θ) / 2, for both directions and both azimuths.
    PI * sum / AZIMUTHS as f64
}

/// The largest order of a series.
pub const MOST_ORDER: usize = 16;

/// The terms in ρ and cos qΔφ of that order.
const MOST_TERMS: usize = 81;

/// Materials seen from one angle.
pub(crate) struct Seen<'a> {
    formulas: Vec<(usize, &'a dyn Brdf)>,
    /// For each material by a series its number, and the coefficients of ρ^q, ρ^(q + 2), ... in front
    /// of cos qΔφ, for q = 0, 1, ... to the largest order.
    series: Vec<(usize, Vec<f64>)>,
    order: usize,
}

impl<'a> Seen<'a> {
    /// Materials at an angle with this cosine.
    pub(crate) fn new(materials: &[Material<'a>], cosine: f64) -> Self {
        let orders = materials.iter().map(|material| match material {
            Material::Formula(_) => 0,
            Material::Series(coefficients) => order(coefficients),
        });
        let order = orders.max().unwrap_or(0);
        let mut seen = Self { formulas: Vec::new(), series: Vec::new(), order };
        for (number, material) in materials.iter().enumerate() {
            match material {
                Material::Formula(brdf) => seen.formulas.push((number, *brdf)),
                Material::Series(coefficients) => {
                    let series = series(order, coefficients, cosine);
                    seen.series.push((number, series.concat()));
                }
            }
        }
        seen
    }

    /// The BRDF of each material.
    #[inline]
    pub(crate) fn values(&self, at: Geometry, values: &mut [f64]) {
        for (number, brdf) in &self.formulas {
            values[*number] = brdf.value(at);
        }
        if self.series.is_empty() {
            return;
        }
        let square = (1.0 - at.incident).max(0.0);
        let (radius, cosine) = (square.sqrt(), at.azimuth_cosine());
        let (mut terms, mut count) = ([0.0; MOST_TERMS], 0);
        // ρ^q, and T_q and T_(q - 1) of the cosine.
        let (mut power, mut now, mut before) = (1.0, 1.0, cosine);
        for q in 0..=self.order {
            let mut term = power * now;
            for _ in 0..=(self.order - q) / 2 {
                terms[count] = term;
                term *= square;
                count += 1;
            }
            power *= radius;
            (now, before) = (2.0 * cosine * now - before, now);
        }
        for (number, series) in &self.series {
            values[*number] = series.iter().zip(&terms).map(|(a, b)| a * b).sum();
        }
    }
}

/// The order of a number of coefficients, at most [`MOST_ORDER`].
pub(crate) fn order(coefficients: &[f64]) -> usize {
    let fits = |&order: &usize| material::count(order) >= coefficients.len();
    (0..MOST_ORDER).find(fits).unwrap_or(MOST_ORDER)
}

/// Σ_op norm b_op^q (R_o^q(ρ) R_p^q(ρ_r) + R_p^q(ρ) R_o^q(ρ_r)) as polynomials in ρ.
fn series(order: usize, coefficients: &[f64], cosine: f64) -> Vec<Vec<f64>> {
    let seen = (1.0 - cosine).max(0.0).sqrt();
    let mut series: Vec<Vec<f64>> = (0..=order).map(|q| vec![0.0; (order - q) / 2 + 1]).collect();
    let seen: Vec<Vec<f64>> = (0..=order).map(|q| zernike::column(order, q, seen)).collect();
    for ((o, p, q), coefficient) in material::indices(order).zip(coefficients) {
        let factor = norm(o, p, q) * coefficient;
        let of = |o: usize| seen[q][(o - q) / 2];
        for (own, other) in [(o, of(p)), (p, of(o))] {
            for (to, term) in series[q].iter_mut().zip(radial(own, q)) {
                *to += factor * other * term;
            }
        }
    }
    series
}

/// The coefficients of R_o^q in ρ^q, ρ^(q + 2), ...
fn radial(o: usize, q: usize) -> Vec<f64> {
    let factorial = |n: usize| (1..=n).map(|k| k as f64).product::<f64>();
    let pairs = (o - q) / 2;
    (0..=pairs)
        .map(|from_below| {
            let k = pairs - from_below;
            let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            let below = factorial(k) * factorial((o + q) / 2 - k) * factorial(pairs - k);
            sign * factorial(o - k) / below
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use eigenshade_model::scattering::brdf;

    #[test]
    fn series_are_those_of_the_modes() {
        let coefficients: Vec<f64> =
            (0..material::count(12)).map(|k| ((k * k) as f64).sin() / (1.0 + k as f64)).collect();
        for (order, count) in [(0, 1), (7, material::count(7)), (12, material::count(12))] {
            let coefficients = &coefficients[..count];
            for (theta_i, theta_r, phi) in [(0.3, 1.1, 2.0), (1.5, 0.2, 0.0), (0.0, 0.7, 0.5)] {
                let at = Geometry::from_angles(theta_i, theta_r, phi);
                let seen = Seen::new(&[Material::Series(coefficients)], f64::cos(theta_r));
                let expected = brdf(order, coefficients, theta_i, theta_r, phi);
                let mut found = [0.0];
                seen.values(at, &mut found);
                let [found] = found;
                // At θ_i = 0 the azimuth is not defined, and only q = 0 is left.
                assert!((found - expected).abs() < 1e-9, "{order}: {found} {expected}");
            }
        }
    }
}
