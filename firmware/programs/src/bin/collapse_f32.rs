//! The coefficients of an image to its scene, K = 50.
#![no_std]
#![no_main]

use board::{Passes, holds, measure, program};
use core::hint::black_box;
use eigenshade::sphere;
use programs::inputs;

program!(main);

fn main() {
    let coefficients = eigenshade::specialized::coefficients(inputs::numbers(), &[]);
    let Ok(mut scene) = sphere::collapse(&coefficients) else { board::exit(false) };
    holds(size_of_val(&coefficients) + size_of_val(&scene));
    measure(&[coefficients], Passes(256), |coefficients| {
        sphere::collapse_into(coefficients, black_box(&mut scene)).is_ok()
    });
}
