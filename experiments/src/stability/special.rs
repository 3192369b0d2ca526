//! Special functions to degree 64, and images at the pole and at the rim.

use super::images::shaded;
use super::{Figure, least, most, tight};
use crate::tolerances;
use eigenshade_index::material;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_testing::fixtures::{self, ROOT};
use eigenshade_testing::oracle::{self, ExplicitLight, Numbers, irradiance};
use eigenshade_testing::{largest, relative_error};

/// Compares with values of 25 digits, from explicit sums in 60 digits and more.
pub(super) fn functions() -> Vec<Figure> {
    let harmonic = worst("spherical_harmonic", 63.0, |[l, m, theta, phi]| {
        spherical_harmonic::value(l as usize, m as isize, theta, phi)
    });
    let wigner = worst("wigner_d", 64.0, |[l, m, n, alpha]| {
        wigner::value(l as usize, m as isize, n as isize, alpha)
    });
    let of_radial = |value: fn(usize, usize, f64) -> f64| {
        worst("zernike_radial", 64.0, |[o, q, rho]| value(o as usize, q as usize, rho))
    };
    let integrals = PolarIntegrals::new(64, 64);
    let integral = worst("polar_integral_high", 64.0, |[l, o, q]| {
        integrals.row(o as usize, q as usize)[l as usize]
    });
    vec![
        // Values are up to 1. The terms reach 1e23, with sixteen correct digits.
        least("R by its factorial sum", of_radial(oracle::zernike), 1.0),
        most("Y", harmonic, tolerances::SPECIAL_HIGH),
        most("d", wigner, tolerances::SPECIAL_HIGH),
        most("R", of_radial(zernike::value), tolerances::SPECIAL_HIGH),
        tight("N C", integral, tolerances::POLAR_INTEGRAL),
    ]
}

/// The largest error over the rows of a file of test vectors, which reaches the degree `reach`. The
/// last column is the value, the others are the arguments.
fn worst<const N: usize>(file: &str, reach: f64, value: impl Fn([f64; N]) -> f64) -> f64 {
    let path = format!("{ROOT}/crates/generator/tests/vectors/{file}.csv");
    let text = std::fs::read_to_string(path).expect("vectors");
    let error = |line: &str| {
        let fields: Vec<f64> =
            line.split(',').map(|field| field.parse().expect("a number")).collect();
        let (expected, arguments) = fields.split_last().expect("a value");
        let arguments: [f64; N] = arguments.try_into().expect("a number in each column");
        (arguments[0], value(arguments) - expected)
    };
    let lines = text.lines().skip_while(|line| line.starts_with('#')).skip(1);
    let (degrees, errors): (Vec<f64>, Vec<f64>) = lines.map(error).unzip();
    assert!(degrees.iter().any(|&degree| degree >= reach), "{file} does not reach {reach}");
    largest(errors)
}

/// Slants 0, 1e-9, 1e-5, π/2 - 1e-9 and π/2 by all components, against quadrature.
pub(super) fn pole_and_rim() -> Vec<Figure> {
    let loaded = fixtures::shipped();
    let table = fixtures::table(&loaded);
    let mut numbers = Numbers(3);
    let (mut in_f64, mut in_f32) = (0.0, 0.0);
    for (light, on) in loaded.lights.entries.iter().zip(&loaded.materials.entries).take(6) {
        let (light, material) = (light.luminance(), on.luminance());
        let tilts = 3 + (numbers.next().abs() * 3.0) as usize;
        let normals = fixtures::normals(&fixtures::SLANTS, tilts);
        let terms: Vec<_> =
            material::indices(7).zip(&material).map(|((o, p, q), b)| (o, p, q, *b)).collect();
        let explicit = ExplicitLight::new(&light);
        let expected: Vec<f64> =
            normals.iter().map(|&normal| irradiance(&explicit, &terms, normal)).collect();
        let double = shaded::<f64>(&table, &light, &material, &normals);
        let single = shaded::<f32>(&table, &light, &material, &normals);
        in_f64 = largest([in_f64, relative_error(&double, &expected)]);
        in_f32 = largest([in_f32, relative_error(&single, &expected)]);
    }
    let naive = (1e-9f64.cos().acos() - 1e-9) / 1e-9;
    vec![
        // cos 1e-9 = 1 - 5e-19 rounds to 1, and acos(1) = 0.
        least("slant 1e-9 by acos, relative", naive.abs(), 0.5),
        tight("f64 against quadrature, of the peak", in_f64, tolerances::ALL_COMPONENTS),
        most("f32, of the peak", in_f32, tolerances::POLYNOMIAL_F32),
    ]
}
