//! A table in f32: a pixel, and a new light on a material that is transferred at start-up.
#![no_std]
#![no_main]

use board::{Passes, measure_named};
use core::hint::black_box;
use eigenshade::Light;
use programs::inputs::floats as inputs;
use table::{COMPONENTS, LIGHT, ORDER};

programs::program!();

const MATERIAL: usize = eigenshade_table::material::count(ORDER);

fn scene() {
    let material = inputs::numbers::<MATERIAL>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let numbers = inputs::numbers::<COMPONENTS>();
    let mut d = table::Coefficients::from(numbers);
    let mut scene = table::collapse(&d);
    board::holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scene));
    let lights = [inputs::numbers::<LIGHT>()];
    measure_named("light", &lights, Passes(64), |light| {
        let light = Light::from_finite(light)?;
        table::relight_into(&transfer, &light, &mut d)?;
        table::collapse_into(&d, black_box(&mut scene));
        Ok::<(), eigenshade::Error>(())
    });
    let scene = black_box(scene);
    measure_named("pixel", &inputs::normals(), Passes(64), |normal| scene.shade(*normal));
}
