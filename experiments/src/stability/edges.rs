//! The pole and the rim.

use super::{Case, Figure};
use crate::tolerances;
use eigenshade_index::material;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_testing::oracle::{ExplicitLight, Numbers, irradiance};
use eigenshade_testing::{fixtures, largest};

/// Relative error of computing a slant of 1e-9 as acos(z): 1 - 5e-19 rounds to 1, and acos(1) is 0.
const NAIVE_SLANT: f64 = 0.5;

pub const POLE_AND_RIM: Case = Case {
    name: "slants 0, 1e-9, 1e-5, π/2 - 1e-9, π/2",
    naively: "division by sin α, a tilt from atan2(0, 0), α from acos(z), which has 1e-8 of slant at best",
    here: "Re and Im of (n_x + i n_y)^m: the pole is a point like any other; the slant from atan2 in set-up only",
    measure,
};

fn measure() -> Vec<Figure> {
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
        Figure::least("slant 1e-9 by acos, relative", naive(1e-9).abs(), NAIVE_SLANT),
        Figure::most("f64 against quadrature, of the peak", double, tolerances::ALL_COMPONENTS),
        Figure::most("f32, of the peak", single, tolerances::POLYNOMIAL_F32),
    ]
}

/// Shades with all components in a number format of the runtime.
fn shaded<S: eigenshade::Scalar + Into<f64>>(
    table: &Table,
    light: &[f64],
    material: &[f64],
    normals: &[[f64; 3]],
) -> Vec<f64> {
    let owned = OwnedBasis::<S>::new(table);
    let basis = owned.basis().expect("a basis");
    let narrow =
        |values: &[f64]| values.iter().map(|&value| S::from_f64(value)).collect::<Vec<_>>();
    let (light, material) = (narrow(light), narrow(material));
    let light = eigenshade::Light::new(9, &light).expect("coefficients");
    let material = eigenshade::Material::new(7, &material).expect("coefficients");
    let mut d = vec![S::ZERO; basis.components()];
    let mut workspace = vec![S::ZERO; basis.workspace_len()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
    let one = |&[x, y, z]: &[f64; 3]| {
        let normal = eigenshade::Normal::new(S::from_f64(x), S::from_f64(y), S::from_f64(z));
        scene.shade(normal.expect("visible")).into()
    };
    normals.iter().map(one).collect()
}
