//! Formats a number.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::hint::black_box;

board::program!(main);

struct Output;

impl Write for Output {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        board::print(text);
        Ok(())
    }
}

fn main() {
    let _ = writeln!(Output, "{}", black_box(7_u32));
}
