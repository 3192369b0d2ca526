//! Projects BRDF functions to coefficients b_op^q of (7), by quadrature.
//!
//! The coefficients give the sum Σ b I that is nearest to f in a [`Measure`]. Under dω_i dω_r the
//! modes (8) are orthonormal, and b_op^q = ∫∫ f I_op^q dω_i dω_r. Under cos θ_i cos θ_r dω_i dω_r,
//! the same integrals with the cosines are the right-hand side of normal equations, which split
//! into small systems, one for each q.
//!
//! f does not change when the directions are rotated together, exchanged or mirrored. So it is
//! enough to integrate over Δφ in \[0, π\] and θ_r <= θ_i: first over Δφ with cos qΔφ, then over
//! the polar angles with R_o^q R_p^q. All three rules are composite Gauss-Legendre rules whose
//! panels shrink toward the mirror direction, where a narrow lobe peaks, and toward grazing angles
//! ([`spread`]). A lobe of 1e-3 rad therefore costs only a few times as much as a matte surface.

use crate::material::brdf::overlaps::Overlaps;
use crate::material::brdf::{Brdf, Slants};
use eigenshade_model::irradiance::slant_radials;
use eigenshade_model::scattering::norm;
use eigenshade_model::special::quadrature::{Feature, gauss_legendre, spread};
use eigenshade_model::task::checkpoint;
use eigenshade_table::{material, pair};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_8, PI};

/// Width of the widest panel, in radians.
const WIDEST: f64 = FRAC_PI_8;

/// Width of the last panel before grazing angles, in radians.
const GRAZING: f64 = 1e-5;
/// Width below which panels need not shrink, in radians.
const NARROWEST: f64 = 1e-9;

/// Number of nodes in azimuth that are summed at once.
const LANES: usize = 4;

/// The distance between f and Σ b I: the integral of (f - Σ b I)² under this measure.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Measure {
    /// cos θ_i cos θ_r dω_i dω_r, the weight that f has in the irradiance of a sphere: the first
    /// cosine is that of (3), the second the density of the normals. Coefficients of a lower order
    /// differ from the first coefficients of a higher one.
    #[default]
    Projected,
    /// dω_i dω_r, in which the modes are orthonormal: b = ∫∫ f I. For GGX and Oren-Nayar f is not
    /// square-integrable here, since it grows as 1 / (cos θ_i + cos θ_r) where both directions
    /// graze. The coefficients exist, but favor grazing directions at the expense of the rest.
    SolidAngle,
}

/// The approximation of a BRDF at one order.
#[derive(Clone, Debug, PartialEq)]
pub struct Projection {
    /// b_op^q in 1/sr, in the order of [`material`].
    pub coefficients: Vec<f64>,
    /// ∫∫ f² cos θ_i cos θ_r dω_i dω_r.
    pub energy: f64,
    /// ∫∫ (f - Σ b I)² cos θ_i cos θ_r dω_i dω_r as a fraction of the energy, for either measure:
    /// the part that the order leaves out. 0 if the energy is 0; rounding leaves 1e-14.
    pub left_out: f64,
}

/// Number of nodes that [`project`] uses in each panel. In [`Measure::Projected`], GGX of roughness
/// 0.1 or more is then within 1e-9 of the largest coefficient; below, rounding leaves 1e-7. BRDFs
/// with kinks converge slowly and take more.
#[must_use]
pub fn nodes(brdf: &dyn Brdf, order: usize) -> usize {
    if brdf.is_smooth() { (6 + order / 4).max(8) } else { 10 + order / 4 }
}

/// Projects a BRDF up to `order`.
///
/// Error relative to the largest coefficient, for GGX of roughness 0.03 or more and the matte
/// models: 1e-7 in [`Measure::Projected`], 1e-5 in [`Measure::SolidAngle`]. Time for GGX: 0.1 to
/// 0.2 s at order 12, 1 to 2 s at 32.
#[must_use]
pub fn project(brdf: &dyn Brdf, order: usize, measure: Measure) -> Projection {
    project_with(brdf, order, measure, nodes(brdf, order))
}

/// Projects a BRDF up to each of these orders, with the nodes of the highest: one integration
/// serves all orders.
#[must_use]
pub fn project_orders(brdf: &dyn Brdf, orders: &[usize], measure: Measure) -> Vec<Projection> {
    let highest = orders.iter().copied().max().unwrap_or(0);
    let sums = integrated(brdf, highest, nodes(brdf, highest));
    orders.iter().map(|&order| sums.projection(order, measure)).collect()
}

/// Like [`project`], with `count` nodes per panel. Compare with twice as many to check convergence.
#[must_use]
pub fn project_with(brdf: &dyn Brdf, order: usize, measure: Measure, count: usize) -> Projection {
    integrated(brdf, order, count).projection(order, measure)
}

/// The integrals up to `order`.
pub(super) fn integrated(brdf: &dyn Brdf, order: usize, count: usize) -> Sums {
    let unit = gauss_legendre(count, 0.0, 1.0);
    let width = brdf.width();
    let grazing = Feature { at: FRAC_PI_2, scale: GRAZING };
    let pole = Feature { at: 0.0, scale: width };
    let mut sums = Sums::new(order);
    for (theta_i, weight_i) in spread(&unit, 0.0, FRAC_PI_2, &[pole, grazing], WIDEST) {
        checkpoint();
        let ridge = Feature { at: theta_i, scale: width.min(FRAC_PI_2 - theta_i) };
        let mut row = Row::new(order);
        for (theta_r, weight_r) in spread(&unit, 0.0, theta_i, &[pole, ridge], WIDEST) {
            row.add(brdf, &unit, [theta_i, theta_r], weight_r * theta_r.sin());
        }
        sums.add(&row, theta_i, weight_i * theta_i.sin());
    }
    sums
}

/// Integrals over Δφ and θ_r for one θ_i.
struct Row {
    order: usize,
    /// ∫∫ f cos qΔφ R_p^q(θ_r) sin θ_r dθ_r dΔφ, in the order of [`pair`].
    plain: Vec<f64>,
    /// The same with an additional factor cos θ_r.
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

/// ∫ f cos qΔφ dΔφ for q = 0..=order, and ∫ f² dΔφ, over \[0, π\].
fn azimuth_integrals(
    brdf: &dyn Brdf,
    order: usize,
    unit: &[(f64, f64)],
    theta_i: f64,
    theta_r: f64,
) -> (Vec<f64>, f64) {
    // With δ = π - Δφ, the square of the lobe's width in δ is |i + r|² (sin² θ_h + width² cos² θ_h)
    // at δ = 0, divided by its growth with δ². There |i + r| = 2 cos (θ_i + θ_r)/2, and its part
    // along the surface is that times the tangent of (θ_i - θ_r)/2.
    let length = 2.0 * (0.5 * (theta_i + theta_r)).cos();
    let (sine, cosine) = (0.5 * (theta_i - theta_r)).sin_cos();
    let width = brdf.width() * cosine;
    let sines = theta_i.sin() * theta_r.sin();
    let scale = length * ((sine * sine + width * width) / sines).sqrt();
    let scale = scale.clamp(NARROWEST, PI);
    // The second feature is there because models may have a kink at Δφ = π/2.
    let features = [Feature { at: PI, scale }, Feature { at: FRAC_PI_2, scale: PI }];
    let mut waves = vec![[0.0; LANES]; order + 1];
    let mut square = 0.0;
    let slants = Slants::new(theta_i, theta_r);
    for nodes in spread(unit, 0.0, PI, &features, WIDEST).chunks(LANES) {
        // cos (q+1)x = 2 cos x cos qx - cos (q-1)x, for several nodes at once: each value waits for
        // the one before it.
        let (mut twice, mut factors) = ([0.0; LANES], [0.0; LANES]);
        for ((twice, factor), (delta_phi, weight)) in twice.iter_mut().zip(&mut factors).zip(nodes)
        {
            let (at, cosine) = slants.at(*delta_phi);
            let value = brdf.value(at);
            square += weight * value * value;
            (*twice, *factor) = (2.0 * cosine, weight * value);
        }
        let (mut before, mut now) = (twice.map(|twice| 0.5 * twice), [1.0; LANES]);
        for sums in &mut waves {
            for lane in 0..LANES {
                sums[lane] += factors[lane] * now[lane];
                (before[lane], now[lane]) = (now[lane], twice[lane] * now[lane] - before[lane]);
            }
        }
    }
    (waves.iter().map(|sums| sums.iter().sum()).collect(), square)
}

/// The accumulated integrals.
pub(super) struct Sums {
    order: usize,
    plain: Vec<f64>,
    projected: Vec<f64>,
    energy: f64,
}

impl Sums {
    /// The integrals of k + a f, from those of f and of 1.
    pub(super) fn of_share(&self, of_one: &Self, [k, a]: [f64; 2]) -> Self {
        let sum = |f: &[f64], one: &[f64]| -> Vec<f64> {
            f.iter().zip(one).map(|(f, one)| k * one + a * f).collect()
        };
        // ∫∫ f: the first mode is a constant.
        let [radial, ..] = slant_radials(0, 0.0)[..] else { unreachable!("order 0 has one") };
        let of_f = self.projected[0] / (2.0 * radial * radial);
        Self {
            order: self.order,
            plain: sum(&self.plain, &of_one.plain),
            projected: sum(&self.projected, &of_one.projected),
            energy: k * k * of_one.energy + 2.0 * k * a * of_f + a * a * self.energy,
        }
    }

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

    /// The projection of an order up to that of the sums.
    ///
    /// The factor 8π combines the rotation of both directions, the mirrored half of Δφ and the
    /// exchange.
    pub(super) fn projection(&self, order: usize, measure: Measure) -> Projection {
        let factor = 8.0 * PI;
        let scaled = |sums: &[f64]| -> Vec<f64> {
            let modes = material::indices(order).zip(sums);
            modes.map(|((o, p, q), sum)| factor * norm(o, p, q) * sum).collect()
        };
        let (projected, energy) = (scaled(&self.projected), factor * self.energy);
        let overlaps = Overlaps::new(order);
        let coefficients = match measure {
            Measure::SolidAngle => scaled(&self.plain),
            Measure::Projected => overlaps.nearest(&projected),
        };
        let product: f64 = coefficients.iter().zip(&projected).map(|(b, g)| b * g).sum();
        let left = energy - 2.0 * product + overlaps.energy(&coefficients);
        let left_out = if energy > 0.0 { (left / energy).max(0.0) } else { 0.0 };
        Projection { coefficients, energy, left_out }
    }
}
