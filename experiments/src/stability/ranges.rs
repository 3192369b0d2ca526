//! Coefficients that are tiny or huge.

use super::{Figure, exactly, most};
use crate::tolerances;
use eigenshade::{Light, Material, Normal, Scalar, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::{fixtures, largest};

/// 2^100 = 1.3e30.
const FAR: i32 = 100;

pub(super) fn double() -> Vec<Figure> {
    let found = measure::<f64>();
    vec![
        exactly("coefficients that differ in a bit", found.coefficients, 0),
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("answers that are not finite", found.infinite, 0),
    ]
}

pub(super) fn single() -> Vec<Figure> {
    let found = measure::<f32>();
    vec![
        exactly("pixels that differ in a bit", found.pixels, 0),
        exactly("first 50 coefficients that differ in a bit", found.shipped, 0),
        most("all coefficients, of the largest", found.apart, tolerances::SCALED_F32),
        exactly("answers that are not finite", found.infinite, 0),
        exactly("answers of 1e-60 that are not 0", found.not_zero, 0),
    ]
}

/// Compares the results for scaled inputs with the scaled results, bit for bit.
#[derive(Default)]
struct Found {
    coefficients: usize,
    /// For the coefficients of as many components as the shipped table has.
    shipped: usize,
    pixels: usize,
    /// The largest difference of two coefficients, relative to the largest coefficient.
    apart: f64,
    infinite: usize,
    not_zero: usize,
}

fn measure<S: Scalar + Into<f64>>() -> Found {
    let loaded = fixtures::shipped();
    let table = fixtures::table(&loaded);
    let mut numbers = Numbers(41);
    let light = fixtures::lights(9, 1, &mut numbers).entries[0].luminance();
    let material = fixtures::materials(7, 1, &mut numbers).entries[0].luminance();
    let plain = answers::<S>(&table, &light, &material);
    let mut all = Found::default();
    for (of_light, of_material) in
        [(FAR, 0), (-FAR, 0), (0, FAR), (0, -FAR), (FAR, -FAR), (-FAR, FAR), (-FAR, -FAR)]
    {
        let scaled = |values: &[f64], power: i32| -> Vec<f64> {
            values.iter().map(|value| value * 2f64.powi(power)).collect()
        };
        let (light, material) = (scaled(&light, of_light), scaled(&material, of_material));
        let found = answers::<S>(&table, &light, &material);
        let factor = 2f64.powi(of_light + of_material);
        all.infinite += found.iter().flatten().filter(|value| !value.is_finite()).count();
        // 1e-60 is zero in f32.
        if S::from_f64(factor).into() == 0.0 {
            all.not_zero += found.iter().flatten().filter(|value| **value != 0.0).count();
            continue;
        }
        let other = |(a, b): &(&f64, &f64)| (*a / factor).to_bits() != b.to_bits();
        for half in [0, plain[0].len() / 2] {
            let pairs = found[0][half..].iter().zip(&plain[0][half..]);
            all.shipped += pairs.take(sphere::COMPONENTS).filter(other).count();
        }
        all.coefficients += found[0].iter().zip(&plain[0]).filter(other).count();
        all.pixels += found[1].iter().zip(&plain[1]).filter(other).count();
        let scale = largest(plain[0].iter().copied());
        let apart = found[0].iter().zip(&plain[0]).map(|(a, b)| (a / factor - b) / scale);
        all.apart = largest(apart.chain([all.apart]));
    }
    all
}

/// Coefficients by projection, and by transfer and new light; pixels from both, by collapsed
/// polynomials and component by component.
fn answers<S: Scalar + Into<f64>>(table: &Table, light: &[f64], material: &[f64]) -> [Vec<f64>; 2] {
    let owned = OwnedBasis::<S>::new(table);
    let basis = owned.basis().expect("a basis");
    let narrow =
        |values: &[f64]| values.iter().map(|&value| S::from_f64(value)).collect::<Vec<_>>();
    let (light, material) = (narrow(light), narrow(material));
    let light = Light::new(&light).expect("coefficients");
    let material = Material::new(&material).expect("coefficients");
    let mut d = vec![S::ZERO; basis.components()];
    let mut relit = d.clone();
    let mut workspace = vec![S::ZERO; basis.workspace_len()];
    let mut transfer = vec![S::ZERO; basis.transfer_len()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    basis.relight_into(&transfer, &light, &mut relit).expect("sizes");
    let coefficients = d.iter().chain(&relit).map(|&value| value.into()).collect();
    let mut pixels = Vec::new();
    for d in [d, relit] {
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        for [x, y, z] in fixtures::normals(&fixtures::SLANTS, 5) {
            let normal = Normal::new(S::from_f64(x), S::from_f64(y), S::from_f64(z));
            let normal = normal.expect("visible");
            pixels.push(scene.shade(normal).into());
            pixels.push(basis.reconstruct(&d, normal).expect("all components").into());
        }
    }
    [coefficients, pixels]
}
