//! Special functions to degree 64, and images at the pole and at the rim.

use super::{Figure, least, most};
use crate::tolerances;
use eigenshade::Scalar;
use eigenshade_index::material;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::Table;
use eigenshade_testing::fixtures::{self, ROOT};
use eigenshade_testing::largest;
use eigenshade_testing::oracle::{self, ExplicitLight, Numbers, irradiance};

/// Compares with values of 25 digits, from explicit sums in 60 digits and more.
pub(super) fn functions() -> Vec<Figure> {
    let harmonic = worst("spherical_harmonic", 63.0, |&[l, m, theta, phi, value]| {
        spherical_harmonic::value(l as usize, m as isize, theta, phi) - value
    });
    let wigner = worst("wigner_d", 64.0, |&[l, m, n, alpha, value]| {
        wigner::value(l as usize, m as isize, n as isize, alpha) - value
    });
    let radial = worst("zernike_radial", 64.0, |&[o, q, rho, value]| {
        zernike::value(o as usize, q as usize, rho) - value
    });
    let naive = worst("zernike_radial", 64.0, |&[o, q, rho, value]| {
        oracle::zernike(o as usize, q as usize, rho) - value
    });
    let integrals = PolarIntegrals::new(64, 64);
    let integral = worst("polar_integral_high", 64.0, |&[l, o, q, value]| {
        integrals.row(o as usize, q as usize)[l as usize] - value
    });
    vec![
        // Values are up to 1. The terms reach 1e23, with sixteen correct digits.
        least("R by its factorial sum", naive, 1.0),
        most("Y", harmonic, tolerances::SPECIAL_HIGH),
        most("d", wigner, tolerances::SPECIAL_HIGH),
        most("R", radial, tolerances::SPECIAL_HIGH),
        most("N C", integral, tolerances::POLAR_INTEGRAL),
    ]
}

/// The largest `error` over the rows of a file of test vectors that reaches the degree `reach`.
fn worst<const N: usize>(file: &str, reach: f64, error: impl Fn(&[f64; N]) -> f64) -> f64 {
    let path = format!("{ROOT}/crates/generator/tests/vectors/{file}.csv");
    let text = std::fs::read_to_string(path).expect("vectors");
    let row = |line: &str| -> [f64; N] {
        let fields = line.split(',').map(|field| field.parse().expect("a number"));
        fields.collect::<Vec<_>>().try_into().expect("a number in each column")
    };
    let lines = text.lines().skip_while(|line| line.starts_with('#')).skip(1);
    let rows: Vec<_> = lines.map(row).collect();
    assert!(rows.iter().any(|row| row[0] >= reach), "{file} does not reach {reach}");
    largest(rows.iter().map(error))
}

/// Slants 0, 1e-9, 1e-5, π/2 - 1e-9 and π/2 by all components, against quadrature.
pub(super) fn pole_and_rim() -> Vec<Figure> {
    let loaded = fixtures::shipped();
    let table = fixtures::table(&loaded);
    let mut numbers = Numbers(3);
    let (mut double, mut single) = (0.0, 0.0);
    for (light, on) in loaded.lights.entries.iter().zip(&loaded.materials.entries).take(6) {
        let (light, material) = (light.luminance(), on.luminance());
        let tilts = 3 + (numbers.next().abs() * 3.0) as usize;
        let normals = fixtures::normals(&fixtures::SLANTS, tilts);
        let terms: Vec<_> =
            material::indices(7).zip(&material).map(|((o, p, q), b)| (o, p, q, *b)).collect();
        let explicit = ExplicitLight::new(&light);
        let expected: Vec<f64> =
            normals.iter().map(|&normal| irradiance(&explicit, &terms, normal)).collect();
        let peak = largest(expected.iter().copied());
        let error = |ours: Vec<f64>| largest(ours.iter().zip(&expected).map(|(a, b)| a - b)) / peak;
        double = largest([double, error(shaded::<f64>(&table, &light, &material, &normals))]);
        single = largest([single, error(shaded::<f32>(&table, &light, &material, &normals))]);
    }
    let naive = |alpha: f64| (alpha.cos().acos() - alpha) / alpha;
    vec![
        // cos 1e-9 = 1 - 5e-19 rounds to 1, and acos(1) = 0.
        least("slant 1e-9 by acos, relative", naive(1e-9).abs(), 0.5),
        most("f64 against quadrature, of the peak", double, tolerances::ALL_COMPONENTS),
        most("f32, of the peak", single, tolerances::POLYNOMIAL_F32),
    ]
}

/// Shades with all components in a number format of the runtime.
fn shaded<S: Scalar + Into<f64>>(
    table: &Table,
    light: &[f64],
    material: &[f64],
    normals: &[[f64; 3]],
) -> Vec<f64> {
    let owned = OwnedBasis::<S>::new(table);
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let image = shader.polynomial((9, light), (7, material), &OwnedNormals::new(normals));
    image.expect("coefficients that fit").into_iter().map(Into::into).collect()
}
