//! The coefficients of an image to its scene, K = 50.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use eigenshade::sphere::{self, Coefficients, Scene};
use programs::inputs;

program!(main);

fn main() {
    let coefficients = eigenshade::fixed::coefficients(inputs::numbers(), &[]);
    measure(&[coefficients], Passes(256), collapsed);
}

#[inline(never)]
fn collapsed(coefficients: &Coefficients) -> Scene {
    sphere::collapse(coefficients).unwrap_or_else(|_| board::exit(false))
}
