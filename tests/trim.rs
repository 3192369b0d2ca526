//! Trimmed polynomials against the direct sum (15), over every light on every material of
//! the database.

use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::shipped;
use eigenshade_table::trim::trim;
use std::f64::consts::TAU;

/// Rms error of the firmware's full scene over the rms peak: what its components and terms are
/// chosen for.
const FULL_SCENE: f64 = 1e-4;

/// The table of `firmware/tables/full.toml`.
const TABLE: &[u8] = include_bytes!("../firmware/tables/full.bin");

/// Normals of equal projected areas.
fn normals() -> Vec<[f64; 3]> {
    let count = 200;
    (0..count)
        .map(|k| {
            let square = (f64::from(k) + 0.5) / f64::from(count);
            let (y, x) = (TAU * 0.618_034 * f64::from(k)).sin_cos();
            let radius = square.sqrt();
            [radius * x, radius * y, (1.0 - square).sqrt()]
        })
        .collect()
}

/// What the firmware's full scene leaves out, components and terms together: the root of
/// the mean square error over the root of the mean square of the images' peaks, lights
/// scaled to L_0^0 = 1.
#[test]
fn the_full_scene_keeps_its_tolerance() {
    let mut table = eigenshade_table::decode(TABLE).expect("a table");
    let said = trim(&mut table, 2e-4);
    assert!(said <= 2e-4, "{said}");
    let terms: usize =
        eigenshade_table::Parts::new(&table).lengths.iter().map(|&n| usize::from(n)).sum();
    assert!(terms <= 80, "{terms} for one sign of m");
    let basis = OwnedBasis::<f64>::new(&table);
    let basis = basis.basis().expect("a basis");
    let mut shader = Shader::new(basis, table.count());
    let (degree, order) = (table.gram.degree, table.gram.order);
    let lights = shipped::lights().expect("lights").truncated(degree);
    let materials = shipped::materials().expect("materials").truncated(order);
    let normals = normals();
    let owned = OwnedNormals::new(&normals);
    let reference = DirectSum::new(degree, order);
    let (mut error, mut peaks) = (0.0, 0.0);
    for material in &materials.entries {
        let material = material.luminance();
        let scattered: Vec<_> = normals
            .iter()
            .map(|&n| reference.at(n))
            .map(|at| (at.scatter(&material), at))
            .collect();
        for light in &lights.entries {
            let light = light.luminance();
            let light: Vec<f64> = light.iter().map(|value| value / light[0]).collect();
            let found =
                shader.polynomial((degree, &light), (order, &material), &owned).expect("it fits");
            let expected = scattered.iter().map(|(scattered, at)| at.irradiance(&light, scattered));
            let (mut square, mut peak) = (0.0, 0.0f64);
            for (found, expected) in found.iter().zip(expected) {
                square += (found - expected).powi(2) / normals.len() as f64;
                peak = peak.max(expected.abs());
            }
            error += square;
            peaks += peak * peak;
        }
    }
    let relative = (error / peaks).sqrt();
    println!("{relative:.2e}, trimmed by {said:.2e} of the deviation");
    assert!(relative <= FULL_SCENE, "{relative}");
}
