//! Has a static that is not zero at first.
#![no_std]
#![no_main]

use core::sync::atomic::{AtomicU32, Ordering};

board::program!(main);

static COUNT: AtomicU32 = AtomicU32::new(7);

fn main() {
    board::say_number(COUNT.load(Ordering::Relaxed));
    COUNT.store(8, Ordering::Relaxed);
}
