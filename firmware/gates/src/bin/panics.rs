//! Has an index that may be out of range, so it must not link.
#![no_std]
#![no_main]

use core::hint::black_box;

board::program!(main);

fn main() {
    let numbers = black_box([1_u32, 2, 3]);
    board::print_u32(numbers[black_box(1_usize)]);
}
