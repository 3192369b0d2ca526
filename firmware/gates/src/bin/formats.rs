//! Formats a number.
#![no_std]
#![no_main]

use core::fmt::Write;
use core::hint::black_box;

board::program!(main);

struct Voice;

impl Write for Voice {
    fn write_str(&mut self, text: &str) -> core::fmt::Result {
        board::say(text);
        Ok(())
    }
}

fn main() {
    let _ = writeln!(Voice, "{}", black_box(7_u32));
}
