//! The golden vectors in f32, to the tolerance that they state.
#![no_std]
#![no_main]

use eigenshade::{Error, Light, Material, Normal, sphere};
use programs::golden::f32::{NORMALS, PAIRS, TOLERANCE};
use programs::golden::{Pair, report};

board::program!(main);

fn main() {
    let (mut right, mut all) = (0, 0);
    for pair in &PAIRS {
        if compare(pair, &mut right, &mut all).is_err() {
            board::exit(false);
        }
    }
    report(right, all);
}

/// Checks answers against what is expected, by the largest of them.
fn check(found: f32, expected: f32, all_expected: &[f32]) -> u32 {
    let largest = all_expected.iter().fold(0.0_f32, |most, number| most.max(number.abs()));
    u32::from((found - expected).abs() <= TOLERANCE * largest)
}

fn compare(pair: &Pair<f32, f32>, right: &mut u32, all: &mut u32) -> Result<(), Error> {
    let light = Light::new(pair.light.0)?;
    let material = Material::new(pair.material.0)?;
    let projected = sphere::project(&light, &material)?;
    let relit = sphere::relight(&sphere::transfer(&material)?, &light)?;
    let ((d, _), (irradiances, _)) = (pair.d, pair.irradiance);
    for (&expected, (&projected, &relit)) in d.iter().zip(projected.iter().zip(&relit)) {
        *right += check(projected, expected, d) + check(relit, expected, d);
        *all += 2;
    }
    let scene = sphere::collapse(&relit)?;
    let (normals, _) = NORMALS.as_chunks::<3>();
    for (&[x, y, z], &expected) in normals.iter().zip(irradiances) {
        let normal = Normal::new(x, y, z)?;
        *right += check(sphere::shade(&scene, normal), expected, irradiances);
        *right += check(scene.shade(normal), expected, irradiances);
        *all += 2;
    }
    Ok(())
}
