//! Multiplies in f32, where there is no float unit.
#![no_std]
#![no_main]

use core::hint::black_box;

board::program!(main);

fn main() {
    let product = black_box(1.5_f32) * black_box(2.5);
    board::say_number(u32::from(product.to_bits() == 0));
}
