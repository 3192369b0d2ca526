//! The projection of BRDFs, against what shares no code with it.

use crate::brdf::{at, ggx};
use crate::tolerances;
use eigenshade_generator::material::brdf::projection::{
    Projection, nodes, project, project_orders, project_with,
};
use eigenshade_generator::material::brdf::{Brdf, Lambertian, Measure, OrenNayar};
use eigenshade_model::scattering;
use eigenshade_table::material;
use eigenshade_testing::{largest, relative_error};
use std::f64::consts::{PI, TAU};

/// Coefficients with half as many nodes again, of the largest.
const PROJECTION_NODES: f64 = 1e-9;

/// The same for a lobe of 1e-3 rad, where rounding at grazing angles remains.
const PROJECTION_NODES_NARROW: f64 = 4e-8;

/// The energy, and the part of it that is left out: f² changes faster than f.
const ENERGY_NODES: f64 = 4e-8;

/// The same without cosines: f grows without bound to the last panel before π/2.
const PROJECTION_NODES_GRAZING: f64 = 4e-7;

/// And at roughness 1, whose f grows most there, with the fewest nodes.
const PROJECTION_NODES_ROUGH: f64 = 1e-6;

/// Coefficients against 400 midpoints an angle, of the largest: midpoints are off by 1/400² and,
/// where f grows, by ten times that.
const PROJECTION_MIDPOINT: f64 = 1e-4;

/// Energy left out against 64 midpoints in azimuth, relative: a small difference, half of it at
/// grazing angles.
const LEFT_OUT_MIDPOINT: f64 = 0.005;

/// b_00^0 = 2 albedo and nothing else, in both measures, to order 64.
#[test]
fn a_matte_material_has_one_coefficient() {
    let matte = Lambertian::new(0.8).unwrap();
    for (order, measure) in
        [(0, Measure::Projected), (64, Measure::Projected), (12, Measure::SolidAngle)]
    {
        let found = project(&matte, order, measure);
        assert_eq!(found.coefficients.len(), material::count(order));
        let worst = found
            .coefficients
            .iter()
            .enumerate()
            .map(|(k, b)| (b - if k == 0 { 1.6 } else { 0.0 }).abs())
            .fold(0.0, f64::max);
        println!("order {order}: {worst:.1e}, left out {:.1e}", found.left_out);
        assert!(worst <= tolerances::MATTE_PROJECTION, "{order}: {worst}");
        assert!(found.left_out <= tolerances::MATTE_PROJECTION);
        // ∫∫ f² cos cos dω dω = (0.8/π)² π².
        assert!((found.energy / 0.64 - 1.0).abs() <= tolerances::MATTE_PROJECTION);
    }
}

fn apart(a: &Projection, b: &Projection) -> f64 {
    relative_error(&a.coefficients, &b.coefficients)
}

/// Half as many nodes again change nothing: not even for a lobe of 1e-3 rad.
#[test]
fn the_quadrature_has_converged() {
    let matte = OrenNayar::new(0.8, 0.5).unwrap();
    let (projected, grazing) = (Measure::Projected, Measure::SolidAngle);
    let cases: [(&str, &dyn Brdf, usize, Measure, f64); 8] = [
        ("ggx 0.03", &ggx(0.03, 0.9, 0.0), 12, projected, PROJECTION_NODES_NARROW),
        ("ggx 0.1", &ggx(0.1, 0.04, 0.5), 12, projected, PROJECTION_NODES),
        ("ggx 0.3", &ggx(0.3, 0.9, 0.0), 7, projected, PROJECTION_NODES),
        ("ggx 0.5", &ggx(0.5, 0.9, 0.0), 24, projected, PROJECTION_NODES),
        ("oren-nayar", &matte, 12, projected, PROJECTION_NODES),
        ("ggx 0.5", &ggx(0.5, 0.9, 0.0), 12, grazing, PROJECTION_NODES_GRAZING),
        ("ggx 1", &ggx(1.0, 0.9, 0.0), 7, grazing, PROJECTION_NODES_ROUGH),
        ("oren-nayar", &matte, 12, grazing, PROJECTION_NODES_GRAZING),
    ];
    for (name, brdf, order, measure, allowed) in cases {
        let coarse = project(brdf, order, measure);
        let fine = project_with(brdf, order, measure, nodes(brdf, order) * 3 / 2);
        let found = apart(&coarse, &fine);
        println!("{name}, {order}, {measure:?}: {found:.1e}");
        assert!(found <= allowed, "{name}, {order}, {measure:?}: {found}");
        let apart = (coarse.left_out - fine.left_out).abs();
        assert!(apart <= allowed.max(ENERGY_NODES), "{name}, {order}: {apart} is left out");
    }
}

/// One integration for several orders gives what each order's own gives.
#[test]
fn several_orders_share_an_integration() {
    let brdf = ggx(0.3, 0.04, 0.5);
    let orders = [0, 7, 12, 3];
    let cases =
        [(Measure::Projected, PROJECTION_NODES), (Measure::SolidAngle, PROJECTION_NODES_GRAZING)];
    for (measure, allowed) in cases {
        let together = project_orders(&brdf, &orders, measure);
        assert_eq!(together.len(), orders.len());
        for (&order, together) in orders.iter().zip(&together) {
            let alone = project(&brdf, order, measure);
            assert_eq!(together.coefficients.len(), material::count(order));
            let found = apart(together, &alone);
            println!("order {order}, {measure:?}: {found:.1e}");
            assert!(found <= allowed, "{order}, {measure:?}: {found}");
            let apart = (together.left_out - alone.left_out).abs();
            assert!(apart <= allowed.max(ENERGY_NODES), "{order}: {apart} is left out");
            assert!((together.energy / alone.energy - 1.0).abs() <= ENERGY_NODES);
        }
    }
}

/// b = ∫∫ f I by a plain product of midpoint rules in cos θ and Δφ.
#[test]
fn coefficients_are_the_integrals_of_the_definition() {
    let (order, count) = (4, 400);
    let brdf = OrenNayar::new(0.8, 0.6).unwrap();
    let found = project(&brdf, order, Measure::SolidAngle);
    let mut expected = vec![0.0; material::count(order)];
    let node = |k: usize| (k as f64 + 0.5) / count as f64;
    for i in 0..count {
        for r in 0..count {
            // z = s², which keeps nodes for the growth at grazing angles.
            let (theta_i, theta_r) = (node(i).powi(2).acos(), node(r).powi(2).acos());
            let polar = scattering::polar_parts(order, theta_i, theta_r);
            let weight = 4.0 * node(i) * node(r) / (count * count) as f64;
            for k in 0..64 {
                let delta_phi = PI * (f64::from(k) + 0.5) / 64.0;
                let value = weight * TAU * TAU / 64.0 * at(&brdf, theta_i, theta_r, delta_phi);
                for ((sum, polar), (_, _, q)) in
                    expected.iter_mut().zip(&polar).zip(material::indices(order))
                {
                    *sum += value * polar * (q as f64 * delta_phi).cos();
                }
            }
        }
    }
    let found = relative_error(&found.coefficients, &expected);
    println!("against midpoints: {found:.1e}");
    assert!(found <= PROJECTION_MIDPOINT, "{found}");
}

/// The coefficients are nearest: no step along any of them is nearer. And the energy left
/// out is what midpoints find, between f and the sum of modes.
#[test]
fn projected_coefficients_are_nearest() {
    assert_nearest(&OrenNayar::new(0.8, 0.6).unwrap());
    assert_nearest(&ggx(0.8, 0.04, 0.5));
}

fn assert_nearest(brdf: &dyn Brdf) {
    let (order, count) = (5, 160);
    let found = project(brdf, order, Measure::Projected);
    let node = |k: usize| (k as f64 + 0.5) / count as f64;
    let (mut energy, mut left) = (0.0, 0.0);
    let mut gradient = vec![0.0; material::count(order)];
    for i in 0..count {
        for r in 0..count {
            // z = s², which keeps nodes for grazing angles.
            let (theta_i, theta_r) = (node(i).powi(2).acos(), node(r).powi(2).acos());
            let polar = scattering::polar_parts(order, theta_i, theta_r);
            let weight =
                4.0 * (node(i) * node(r)).powi(3) * TAU * TAU / (count * count * 64) as f64;
            for k in 0..64 {
                // δ = π s², for the narrow azimuths of lobes at grazing angles.
                let share = (f64::from(k) + 0.5) / 64.0;
                let delta_phi = PI * (1.0 - share * share);
                let weight = weight * 2.0 * share;
                let value = at(brdf, theta_i, theta_r, delta_phi);
                let modes: Vec<f64> = polar
                    .iter()
                    .zip(material::indices(order))
                    .map(|(polar, (_, _, q))| polar * (q as f64 * delta_phi).cos())
                    .collect();
                let sum: f64 = modes.iter().zip(&found.coefficients).map(|(a, b)| a * b).sum();
                energy += weight * value * value;
                left += weight * (value - sum) * (value - sum);
                for (gradient, mode) in gradient.iter_mut().zip(&modes) {
                    *gradient += weight * (value - sum) * mode;
                }
            }
        }
    }
    let steepest = largest(gradient);
    println!("left {} {}, gradient {steepest:.1e}", left / energy, found.left_out);
    assert!(steepest <= PROJECTION_MIDPOINT * energy.sqrt());
    assert!((left / energy / found.left_out - 1.0).abs() <= LEFT_OUT_MIDPOINT);
    let plain = project(brdf, order, Measure::SolidAngle);
    assert!(found.left_out < plain.left_out, "{} {}", found.left_out, plain.left_out);
}

/// More orders leave out less, down to what a kink or a narrow lobe leaves.
#[test]
fn orders_leave_out_less_and_less() {
    for brdf in [ggx(0.3, 0.04, 0.5), ggx(1.0, 0.9, 0.0)] {
        let left: Vec<f64> =
            [0, 4, 8, 16].map(|order| project(&brdf, order, Measure::Projected).left_out).into();
        assert!(left.windows(2).all(|pair| pair[1] < pair[0]), "{left:?}");
        assert!(left.iter().all(|left| (0.0..=1.0).contains(left)));
    }
}
