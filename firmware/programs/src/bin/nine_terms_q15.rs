//! A pixel by the nine-term formula in Q15.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use programs::nine_terms;

program!(main);

fn main() {
    let coefficients = black_box([9000, -3000, 8000, 500, -1200, 2500, 3100, -700]);
    let normals = [[0, 0, 32767], [18918, -18918, 18918], [-23170, 0, 23170], [0, 23170, 23170]];
    measure(&normals, Passes(256), |normal| pixel(&coefficients, normal));
}

#[inline]
fn pixel(coefficients: &[i16; 8], normal: &[i16; 3]) -> i32 {
    nine_terms::shade_q15(coefficients, *normal)
}
