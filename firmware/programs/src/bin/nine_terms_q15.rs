//! A pixel by the nine-term formula in Q15.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use eigenshade::Q15;
use eigenshade::quantized::NineTerms;
use programs::integer_inputs as inputs;

program!(main);

fn main() {
    let coefficients = [9000, 500, -3000, 8000, -700, -1200, 2500, 900, 3100];
    let formula = black_box(NineTerms::<Q15>::new(black_box(coefficients), -15));
    measure(&inputs::normals(), Passes(256), |normal| formula.shade(*normal));
}
