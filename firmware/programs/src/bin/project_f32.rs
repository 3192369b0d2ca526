//! A light on a material to the coefficients of the image, K = 50.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use eigenshade::sphere::{self, Coefficients};
use programs::inputs;

program!(main);

fn main() {
    let material = black_box(inputs::numbers::<40>());
    measure(&[inputs::numbers::<100>()], Passes(64), |light| projected(light, &material));
}

#[inline(never)]
fn projected(light: &[f32; 100], material: &[f32; 40]) -> Coefficients {
    let (light, material) = (inputs::light(light), inputs::material(material));
    sphere::project(&light, &material).unwrap_or_else(|_| board::exit(false))
}
