//! A new material, folded into the basis, K = 50.
#![no_std]
#![no_main]

use board::{Passes, measure, program};
use eigenshade::sphere::{self, Transfer};
use programs::inputs;

program!(main);

fn main() {
    measure(&[inputs::numbers::<40>()], Passes(64), folded);
}

#[inline(never)]
fn folded(material: &[f32; 40]) -> Transfer {
    let material = inputs::material(material);
    sphere::transfer(&material).unwrap_or_else(|_| board::exit(false))
}
