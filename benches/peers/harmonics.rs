//! All real spherical harmonics of a direction, against the crate `sphrs`.

use crate::{Method, rows};
use eigenshade_benches::sheet::Row;
use eigenshade_benches::shipped::tables;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::light::{graphics_sign, position};
use sphrs::{Coordinates, HarmonicsSet, RealSH};
use std::hint::black_box;

/// The paper's, and the highest that scenes are made for.
const DEGREES: [usize; 2] = [9, 32];

/// l, m, theta, phi, and the value to 25 digits.
type Value = (usize, isize, f64, f64, f64);

fn direction(theta: f64, phi: f64) -> [f64; 3] {
    [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
}

pub fn compare(timed: bool) -> Vec<Row> {
    let path = tables().join("../crates/generator/tests/vectors/spherical_harmonic.csv");
    let mut reader = csv::Reader::from_path(path).expect("values");
    let values: Vec<Value> = reader.deserialize().map(|value| value.expect("a value")).collect();
    let directions: Vec<_> =
        (0..99).map(|k| direction(0.07 * f64::from(k), 2.4 * f64::from(k))).collect();
    let compare = |degree: usize| {
        let set = HarmonicsSet::new(degree, RealSH::Spherical);
        let ours = |xyz| spherical_harmonic::all(degree, xyz);
        let theirs = |[x, y, z]: [f64; 3]| set.eval(&Coordinates::cartesian(x, y, z));
        let error = |all: &dyn Fn([f64; 3]) -> Vec<f64>, sign: fn(isize) -> i8| {
            let values = values.iter().filter(|(l, ..)| *l <= degree);
            let error = |&(l, m, theta, phi, value): &Value| {
                let found = f64::from(sign(m)) * all(direction(theta, phi))[position(l, m)];
                (found - value).abs()
            };
            values.map(error).collect()
        };
        let run = |all: &dyn Fn([f64; 3]) -> Vec<f64>| {
            directions.iter().for_each(|&xyz| drop(black_box(all(black_box(xyz)))));
        };
        let methods = vec![
            Method::new("ours", || run(&ours), error(&ours, |_| 1)),
            Method::new("sphrs", || run(&theirs), error(&theirs, graphics_sign)),
        ];
        rows(&format!("spherical harmonics to degree {degree}"), methods, timed)
    };
    DEGREES.into_iter().flat_map(compare).collect()
}
