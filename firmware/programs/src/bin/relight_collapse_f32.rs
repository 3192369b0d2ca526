//! A new light on a fixed material, up to the scene, K = 50.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use eigenshade::sphere::{self, DEGREE, ORDER, Scene, Transfer};
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
fn relit(transfer: &Transfer, light: &[f32; 100]) -> Scene {
    let coefficients = sphere::relight(transfer, &inputs::light(light, DEGREE));
    let scene = coefficients.and_then(|coefficients| sphere::collapse(&coefficients));
    scene.unwrap_or_else(|_| board::exit(false))
}
