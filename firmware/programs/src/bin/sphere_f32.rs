//! A sphere as text, in f32.
#![no_std]
#![no_main]

use eigenshade::{Error, Light, Material, Normal, sphere};
use programs::drawing;
use programs::golden::f32::PAIRS;

board::program!(main);

fn main() {
    if draw().is_err() {
        board::exit(false);
    }
}

fn draw() -> Result<(), Error> {
    let [pair, ..] = &PAIRS;
    let light = Light::new(pair.light.0)?;
    let material = Material::new(pair.material.0)?;
    let scene = sphere::collapse(&sphere::project(&light, &material)?)?;
    drawing::draw(|x, y, z| {
        let [x, y, z] = [x, y, z].map(|fraction| fraction as f32);
        let normal = Normal::new(x, y, z).ok()?;
        Some((sphere::shade(&scene, normal) * 65536.0) as i32)
    });
    Ok(())
}
