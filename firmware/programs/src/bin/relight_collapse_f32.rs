//! A new light on a fixed material, up to the scene, K = 50.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::Light;
use eigenshade::sphere::{self, COMPONENTS};
use programs::inputs;

program!(main);

fn main() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = sphere::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut coefficients =
        eigenshade::specialized::coefficients(inputs::numbers::<COMPONENTS>(), &[]);
    let Ok(mut scene) = sphere::collapse(&coefficients) else { board::exit(false) };
    holds(size_of_val(&transfer) + size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = Light::new(light)?;
        sphere::relight_into(&transfer, &light, &mut coefficients)?;
        sphere::collapse_into(&coefficients, black_box(&mut scene))
    });
}
