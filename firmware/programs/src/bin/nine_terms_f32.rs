//! A pixel by the nine-term formula.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use programs::{inputs, nine_terms};

program!(main);

fn main() {
    let coefficients = black_box(inputs::numbers::<8>());
    let normals = inputs::normals().map(eigenshade::Normal::components);
    measure(&normals, Passes(64), |normal| pixel(&coefficients, normal));
}

#[inline]
fn pixel(coefficients: &[f32; 8], normal: &[f32; 3]) -> f32 {
    nine_terms::shade(coefficients, *normal)
}
