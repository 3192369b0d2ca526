//! BRDFs as functions to coefficients b_op^q of (7), by quadrature.
//!
//! Of all sums Σ b I the coefficients give the one nearest to f, in a [`Measure`]. Under
//! dω_i dω_r the modes (8) are orthonormal, and b_op^q = ∫∫ f I_op^q dω_i dω_r. Under
//! cos θ_i cos θ_r dω_i dω_r the same integrals, with the cosines, are the right-hand side
//! of normal equations that fall apart into small ones, one for each q.
//!
//! f does not change when the directions are turned together, exchanged or mirrored: what
//! is left to integrate is Δφ in \[0, π\] and θ_r <= θ_i. First come the integrals over Δφ
//! with cos qΔφ, then the polar angles with R_o^q R_p^q. All three rules are composite
//! ones of Gauss and Legendre whose panels shrink towards the mirror direction, where a
//! narrow lobe stands, and towards grazing angles ([`graded`]). So a lobe of 1e-3 rad costs
//! a few times what a matte surface does.

use crate::material::brdf::overlaps::Overlaps;
use crate::material::brdf::{Brdf, Geometry};
use eigenshade_index::{material, pair};
use eigenshade_model::irradiance::slant_radials;
use eigenshade_model::scattering::norm;
use eigenshade_model::special::gauss_legendre;
use eigenshade_model::special::graded::{self, Feature};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI};

/// No panel is wider, radians.
const WIDEST: f64 = FRAC_PI_8;

/// The width of the last panel before grazing angles, radians.
const GRAZING: f64 = 1e-5;
/// No panel need be narrower, radians.
const NARROWEST: f64 = 1e-9;

/// How far f and Σ b I are apart: the integral of (f - Σ b I)² under this.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Measure {
    /// cos θ_i cos θ_r dω_i dω_r: as the irradiance of a sphere sees f, the first cosine
    /// being that of (3), the second the density of the normals. Coefficients of a lower
    /// order are others, not the first of these.
    #[default]
    Projected,
    /// dω_i dω_r, in which the modes are orthonormal: b = ∫∫ f I. f of GGX and of Oren and
    /// Nayar is not square-integrable here, since it grows as 1 / (cos θ_i + cos θ_r)
    /// where both directions graze; the coefficients exist, but serve what grazes at the
    /// cost of the rest.
    SolidAngle,
}

/// A BRDF as far as an order describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Projection {
    /// b_op^q in 1/sr, in the order of [`material`].
    pub coefficients: Vec<f64>,
    /// ∫∫ f² cos θ_i cos θ_r dω_i dω_r.
    pub energy: f64,
    /// ∫∫ (f - Σ b I)² cos θ_i cos θ_r dω_i dω_r as a share of the energy, whatever the
    /// measure: what the order leaves out. 0 where the energy is; rounding leaves 1e-14.
    pub left_out: f64,
}

/// The nodes that [`project`] gives a panel.
#[must_use]
pub fn nodes(order: usize) -> usize {
    10 + order / 4
}

/// Projects up to `order`.
///
/// In [`Measure::Projected`] to 1e-7 of the largest coefficient, for GGX of roughness 0.03
/// and more and for the matte models, in [`Measure::SolidAngle`] to 1e-5. Time: some 0.3 s
/// at order 12, 2 s at 32.
#[must_use]
pub fn project(brdf: &dyn Brdf, order: usize, measure: Measure) -> Projection {
    project_with(brdf, order, measure, nodes(order))
}

/// The same with `count` nodes a panel: twice as many show how far it has converged.
#[must_use]
pub fn project_with(brdf: &dyn Brdf, order: usize, measure: Measure, count: usize) -> Projection {
    let unit = gauss_legendre::rule(count, 0.0, 1.0);
    let width = brdf.width();
    let grazing = Feature { at: FRAC_PI_2, scale: GRAZING };
    let pole = Feature { at: 0.0, scale: width };
    let mut sums = Sums::new(order);
    for (theta_i, weight_i) in graded::spread(&unit, 0.0, FRAC_PI_2, &[pole, grazing], WIDEST) {
        let ridge = Feature { at: theta_i, scale: width.min(FRAC_PI_2 - theta_i) };
        let mut row = Row::new(order);
        for (theta_r, weight_r) in graded::spread(&unit, 0.0, theta_i, &[pole, ridge], WIDEST) {
            row.add(brdf, &unit, [theta_i, theta_r], weight_r * theta_r.sin());
        }
        sums.add(&row, theta_i, weight_i * theta_i.sin());
    }
    sums.finish(measure)
}

/// Integrals over Δφ and θ_r for one θ_i.
struct Row {
    order: usize,
    /// ∫∫ f cos qΔφ R_p^q(θ_r) sin θ_r dθ_r dΔφ, in the order of [`pair`].
    plain: Vec<f64>,
    /// The same with cos θ_r.
    projected: Vec<f64>,
    /// ∫∫ f² cos θ_r sin θ_r dθ_r dΔφ.
    energy: f64,
}

impl Row {
    fn new(order: usize) -> Self {
        let zeros = vec![0.0; pair::count(order)];
        Self { order, plain: zeros.clone(), projected: zeros, energy: 0.0 }
    }

    fn add(
        &mut self,
        brdf: &dyn Brdf,
        unit: &[(f64, f64)],
        [theta_i, theta_r]: [f64; 2],
        weight: f64,
    ) {
        let (waves, square) = azimuth_integrals(brdf, self.order, unit, theta_i, theta_r);
        let cosine = theta_r.cos();
        self.energy += weight * cosine * square;
        let radials = slant_radials(self.order, theta_r);
        let both = self.plain.iter_mut().zip(&mut self.projected);
        for (((_, q), radial), (plain, projected)) in
            pair::indices(self.order).zip(&radials).zip(both)
        {
            let value = weight * waves[q] * radial;
            *plain += value;
            *projected += cosine * value;
        }
    }
}

/// ∫ f cos qΔφ dΔφ for q = 0..=order and ∫ f² dΔφ, over \[0, π\].
fn azimuth_integrals(
    brdf: &dyn Brdf,
    order: usize,
    unit: &[(f64, f64)],
    theta_i: f64,
    theta_r: f64,
) -> (Vec<f64>, f64) {
    // With δ = π - Δφ: |i + r|² (sin² θ_h + width² cos² θ_h) at δ = 0, over its growth
    // with δ², is the square of the lobe's width in δ. |i + r| = 2 cos (θ_i + θ_r)/2
    // there, and its part along the surface that times the tangent of (θ_i - θ_r)/2.
    let length = 2.0 * (0.5 * (theta_i + theta_r)).cos();
    let (sine, cosine) = (0.5 * (theta_i - theta_r)).sin_cos();
    let width = brdf.width() * cosine;
    let sines = theta_i.sin() * theta_r.sin();
    let scale = length * ((sine * sine + width * width) / sines).sqrt();
    let scale = scale.clamp(NARROWEST, PI);
    // Models may turn at Δφ = π/2; that is all the second feature is for.
    let features = [Feature { at: PI, scale }, Feature { at: FRAC_PI_2, scale: PI }];
    let mut waves = vec![0.0; order + 1];
    let mut square = 0.0;
    for (delta_phi, weight) in graded::spread(unit, 0.0, PI, &features, WIDEST) {
        let value = brdf.value(Geometry::from_angles(theta_i, theta_r, delta_phi));
        square += weight * value * value;
        // cos (q+1)x = 2 cos x cos qx - cos (q-1)x.
        let twice = 2.0 * delta_phi.cos();
        let (mut before, mut wave) = (0.5 * twice, 1.0);
        for sum in &mut waves {
            *sum += weight * value * wave;
            (before, wave) = (wave, twice * wave - before);
        }
    }
    (waves, square)
}

/// Integrals over everything.
struct Sums {
    order: usize,
    plain: Vec<f64>,
    projected: Vec<f64>,
    energy: f64,
}

impl Sums {
    fn new(order: usize) -> Self {
        let zeros = vec![0.0; material::count(order)];
        Self { order, plain: zeros.clone(), projected: zeros, energy: 0.0 }
    }

    fn add(&mut self, row: &Row, theta_i: f64, weight: f64) {
        let cosine = theta_i.cos();
        let radials = slant_radials(self.order, theta_i);
        self.energy += weight * cosine * row.energy;
        let both = self.plain.iter_mut().zip(&mut self.projected);
        for ((o, p, q), (plain, projected)) in material::indices(self.order).zip(both) {
            let (first, second) = (pair::position(o, q), pair::position(p, q));
            let of = |row: &[f64]| radials[first] * row[second] + radials[second] * row[first];
            *plain += weight * of(&row.plain);
            *projected += weight * cosine * of(&row.projected);
        }
    }

    /// 8π: the turn of both directions, the mirrored half of Δφ, the exchange.
    fn finish(mut self, measure: Measure) -> Projection {
        let factor = 8.0 * PI;
        for (place, (o, p, q)) in material::indices(self.order).enumerate() {
            let norm = factor * norm(o, p, q);
            self.plain[place] *= norm;
            self.projected[place] *= norm;
        }
        let energy = factor * self.energy;
        let overlaps = Overlaps::new(self.order);
        let coefficients = match measure {
            Measure::SolidAngle => self.plain,
            Measure::Projected => overlaps.nearest(&self.projected),
        };
        let product: f64 = coefficients.iter().zip(&self.projected).map(|(b, g)| b * g).sum();
        let left = energy - 2.0 * product + overlaps.energy(&coefficients);
        let left_out = if energy > 0.0 { (left / energy).max(0.0) } else { 0.0 };
        Projection { coefficients, energy, left_out }
    }
}
