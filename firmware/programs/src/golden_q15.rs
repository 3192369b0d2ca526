//! The golden vectors in Q15, bit for bit.
#![no_std]
#![no_main]

use eigenshade::q15::{Light, Material, Normal};
use eigenshade::{Error, Q15};
use programs::golden::q15::{NORMALS, PAIRS};
use programs::golden::{Pair, Tally, compare_all};

programs::program!();

fn golden() {
    compare_all(&PAIRS, compare);
}

fn compare(pair: &Pair<Q15, i32>, tally: &mut Tally) -> Result<(), Error> {
    let light = Light::new(pair.light.1, pair.light.0)?;
    let material = Material::new(pair.material.1, pair.material.0)?;
    let d = table::relight(&table::transfer(&material)?.view(), &light)?;
    let scene = table::collapse(&d);
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
