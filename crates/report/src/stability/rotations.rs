//! Rotations to degree 64, a thousand in a row, and matrices that are almost rotations.

use super::{Figure, least, most, off_orthonormal};
use crate::tolerances;
use eigenshade::{Light, Rotation};
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::rotation;
use eigenshade_table::light;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::rotations::{euler, irradiance, product, rotation};
use eigenshade_testing::{fixtures, largest, largest_difference};
use nalgebra::{DMatrix, Matrix3};
use std::f64::consts::PI;

/// Rotating by R and then by Q equals rotating by QR; and frame R sees in a light what frame QR
/// sees in the light rotated by Q. Half turns and tiny angles are among the angles.
pub(super) fn composition() -> Vec<Figure> {
    const DEGREE: usize = 64;
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
        let turned = q.turn(DEGREE, &r.turn(DEGREE, &given));
        worst = largest([worst, largest_difference(&turned, &both.turn(DEGREE, &given))]);
        let local = r.turn_back(DEGREE, &given);
        let together = both.turn_back(DEGREE, &q.turn(DEGREE, &given));
        seen = largest([seen, largest_difference(&local, &together)]);
    }
    let scale = largest(given.iter().copied());
    vec![
        most("D(Q) D(R) against D(QR), of the largest", worst / scale, tolerances::TURNED),
        most("local light, of the largest", seen / scale, tolerances::TURNED),
    ]
}

/// (3) in a local frame whose third angle is γ, against the direct sum, where that angle is 0: an
/// isotropic material must not depend on it.
pub(super) fn third_angle() -> Vec<Figure> {
    let (degree, order) = (24, 9);
    let mut numbers = Numbers(9);
    let given = fixtures::lights(degree, 1, &mut numbers).entries[0].luminance();
    let material = fixtures::materials(order, 1, &mut numbers).entries[0].luminance();
    let reference = DirectSum::new(degree, order);
    let integrals = PolarIntegrals::new(degree, order);
    let (mut worst, mut peak, mut still) = (0.0f64, 0.0f64, 0.0f64);
    for _ in 0..40 {
        let normal = numbers.normal();
        let modes = reference.at(normal);
        let expected = modes.irradiance(&given, &modes.scatter(&material));
        let [x, y, z] = normal;
        let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
        let gamma = PI * numbers.next();
        let local = rotation([alpha, beta, gamma]).turn_back(degree, &given);
        // Without γ the view lies at azimuth π; it is rotated back by γ.
        let seen = |azimuth| irradiance(&integrals, &local, (order, &material), alpha, azimuth);
        peak = peak.max(expected.abs());
        worst = largest([worst, seen(PI - gamma) - expected]);
        still = largest([still, seen(PI) - expected]);
    }
    vec![
        // This changes the light by some percent.
        least("γ in the light alone, of the peak", still / peak, 0.01),
        most("γ in both, of the peak", worst / peak, tolerances::TURNED),
    ]
}

/// Sixteen roundings of R Rᵀ in f32, and those of the sum itself.
const ORTHONORMAL_F32: f64 = 1.2e-6;

/// The distance of R Rᵀ from the identity matrix.
fn off(matrix: [[f32; 3]; 3]) -> f64 {
    off_orthonormal(&DMatrix::from_fn(3, 3, |i, j| matrix[j][i].into()))
}

fn turned(light: &[f32], rotation: &Rotation) -> Vec<f32> {
    let light = Light::new(light).expect("100 coefficients");
    light.turned::<100>(rotation).expect("room").to_vec()
}

/// The largest relative change of the energy of a degree.
fn gained(before: &[f32], after: &[f32]) -> f64 {
    let energy = |values: &[f32]| values.iter().map(|&x| f64::from(x).powi(2)).sum::<f64>();
    let of_degree = |l: usize| {
        let range = if l == 0 { 0..1 } else { light::count(l - 1)..light::count(l) };
        energy(&after[range.clone()]) / energy(&before[range]) - 1.0
    };
    largest((0..10).map(of_degree))
}

/// The same small rotation repeated in f32, against a single rotation by the total in f64.
pub(super) fn drift() -> Vec<Figure> {
    let mut numbers = Numbers(47);
    let first: Vec<f64> = (0..100).map(|_| numbers.next()).collect();
    let single: Vec<f32> = first.iter().map(|&value| value as f32).collect();
    let angles = [0.004f32, 0.003, -0.002];
    let [a, b, c] = angles;
    let small = Rotation::from_euler(a, b, c).expect("a rotation");
    let step = Matrix3::from(small.matrix());
    let (mut naive, mut all, mut light) = (step, small, turned(&single, &small));
    for _ in 1..1000 {
        naive = step * naive;
        all = small.after(all);
        light = turned(&light, &small);
    }
    let [a, b, c] = angles.map(f64::from);
    let once = rotation::Rotation { alpha: b, beta: a, gamma: c };
    let exact = (0..1000).fold(first.clone(), |exact, _| once.turn(9, &exact));
    let scale = largest(first);
    let error = |found: &[f32]| {
        let found: Vec<f64> = found.iter().copied().map(f64::from).collect();
        largest_difference(&found, &exact) / scale
    };
    let [product, one_by_one, energy] = tolerances::DRIFT;
    vec![
        // The roundings of a thousand products add up.
        least("R of plain products, off orthonormal", off(naive.into()), 5e-6),
        most("R of `after`, off orthonormal", off(all.matrix()), ORTHONORMAL_F32),
        most("light turned by the product, of the largest", error(&turned(&single, &all)), product),
        most("light turned a thousand times, of the largest", error(&light), one_by_one),
        most("its energy in a degree, relative", gained(&single, &light), energy),
    ]
}

/// Matrices within 1e-3 of a rotation: one stretched, one sheared.
pub(super) fn almost() -> Vec<Figure> {
    let mut numbers = Numbers(48);
    let light: Vec<f32> = (0..100).map(|_| numbers.next() as f32).collect();
    let exact = Rotation::from_quaternion([0.3f32, -0.5, 0.2, 0.8]).expect("a rotation");
    // Rows 4.9e-4 too long, so that their squares are 1e-3 off.
    let stretched = exact.matrix().map(|row| row.map(|element| element * 1.000_49));
    let mut sheared = exact.matrix();
    for (element, other) in sheared[0].iter_mut().zip(exact.matrix()[1]) {
        *element += 9.9e-4 * other;
    }
    let (mut before, mut after, mut energy) = (0.0f64, 0.0f64, 0.0f64);
    for matrix in [stretched, sheared] {
        let rotation = Rotation::from_matrix(matrix).expect("within 1e-3");
        before = before.max(off(matrix));
        after = after.max(off(rotation.matrix()));
        energy = energy.max(gained(&light, &turned(&light, &rotation)).abs());
    }
    vec![
        least("the given matrix, off orthonormal", before, 9e-4),
        most("the rotation made from it", after, ORTHONORMAL_F32),
        most("energy of a turned light in a degree, relative", energy, 1e-6),
    ]
}
