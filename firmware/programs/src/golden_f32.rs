//! The golden vectors in f32, to the tolerance that they state.
#![no_std]
#![no_main]

use eigenshade::{Error, Light, Material, Normal};
use programs::golden::f32::{NORMALS, PAIRS, TOLERANCE};
use programs::golden::{Pair, Tally, compare_all};

programs::program!();

fn golden() {
    compare_all(&PAIRS, compare);
}

fn compare(pair: &Pair<f32, f32>, tally: &mut Tally) -> Result<(), Error> {
    let light = Light::from_finite(pair.light.0)?;
    let material = Material::from_finite(pair.material.0)?;
    let projected = table::project(&light, &material)?;
    let relit = table::relight(&table::transfer(&material)?, &light)?;
    let ((d, _), (irradiances, _)) = (pair.d, pair.irradiance);
    for (&expected, (&projected, &relit)) in d.iter().zip(projected.iter().zip(&relit)) {
        tally.count(near(projected, expected, d));
        tally.count(near(relit, expected, d));
    }
    let scene = table::collapse(&relit);
    let (normals, _) = NORMALS.as_chunks::<3>();
    for (&[x, y, z], &expected) in normals.iter().zip(irradiances) {
        let normal = Normal::new(x, y, z)?;
        tally.count(near(scene.shade(normal), expected, irradiances));
        tally.count(near((*scene).shade(normal), expected, irradiances));
    }
    Ok(())
}

/// Whether a number is the expected one, to the tolerance times the largest expected one.
fn near(found: f32, expected: f32, all_expected: &[f32]) -> bool {
    let largest = all_expected.iter().fold(0.0_f32, |most, number| most.max(number.abs()));
    (found - expected).abs() <= TOLERANCE * largest
}
