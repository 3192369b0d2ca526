//! A new light on a fixed material, K = 50.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use eigenshade::sphere::{self, Coefficients, DEGREE, ORDER, Transfer};
use programs::inputs;

program!(main);

fn main() {
    let material = inputs::numbers::<40>();
    let Ok(transfer) = sphere::transfer(&inputs::material(&material, ORDER)) else {
        board::exit(false)
    };
    let transfer = black_box(transfer);
    measure(&[inputs::numbers::<100>()], Passes(256), |light| relit(&transfer, light));
}

#[inline(never)]
fn relit(transfer: &Transfer, light: &[f32; 100]) -> Coefficients {
    let light = inputs::light(light, DEGREE);
    sphere::relight(transfer, &light).unwrap_or_else(|_| board::exit(false))
}
