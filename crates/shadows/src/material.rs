//! Materials whose transports are integrated: formulas, or series of coefficients.

use eigenshade_generator::material::brdf::{Brdf, Geometry};
use eigenshade_model::scattering::norm;
use eigenshade_model::special::zernike;
use eigenshade_table::material;

/// One channel of a material.
#[derive(Clone, Copy)]
pub enum Material<'a> {
    /// A BRDF by a formula.
    Formula(&'a dyn Brdf),
    /// The coefficients of a BRDF, up to some order.
    Series(&'a [f64]),
}

/// A material seen from one angle.
pub(crate) enum Seen<'a> {
    Formula(&'a dyn Brdf),
    /// For each q the coefficients of ρ^q, ρ^(q + 2), ... in front of cos qΔφ.
    Series(Vec<Vec<f64>>),
}

impl<'a> Material<'a> {
    /// The material as seen at an angle with this cosine.
    pub(crate) fn seen(&self, cosine: f64) -> Seen<'a> {
        match *self {
            Self::Formula(brdf) => Seen::Formula(brdf),
            Self::Series(coefficients) => Seen::Series(series(coefficients, cosine)),
        }
    }
}

impl Seen<'_> {
    pub(crate) fn value(&self, at: Geometry) -> f64 {
        match self {
            Self::Formula(brdf) => brdf.value(at),
            Self::Series(series) => {
                let square = 1.0 - at.incident;
                let (radius, cosine) = (square.max(0.0).sqrt(), at.azimuth_cosine());
                let (mut power, mut sum) = (1.0, 0.0);
                // T_q and T_(q - 1) of the cosine.
                let (mut now, mut before) = (1.0, cosine);
                for of_q in series {
                    let value = of_q.iter().rev().fold(0.0, |sum, one| sum * square + one);
                    sum += power * now * value;
                    power *= radius;
                    (now, before) = (2.0 * cosine * now - before, now);
                }
                sum
            }
        }
    }
}

/// Σ_op norm b_op^q (R_o^q(ρ) R_p^q(ρ_r) + R_p^q(ρ) R_o^q(ρ_r)) as polynomials in ρ.
fn series(coefficients: &[f64], cosine: f64) -> Vec<Vec<f64>> {
    let order = (0..).find(|&order| material::count(order) >= coefficients.len()).unwrap_or(0);
    let seen = (1.0 - cosine).max(0.0).sqrt();
    let mut series: Vec<Vec<f64>> =
        (0..=order).map(|q| vec![0.0; (order - q) / 2 + 1]).collect();
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
            let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
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
                let seen = Material::Series(coefficients).seen(f64::cos(theta_r));
                let expected = brdf(order, coefficients, theta_i, theta_r, phi);
                let found = seen.value(at);
                // At θ_i = 0 the azimuth is not defined, and only q = 0 is left.
                assert!((found - expected).abs() < 1e-9, "{order}: {found} {expected}");
            }
        }
    }
}
