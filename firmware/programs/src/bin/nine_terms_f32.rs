//! A pixel by the nine-term formula.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use core::hint::black_box;
use eigenshade::NineTerms;
use programs::inputs;

program!(main);

fn main() {
    let formula = black_box(NineTerms::new(inputs::numbers::<9>()));
    measure(&inputs::normals(), Passes(64), |normal| formula.shade(*normal));
}
