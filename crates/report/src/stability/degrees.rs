//! Special functions to degree 64, images at the pole and at the rim, and a basis at degree 32 and
//! order 32, of GGX materials of roughness 0.1 to 1.

use super::{Figure, exactly, least, most, tight};
use crate::tolerances;
use eigenshade::{Basis, Light, Material};
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::special::{spherical_harmonic, wigner, zernike};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::layout::MAX_DEGREE;
use eigenshade_table::scene::Store;
use eigenshade_table::{Component, Table, material, mode};
use eigenshade_testing::fixtures::{self, Projector, ROOT};
use eigenshade_testing::oracle::{self, ExplicitLight, Numbers, irradiance};
use eigenshade_testing::{glossy, largest, relative_error};

/// d by projection, and by a transfer of the material and a new light.
pub fn coefficients(basis: &Basis<'_>, light: &[f64], on: &[f64]) -> [Vec<f32>; 2] {
    let rounded = |values: &[f64]| values.iter().map(|&value| value as f32).collect();
    let (light, material): (Vec<f32>, Vec<f32>) = (rounded(light), rounded(on));
    let light = Light::new(&light).expect("coefficients");
    let material = Material::new(&material).expect("coefficients");
    let mut workspace = vec![0.0; basis.workspace_len()];
    let mut transfer = vec![0.0; basis.transfer_len()];
    let [mut projected, mut relit] = [(); 2].map(|()| vec![0.0; basis.components()]);
    basis.project_into(&light, &material, &mut workspace, &mut projected).expect("sizes");
    basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    basis.relight_into(&transfer, &light, &mut relit).expect("sizes");
    [projected, relit]
}

/// The image of a table with all components in f32, from the collapsed polynomials.
fn shaded(table: &Table, pair: [&[f64]; 2], at: &[[f64; 3]]) -> Vec<f64> {
    let owned = OwnedBasis::new(table).expect("a table for f32");
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let image = shader.polynomial(pair[0], pair[1], &OwnedNormals::new(at));
    image.expect("coefficients that fit").into_iter().map(f64::from).collect()
}

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
    let loaded = fixtures::shipped("curet");
    let table = fixtures::table(&loaded);
    let projector = Projector::new(&table);
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
        let double = projector.shade(&projector.project(&light, &material), &normals);
        let single = shaded(&table, [&light, &material], &normals);
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

pub(super) fn high() -> Vec<Figure> {
    let scene = |degree| fixtures::scene(fixtures::captured(degree), glossy::materials(degree));
    let mut loaded = scene(32);
    loaded.scene.basis.components = Some(100);
    let table = fixtures::table(&loaded);
    let off = basis::orthonormality(&table, 100);
    let mut figures = vec![
        exactly("modes", mode::total(32, 32), 1_741_497),
        exactly("components", table.components.len(), 100),
        tight("|UᵀMU - I| of the first 100", off, tolerances::ORTHONORMAL_HIGH),
    ];
    for degree in [12, 16, 24, 32] {
        let mut loaded = scene(degree);
        loaded.scene.basis.store = Store::Projection;
        let table = fixtures::table(&loaded);
        let what = |format| format!("light to pixel in {format}, degree {degree}, of the peak");
        let found = pixel_error(&loaded, &table, in_f64);
        // The error grows with the degree.
        let bounded = if degree == 32 { tight } else { most };
        figures.push(bounded(what("f64"), found, tolerances::HIGH_PIXELS));
        if degree <= MAX_DEGREE {
            let found = pixel_error(&loaded, &table, in_f32);
            figures.push(tight(what("f32"), found, tolerances::HIGH_PIXELS_F32));
        }
    }
    figures
}

/// The image of a light on a material, from a transfer, at these normals.
type Pixels = fn(&Table, [&[f64]; 2], &[[f64; 3]]) -> Vec<f64>;

fn in_f64(table: &Table, [light, on]: [&[f64]; 2], at: &[[f64; 3]]) -> Vec<f64> {
    let projector = Projector::new(table);
    projector.shade(&projector.project(light, on), at)
}

fn in_f32(table: &Table, [light, on]: [&[f64]; 2], at: &[[f64; 3]]) -> Vec<f64> {
    let owned = OwnedBasis::new(table).expect("a table for f32");
    let basis = owned.basis().expect("a basis");
    let [_, d] = coefficients(&basis, light, on);
    let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
    at.iter().map(|&normal| scene.shade(fixtures::normal(normal)).into()).collect()
}

/// The largest error of images at the nodes in a few tilts. There the eigenimages are known without
/// any polynomial, and d is in f64.
fn pixel_error(loaded: &Loaded, table: &Table, pixels: Pixels) -> f64 {
    let projector = Projector::new(table);
    const TILTS: [f64; 3] = [0.1, 1.7, 4.0];
    let of_node = |&z: &f64| TILTS.map(|tilt| [sine(z) * tilt.cos(), sine(z) * tilt.sin(), z]);
    let normals: Vec<[f64; 3]> = table.gram.nodes.iter().flat_map(of_node).collect();
    largest(loaded.lights.entries.iter().zip(&loaded.materials.entries).map(|(light, on)| {
        let (light, on) = (light.luminance(), on.luminance());
        let exact = projector.project(&light, &on);
        let mut expected = Vec::new();
        for (k, root) in table.gram.root_weights.iter().enumerate() {
            for tilt in TILTS {
                let image = |(component, d): (&Component, &f64)| {
                    let u = table.profiles[component.profile].node_values[k] / root;
                    d * u * spherical_harmonic::azimuth(component.order as isize, tilt)
                };
                expected.push(table.components.iter().zip(&exact).map(image).sum::<f64>());
            }
        }
        relative_error(&pixels(table, [&light, &on], &normals), &expected)
    }))
}

fn sine(z: f64) -> f64 {
    ((1.0 - z) * (1.0 + z)).sqrt()
}
