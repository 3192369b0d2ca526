//! The golden vectors in Q15, bit for bit, and a sphere as text.
#![no_std]
#![no_main]
#![expect(dead_code, reason = "a program runs one of the functions")]

use eigenshade::Error;
use eigenshade::q15::{Light, Material, Normal};
use programs::golden::{Pair, Tally, compare_all};
use programs::inputs::integers::of;
use vectors::{Format, NORMALS, PAIRS};

programs::program!();

fn golden() {
    compare_all(&PAIRS, compare);
}

fn compare(pair: &Pair<Format, i32>, tally: &mut Tally) -> Result<(), Error> {
    let light = Light::new(pair.light.1, pair.light.0)?;
    let material = Material::new(pair.material.1, pair.material.0)?;
    let d = table::relight(&table::transfer(&material)?.view(), &light)?;
    let scene = table::collapse(&d)?;
    let (irradiances, exponent) = pair.irradiance;
    tally.count((d.mantissas(), d.exponent()) == pair.d);
    tally.count(scene.exponent() == exponent);
    let (normals, _) = NORMALS.as_chunks::<3>();
    tally.count(normals.len() == irradiances.len());
    for (&[x, y, z], &expected) in normals.iter().zip(irradiances) {
        let normal = Normal::from_unit(x, y, z)?;
        tally.count(scene.shade(normal) == expected && (*scene).shade(normal) == expected);
    }
    Ok(())
}

fn sphere() {
    draw().unwrap_or_else(|_| board::exit(false));
}

fn draw() -> Result<(), Error> {
    let [pair, ..] = &PAIRS;
    let light = Light::new(pair.light.1, pair.light.0)?;
    let material = Material::new(pair.material.1, pair.material.0)?;
    let d = table::relight(&table::transfer(&material)?.view(), &light)?;
    let scene = table::collapse(&d)?;
    programs::drawing::as_text(|x, y, z| {
        let [x, y, z] = [x, y, z].map(of);
        Some(table::shade(&scene, Normal::from_unit(x, y, z).ok()?))
    });
    Ok(())
}
