//! A new light on a fixed material, K = 50.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::sphere::{self, Coefficients, DEGREE, ORDER};
use programs::inputs;

program!(main);

fn main() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = sphere::transfer(&inputs::material(&material, ORDER)) else {
        board::exit(false)
    };
    let transfer = black_box(transfer);
    let mut coefficients = Coefficients::new();
    let _ = coefficients.resize_default(sphere::COMPONENTS);
    holds(size_of_val(&transfer) + size_of_val(&coefficients));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = inputs::light(light, DEGREE);
        sphere::relight_into(&transfer, &light, black_box(&mut coefficients)).is_ok()
    });
}
