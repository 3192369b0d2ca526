//! A new light on a fixed material, K = 50.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::sphere::{self, Coefficients};
use programs::inputs;

program!(main);

fn main() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = sphere::transfer(&inputs::material(&material)) else { board::exit(false) };
    let transfer = black_box(transfer);
    let mut coefficients = Coefficients::from([0.0; sphere::COMPONENTS]);
    holds(size_of_val(&transfer) + size_of_val(&coefficients));
    measure(&[inputs::numbers::<100>()], Passes(256), |light| {
        let light = inputs::light(light);
        sphere::relight_into(&transfer, &light, black_box(&mut coefficients)).is_ok()
    });
}
