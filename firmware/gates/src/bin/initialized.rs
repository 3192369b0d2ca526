//! Has a static with an initial value other than zero.
#![no_std]
#![no_main]

use core::sync::atomic::{AtomicU32, Ordering};

board::program!(main);

static COUNT: AtomicU32 = AtomicU32::new(7);

fn main() {
    board::print_u32(COUNT.load(Ordering::Relaxed));
    COUNT.store(8, Ordering::Relaxed);
}
