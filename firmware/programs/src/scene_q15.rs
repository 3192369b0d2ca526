//! A table in Q15: a pixel, and a new light on any material, which is transferred at start-up.
#![no_std]
#![no_main]

use board::{Passes, measure_named};
use core::hint::black_box;
use programs::inputs::integers as inputs;
use table::{Coefficients, DEGREE, ORDER, Scene};

programs::program!();

const LIGHT: usize = eigenshade_table::light::count(DEGREE);
const MATERIAL: usize = eigenshade_table::material::count(ORDER);

fn scene() {
    let material = inputs::numbers::<MATERIAL>();
    let Ok(transfer) = table::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut d = Coefficients::default();
    let mut scene = Scene::default();
    board::holds(size_of_val(&transfer) + size_of_val(&d) + size_of_val(&scene));
    let lights = [inputs::numbers::<LIGHT>()];
    measure_named("light", &lights, Passes(64), |light| {
        let light = inputs::light(light);
        table::relight_into(&transfer.view(), &light, &mut d)?;
        table::collapse_into(&d, black_box(&mut scene));
        Ok::<(), eigenshade::Error>(())
    });
    let scene = black_box(scene);
    measure_named("pixel", &inputs::normals(), Passes(256), |normal| scene.shade(*normal));
}
