//! The model's functions: rotations against the harmonics themselves, and the scattering modes (8)
//! against their defining properties. The command `evaluate` compares the special functions with
//! 25-digit values, see `crates/cli/tests/commands.rs`.

use crate::tolerances;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::scattering::{albedo, brdf, modes};
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::{light, material};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Scattering modes (8) up to order 12 under exact quadrature: some thousand roundings.
const ORTHONORMAL_SCATTERING: f64 = 1e-13;

const ROTATIONS: [Rotation; 6] = [
    Rotation { alpha: 0.7, beta: -2.1, gamma: 1.3 },
    Rotation { alpha: 2.9, beta: 0.4, gamma: -0.8 },
    Rotation { alpha: 1.5, beta: 3.0, gamma: 2.9 },
    Rotation { alpha: 1e-7, beta: 1.0, gamma: 0.5 },
    Rotation { alpha: PI, beta: 0.3, gamma: 0.2 },
    Rotation { alpha: 0.9, beta: 1.7, gamma: 0.0 },
];

fn times(matrix: [[f64; 3]; 3], vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
}

/// (5) itself: Y_l^m(Rω) = Σ_n D_l^mn Y_l^n(ω), in every degree and order.
#[test]
fn rotated_harmonics_are_sums_of_harmonics() {
    let directions: [[f64; 3]; 3] = [[0.36, 0.48, 0.8], [-0.6, 0.64, -0.48], [0.0, 0.0, 1.0]];
    for (degree, tolerance) in [(9, tolerances::SPECIAL_LOW), (64, tolerances::TURNED)] {
        // Of m < 0, m = 0 and m > 0; each sum runs over all signs of n.
        let mut worst = [0.0f64; 3];
        for rotation in ROTATIONS {
            for direction in directions {
                let rotated = times(rotation.matrix(), direction);
                let before = spherical_harmonic::all(degree, direction);
                let after = spherical_harmonic::all(degree, rotated);
                let mut sums = vec![0.0; light::count(degree)];
                let top = degree.cast_signed();
                for m in -top..=top {
                    for n in -top..=top {
                        let lowest = m.unsigned_abs().max(n.unsigned_abs());
                        let column = rotation.column(degree, m, n);
                        for (l, d) in (lowest..).zip(column) {
                            sums[light::position(l, m)] += d * before[light::position(l, n)];
                        }
                    }
                }
                for (l, m) in light::indices(degree) {
                    let place = light::position(l, m);
                    let case = &mut worst[(m.signum() + 1).unsigned_abs()];
                    *case = case.max((sums[place] - after[place]).abs());
                }
            }
        }
        println!("degree {degree}: {worst:?}");
        assert!(worst.iter().all(|worst| *worst <= tolerance), "{worst:?}");
    }
}

#[test]
fn turning_back_undoes_turning() {
    let degree = 12;
    let light: Vec<f64> =
        (0..light::count(degree)).map(|k| (1.7 * k as f64).sin() / (1.0 + k as f64)).collect();
    for rotation in ROTATIONS {
        let turned = rotation.turn(degree, &light);
        let back = rotation.turn_back(degree, &turned);
        let worst = light.iter().zip(&back).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst <= tolerances::SPECIAL_LOW, "{worst}");
        // Not the identity by mistake.
        let moved = light.iter().zip(&turned).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(moved > tolerances::NO_ACCIDENT);
    }
}

/// ∫∫ I I' dω_i dω_r is 1 or 0. Radial products are polynomials in cos θ, and
/// azimuths trigonometric polynomials: both rules are exact.
#[test]
fn modes_are_orthonormal_over_both_hemispheres() {
    for order in [0, 1, 7, 12] {
        let count = material::count(order);
        let cosines = gauss_legendre(order + 1, 0.0, 1.0);
        let azimuths = 2 * order + 1;
        let mut products = vec![0.0; count * count];
        for &(z_i, weight_i) in &cosines {
            for &(z_r, weight_r) in &cosines {
                for step in 0..azimuths {
                    let delta_phi = TAU * step as f64 / azimuths as f64;
                    let weight = weight_i * weight_r * TAU * TAU / azimuths as f64;
                    let values = modes(order, z_i.acos(), z_r.acos(), delta_phi);
                    for (j, a) in values.iter().enumerate() {
                        for (k, b) in values.iter().enumerate() {
                            products[j * count + k] += weight * a * b;
                        }
                    }
                }
            }
        }
        let worst = (0..count * count)
            .map(|k| (products[k] - f64::from(u8::from(k % (count + 1) == 0))).abs())
            .fold(0.0, f64::max);
        println!("order {order}: {worst:e}");
        assert!(worst <= ORTHONORMAL_SCATTERING, "{order}: {worst}");
    }
}

#[test]
fn modes_are_reciprocal_and_even_in_azimuth() {
    for (theta_i, theta_r, delta_phi) in [(0.3, 1.2, 0.7), (0.0, FRAC_PI_2, 2.0), (1.5, 1.1, PI)] {
        let there = modes(12, theta_i, theta_r, delta_phi);
        assert_eq!(there, modes(12, theta_r, theta_i, delta_phi));
        assert_eq!(there, modes(12, theta_i, theta_r, -delta_phi));
    }
}

/// By hand: I_00^0 = 1 / 2π, and at the rim, where every R is 1,
/// I_11^1 = (1/2π) √(4/2) 2 cos Δφ and I_20^0 = (1/2π) √(3/2) 2.
#[test]
fn first_modes_are_those_of_the_formula() {
    let values = modes(2, FRAC_PI_2, FRAC_PI_2, 0.4);
    let expected = [1.0, 8f64.sqrt() * 0.4f64.cos(), 6f64.sqrt()];
    for (value, expected) in values.iter().zip(expected) {
        assert!((value - expected / TAU).abs() <= tolerances::SPECIAL_LOW);
    }
    assert_eq!(values.len(), 5);
    assert_eq!(modes(7, 0.1, 0.2, 0.3).len(), 40);
}

/// A Lambertian material of albedo 1 has f = 1/π, so b_00^0 = 2.
#[test]
fn first_coefficient_is_the_lambertian_one() {
    let value = brdf(3, &[2.0], 0.5, 1.0, 2.0);
    assert!((value - 1.0 / PI).abs() <= tolerances::SPECIAL_LOW);
}

/// The albedo against the integral of its definition, by Gauss and Legendre over both cosines.
#[test]
fn the_albedo_is_the_share_of_even_light_that_is_reflected() {
    const ORDER: usize = 5;
    let nodes = gauss_legendre(12, 0.0, 1.0);
    for mode in 0..material::count(ORDER) {
        let mut coefficients = vec![0.0; material::count(ORDER)];
        coefficients[mode] = 1.0;
        let mut expected = 0.0;
        for &(incident, of_incident) in &nodes {
            for &(reflected, of_reflected) in &nodes {
                for k in 0..16 {
                    let azimuth = TAU * f64::from(k) / 16.0;
                    let [i, r] = [incident, reflected].map(f64::acos);
                    let f = brdf(ORDER, &coefficients, i, r, azimuth);
                    // Over both azimuths, one of which does not matter; by 1/π.
                    let weight = 2.0 * TAU / 16.0 * of_incident * of_reflected;
                    expected += weight * f * incident * reflected;
                }
            }
        }
        let found = albedo(&coefficients);
        assert!(
            (found - expected).abs() <= tolerances::ORTHONORMAL_NODES,
            "{mode}: {found} {expected}"
        );
    }
    assert!((albedo(&[2.0]) - 1.0).abs() <= tolerances::ORTHONORMAL_NODES);
}
