//! Multiplies in f32 on a board without a float unit.
#![no_std]
#![no_main]

use core::hint::black_box;

board::program!(main);

fn main() {
    let product = black_box(1.5_f32) * black_box(2.5);
    board::print_u32(u32::from(product.to_bits() == 0));
}
