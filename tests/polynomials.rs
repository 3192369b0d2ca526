//! Polynomials that are too long for powers of t, against their Chebyshev series by cosines, and
//! trimmed polynomials against the direct sum (15).

use crate::invariants::integer::eigenimage;
use eigenshade::{Normal, Scalar};
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_shading::shipped;
use eigenshade_table::trim::trim;
use eigenshade_testing::fixtures::{of_equal_areas, shipped_table, spiral};

/// An eigenimage whose polynomial has an even and an odd half of ten terms, of its largest value:
/// its powers of u cancel, up to (1 + √2)^10 = 6,700 to one, and are rounded to 2^-24.
const HALVES_F32: f64 = 4e-4;

/// The same, rounded to 2^-53, after what the table's series was rounded to.
const HALVES_F64: f64 = 2e-12;

/// Each component alone, by collapsing it and by itself; of its largest value, the worst.
fn farthest<S: Scalar + Into<f64>>() -> f64 {
    let table = shipped_table("pbr");
    let owned = OwnedBasis::<S>::new(&table);
    let basis = owned.basis().expect("a basis");
    let lengths = basis.parts().lengths;
    assert!(lengths.iter().filter(|&&length| (17..=32).contains(&length)).count() >= 10);
    let mut worst = 0.0f64;
    for (k, component) in table.components.iter().enumerate() {
        let mut d = vec![S::ZERO; table.components.len()];
        d[k] = S::ONE;
        let scene = basis.collapse_into(&d, vec![S::ZERO; basis.scene_len()]).expect("sizes");
        let (mut off, mut largest) = (0.0f64, 0.0f64);
        for at in spiral((0..200).map(|k| (f64::from(k) + 0.5) / 200.0)) {
            let reference = eigenimage(&table, component, at);
            let [x, y, z] = at.map(S::from_f64);
            let normal = Normal::new(x, y, z).expect("visible");
            let alone = basis.reconstruct(&d, normal).expect("sizes");
            for found in [scene.shade(normal), alone] {
                off = off.max((found.into() - reference).abs());
            }
            largest = largest.max(reference.abs());
        }
        worst = worst.max(off / largest);
    }
    worst
}

#[test]
fn halves_cancel_little() {
    let (single, double) = (farthest::<f32>(), farthest::<f64>());
    println!("of an eigenimage's largest value: {single:.1e} in f32, {double:.1e} in f64");
    assert!(single <= HALVES_F32);
    assert!(double <= HALVES_F64);
}

/// Rms error of the firmware's full scene over the rms peak: what its components and terms are
/// chosen for.
const FULL_SCENE: f64 = 1e-4;

/// The table of `firmware/tables/full.toml`.
const TABLE: &[u8] = include_bytes!("../firmware/tables/full.bin");

/// The parts that the firmware's full scene leaves out, components and terms together: the root of
/// the mean square error over the root of the mean square of the images' peaks, lights
/// scaled to L_0^0 = 1.
#[test]
fn the_full_scene_keeps_its_tolerance() {
    let mut table = eigenshade_table::decode(TABLE).expect("a table");
    let said = trim(&mut table, 2e-4);
    assert!(said <= 2e-4, "{said}");
    let terms: usize =
        eigenshade_table::parts::floats(&table).lengths.iter().map(|&n| usize::from(n)).sum();
    assert!(terms <= 80, "{terms} for one sign of m");
    let basis = OwnedBasis::<f64>::new(&table);
    let basis = basis.basis().expect("a basis");
    let mut shader = Shader::new(basis, table.count());
    let (degree, order) = (table.gram.degree, table.gram.order);
    let lights = shipped::lights().expect("lights").truncated(degree);
    let materials = shipped::materials().expect("materials").truncated(order);
    let normals = of_equal_areas(200);
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
