//! Rotations of light and view together.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_index::light;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::truth::Truth;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::rotations::{euler, irradiance, product, rotation};
use eigenshade_testing::{fixtures, largest};
use std::f64::consts::PI;

/// Error, relative to the peak, of applying a third angle to the light alone: this changes the
/// light by some percent.
const NAIVE_FRAME: f64 = 0.01;

pub const COMPOSITION: Case = Case {
    name: "light and normals' frames turned together, degree 64, half turns and tiny angles",
    naively: "D by sums of factorials; angles by acos, and a division by sin α at the poles",
    here: "D by recurrence in l from closed forms; angles by atan2",
    measure: composition,
};

pub const TOGETHER: Case = Case {
    name: "local frames with any third angle γ: an isotropic material must not feel it",
    naively: "a wrong sign in one of the nine cases of D shows only where γ is not 0",
    here: "all nine cases of D; γ moves light and view alike",
    measure: third_angle,
};

const DEGREE: usize = 64;

/// Rotating by R and then by Q equals rotating by QR; and frame R sees in a light what frame QR
/// sees in the light rotated by Q.
fn composition() -> Vec<Figure> {
    let mut numbers = Numbers(64);
    let given: Vec<f64> =
        light::indices(DEGREE).map(|(l, _)| numbers.next() / (1.0 + l as f64)).collect();
    let angles = [
        ([0.7, -2.1, 1.3], [2.9, 0.4, -0.8]),
        ([1e-9, 1.0, 0.5], [1.5, 3.0, 2.9]),
        ([PI, 0.3, 0.2], [1e-5, -1.1, 2.0]),
        ([0.5 * PI, 2.2, -2.8], [0.5 * PI, -0.6, 1.9]),
    ];
    let (mut worst, mut seen) = (0.0, 0.0);
    for (q, r) in angles.map(|(q, r)| (rotation(q), rotation(r))) {
        let both = euler(product(q.matrix(), r.matrix()));
        let apart = |a: &[f64], b: &[f64]| largest(a.iter().zip(b).map(|(a, b)| a - b));
        let turned = q.turn(DEGREE, &r.turn(DEGREE, &given));
        worst = largest([worst, apart(&turned, &both.turn(DEGREE, &given))]);
        let local = r.turn_back(DEGREE, &given);
        let together = both.turn_back(DEGREE, &q.turn(DEGREE, &given));
        seen = largest([seen, apart(&local, &together)]);
    }
    let scale = largest(given.iter().copied());
    vec![
        Figure::most("D(Q) D(R) against D(QR), of the largest", worst / scale, tolerances::TURNED),
        Figure::most("local light, of the largest", seen / scale, tolerances::TURNED),
    ]
}

/// (3) in a local frame whose third angle is γ, against the direct sum, where that angle is 0.
fn third_angle() -> Vec<Figure> {
    let (degree, order) = (24, 9);
    let mut numbers = Numbers(9);
    let given = fixtures::lights(degree, 1, &mut numbers).entries[0].luminance();
    let material = fixtures::materials(order, 1, &mut numbers).entries[0].luminance();
    let truth = Truth::new(degree, order);
    let integrals = PolarIntegrals::new(degree, order);
    let (mut worst, mut peak, mut still) = (0.0f64, 0.0f64, 0.0f64);
    for _ in 0..40 {
        let normal = numbers.normal();
        let modes = truth.at(normal);
        let expected = modes.irradiance(&given, &modes.scatter(&material));
        let [x, y, z] = normal;
        let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
        let gamma = PI * numbers.next();
        let local = rotation([alpha, beta, gamma]).turn_back(degree, &given);
        // Without γ the view lies at azimuth π; it is rotated back by γ.
        let found = irradiance(&integrals, &local, (order, &material), alpha, PI - gamma);
        let without = irradiance(&integrals, &local, (order, &material), alpha, PI);
        peak = peak.max(expected.abs());
        worst = largest([worst, found - expected]);
        still = largest([still, without - expected]);
    }
    vec![
        Figure::least("γ in the light alone, of the peak", still / peak, NAIVE_FRAME),
        Figure::most("γ in both, of the peak", worst / peak, tolerances::TURNED),
    ]
}
