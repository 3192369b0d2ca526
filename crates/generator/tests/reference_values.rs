//! The special functions against 25-digit values from explicit sums and
//! quadrature in 60-digit arithmetic.

use crate::tolerances;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_model::{irradiance, polar_integral};

/// Asserts the worst absolute error of both degree ranges; `f` gives the
/// degree, our value and the reference.
fn check(file: &str, f: impl Fn(&[f64]) -> (f64, f64, f64)) {
    let path = format!("{}/tests/vectors/{file}.csv", env!("CARGO_MANIFEST_DIR"));
    let mut worst = [0.0f64; 2];
    let mut rows = [0; 2];
    for record in csv::Reader::from_path(&path).expect("vectors").records() {
        let record = record.expect("a row");
        let row: Vec<f64> = record.iter().map(|field| field.parse().expect("a number")).collect();
        let (degree, ours, reference) = f(&row);
        let range = usize::from(degree > 9.0);
        worst[range] = worst[range].max((ours - reference).abs());
        rows[range] += 1;
    }
    println!("{file}: {rows:?} rows, worst {worst:?}");
    assert!(rows[0] > 20 && rows[1] > 20, "{rows:?}");
    assert!(worst[0] <= tolerances::SPECIAL_LOW, "{file}, degrees to 9: {}", worst[0]);
    assert!(worst[1] <= tolerances::SPECIAL_HIGH, "{file}, degrees to 64: {}", worst[1]);
}

fn index(value: f64) -> usize {
    value as usize
}

#[test]
fn spherical_harmonics() {
    check("spherical_harmonic", |row| {
        let &[l, m, theta, phi, value] = row else { panic!("five columns") };
        (l, spherical_harmonic::value(index(l), m as isize, theta, phi), value)
    });
}

#[test]
fn wigner_d() {
    check("wigner_d", |row| {
        let &[l, m, n, alpha, value] = row else { panic!("five columns") };
        (l, wigner::value(index(l), m as isize, n as isize, alpha), value)
    });
}

#[test]
fn zernike_radial() {
    check("zernike_radial", |row| {
        let &[o, q, rho, value] = row else { panic!("four columns") };
        (o, zernike::value(index(o), index(q), rho), value)
    });
}

/// The reference is C itself; the error is of N C, the product that is used.
#[test]
fn polar_integrals() {
    check("polar_integral", |row| {
        let &[l, o, q, value] = row else { panic!("four columns") };
        let normalization = polar_integral::normalization(index(l), index(q));
        let ours = polar_integral::value(index(l), index(o), index(q));
        (l.max(o), ours * normalization, value * normalization)
    });
}

#[test]
fn irradiance_modes() {
    check("irradiance_mode", |row| {
        let &[l, m, o, p, q, alpha, beta, value] = row else { panic!("eight columns") };
        let [l_, o_, p_, q_] = [l, o, p, q].map(index);
        (l.max(o), irradiance::value(l_, m as isize, o_, p_, q_, alpha, beta), value)
    });
}
