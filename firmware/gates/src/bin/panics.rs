//! An index that may be out of range: does not link.
#![no_std]
#![no_main]

use core::hint::black_box;

board::program!(main);

fn main() {
    let numbers = black_box([1_u32, 2, 3]);
    board::say_number(numbers[black_box(1_usize)]);
}
