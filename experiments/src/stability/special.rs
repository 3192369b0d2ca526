//! Special functions to degree 64.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_testing::fixtures::ROOT;
use eigenshade_testing::largest;

/// Error of R_n^m to order 64 by its factorial sum, for values up to 1: terms reach 1e23, and only
/// sixteen of their digits are right.
const NAIVE_FACTORIALS: f64 = 1.0;

pub const FUNCTIONS: Case = Case {
    name: "special functions to degree and order 64",
    naively: "factorial sums lose all digits near degree 30: their terms are far larger than their sum",
    here: "normalised three-term recurrences",
    measure: functions,
};

fn functions() -> Vec<Figure> {
    let harmonic = worst("spherical_harmonic", 63.0, |row| {
        let &[l, m, theta, phi, value] = row else { panic!("five columns") };
        spherical_harmonic::value(l as usize, m as isize, theta, phi) - value
    });
    let wigner = worst("wigner_d", 64.0, |row| {
        let &[l, m, n, alpha, value] = row else { panic!("five columns") };
        wigner::value(l as usize, m as isize, n as isize, alpha) - value
    });
    let radial = worst("zernike_radial", 64.0, |row| {
        let &[o, q, rho, value] = row else { panic!("four columns") };
        zernike::value(o as usize, q as usize, rho) - value
    });
    let integrals = PolarIntegrals::new(64, 64);
    let integral = worst("polar_integral_high", 64.0, |row| {
        let &[l, o, q, value] = row else { panic!("four columns") };
        let [l, o, q] = [l, o, q].map(|index| index as usize);
        integrals.row(o, q)[l] - value
    });
    let naive = worst("zernike_radial", 64.0, |row| {
        let &[o, q, rho, value] = row else { panic!("four columns") };
        eigenshade_testing::oracle::zernike(o as usize, q as usize, rho) - value
    });
    vec![
        Figure::least("R by its factorial sum", naive, NAIVE_FACTORIALS),
        Figure::most("Y", harmonic, tolerances::SPECIAL_HIGH),
        Figure::most("d", wigner, tolerances::SPECIAL_HIGH),
        Figure::most("R", radial, tolerances::SPECIAL_HIGH),
        Figure::most("N C", integral, tolerances::POLAR_INTEGRAL),
    ]
}

/// The largest `error` over 25-digit values, which come from explicit sums in 60 digits and more.
fn worst(file: &str, reach: f64, error: impl Fn(&[f64]) -> f64) -> f64 {
    let path = format!("{ROOT}/crates/generator/tests/vectors/{file}.csv");
    let text = std::fs::read_to_string(path).expect("vectors");
    let row = |line: &str| -> Vec<f64> {
        line.split(',').map(|field| field.parse().expect("a number")).collect()
    };
    let lines = text.lines().skip_while(|line| line.starts_with('#')).skip(1);
    let rows: Vec<_> = lines.map(row).collect();
    assert!(rows.iter().any(|row| row[0] >= reach), "{file} does not reach {reach}");
    largest(rows.iter().map(|row| error(row)))
}
