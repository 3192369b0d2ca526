//! The real rotation coefficients D against the harmonics themselves: all nine sign
//! cases, general angles.

use crate::tolerances;
use eigenshade_index::light;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::special::spherical_harmonic;

const ROTATIONS: [Rotation; 6] = [
    Rotation { alpha: 0.7, beta: -2.1, gamma: 1.3 },
    Rotation { alpha: 2.9, beta: 0.4, gamma: -0.8 },
    Rotation { alpha: 1.5, beta: 3.0, gamma: 2.9 },
    Rotation { alpha: 1e-7, beta: 1.0, gamma: 0.5 },
    Rotation { alpha: std::f64::consts::PI, beta: 0.3, gamma: 0.2 },
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

/// Each of the nine cases alone: D_l^mn is the integral of Y_l^m(Rω) Y_l^n(ω).
#[test]
fn each_sign_case_is_its_integral() {
    use eigenshade_model::special::gauss_legendre;
    let degree = 5;
    for rotation in ROTATIONS {
        let mut integrals = vec![vec![0.0; light::count(degree)]; light::count(degree)];
        for (z, weight) in gauss_legendre::rule(2 * degree + 1, -1.0, 1.0) {
            let steps = 4 * degree + 3;
            for k in 0..steps {
                let phi = 2.0 * std::f64::consts::PI * k as f64 / steps as f64;
                let sine = (1.0 - z * z).sqrt();
                let direction = [sine * phi.cos(), sine * phi.sin(), z];
                let area = weight * 2.0 * std::f64::consts::PI / steps as f64;
                let before = spherical_harmonic::all(degree, direction);
                let after = spherical_harmonic::all(degree, times(rotation.matrix(), direction));
                for (row, after) in integrals.iter_mut().zip(&after) {
                    for (sum, before) in row.iter_mut().zip(&before) {
                        *sum += area * after * before;
                    }
                }
            }
        }
        for (l, m) in light::indices(degree) {
            for n in -l.cast_signed()..=l.cast_signed() {
                let expected = integrals[light::position(l, m)][light::position(l, n)];
                let found = rotation.coefficient(l, m, n);
                assert!((found - expected).abs() <= tolerances::SPECIAL_LOW, "{l} {m} {n}");
            }
        }
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
