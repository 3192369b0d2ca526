//! All real spherical harmonics of a direction, against the crate `sphrs`.

use crate::report::{Table, Way, ratios, standing};
use crate::shipped::root;
use eigenshade_index::light::{graphics_sign, position};
use eigenshade_model::special::spherical_harmonic;
use serde::Deserialize;
use sphrs::{Coordinates, HarmonicsSet, RealSH};
use std::error::Error;
use std::hint::black_box;

/// The paper's, and the highest that scenes are made for.
const DEGREES: [usize; 2] = [9, 32];
const ROUNDS: usize = 99;

/// A value to 25 digits.
#[derive(Deserialize)]
struct Value {
    l: usize,
    m: isize,
    theta: f64,
    phi: f64,
    value: f64,
}

fn direction(theta: f64, phi: f64) -> [f64; 3] {
    [theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()]
}

/// The comparison; times only if `measured`.
pub fn table(measured: bool) -> Result<Table, Box<dyn Error>> {
    let path = root().join("crates/generator/tests/vectors/spherical_harmonic.csv");
    let values: Vec<Value> =
        csv::Reader::from_path(path)?.deserialize().collect::<Result<_, _>>()?;
    let mut table = Table::new("Spherical harmonics", &["relative time", "who is ahead", "error"]);
    let directions: Vec<[f64; 3]> =
        (0..ROUNDS).map(|k| direction(0.07 * k as f64, 2.4 * k as f64)).collect();
    for degree in DEGREES {
        let set = HarmonicsSet::new(degree, RealSH::Spherical);
        let theirs = |[x, y, z]: [f64; 3]| set.eval(&Coordinates::cartesian(x, y, z));
        let ours = |xyz| spherical_harmonic::all(degree, xyz);
        let ratios = measured.then(|| {
            let run = |round: usize| black_box(directions[round]);
            ratios(
                ROUNDS,
                &mut [
                    Way::new(|round| drop(black_box(ours(run(round))))),
                    Way::new(|round| drop(black_box(theirs(run(round))))),
                ],
            )
        });
        let (mut of_ours, mut of_theirs) = (0.0, 0.0);
        for value in values.iter().filter(|value| value.l <= degree) {
            let xyz = direction(value.theta, value.phi);
            let place = position(value.l, value.m);
            of_ours = larger(of_ours, ours(xyz)[place] - value.value);
            let sign = f64::from(graphics_sign(value.m));
            of_theirs = larger(of_theirs, sign * theirs(xyz)[place] - value.value);
        }
        let ratio = |k: usize| ratios.as_ref().map(|ratios| ratios[k]);
        let way = |whose: &str| format!("degree {degree}, {whose}");
        table.row(way("ours"), ratio(0), String::new(), [Some(of_ours)]);
        let standing = standing("ours", "sphrs", ratio(1));
        table.row(way("sphrs"), ratio(1), standing, [Some(of_theirs)]);
    }
    Ok(table)
}

/// The larger of a size and that of a difference, NaN once there was one.
fn larger(most: f64, difference: f64) -> f64 {
    if most.is_finite() && difference.is_finite() { most.max(difference.abs()) } else { f64::NAN }
}
