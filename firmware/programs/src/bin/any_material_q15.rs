//! A scene in colour with fifty components: any light on any material, both may change.
//! Everything that it takes is in it; tables, start-up, and a picture as text.
#![no_std]
#![no_main]

use board::{exit, program, say, say_number, stack};
use eigenshade::quantised::{Light, Material};
use eigenshade::sphere::q15::{self, Scene};
use eigenshade::{Error, Q15};
use programs::golden::Pair;
use programs::golden::q15::PAIRS;
use programs::picture;

program!(main);

fn main() {
    let bytes = stack::taken(|| {
        if run().is_err() {
            exit(false);
        }
    });
    say("stack");
    say_number(bytes);
    say("\n");
}

/// The light of one pair for each channel, on the material of another.
fn run() -> Result<(), Error> {
    let [red, green, blue, ..] = &PAIRS;
    let channels = [scene(red, green)?, scene(green, green)?, scene(blue, green)?];
    picture::draw(|normal| channels.each_ref().map(|scene| q15::shade(scene, normal)));
    Ok(())
}

fn scene(light: &Pair<Q15, i32>, material: &Pair<Q15, i32>) -> Result<Scene, Error> {
    let light = Light::new(q15::DEGREE, light.of_light, light.light)?;
    let material = Material::new(q15::ORDER, material.of_material, material.material)?;
    q15::collapse(&q15::relight(&q15::fold(&material)?.view(), &light)?)
}
