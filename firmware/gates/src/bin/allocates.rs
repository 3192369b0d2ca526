//! Has an allocator, and asks it for memory.
#![no_std]
#![no_main]

extern crate alloc;

use core::alloc::{GlobalAlloc, Layout};
use core::hint::black_box;

board::program!(main);

struct Nothing;

#[expect(unsafe_code, reason = "an allocator is")]
// SAFETY: it has nothing to give.
unsafe impl GlobalAlloc for Nothing {
    #[inline(never)]
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        black_box(core::ptr::null_mut())
    }
    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static ALLOCATOR: Nothing = Nothing;

fn main() {
    #[expect(unsafe_code, reason = "an allocator is")]
    // SAFETY: the layout has a size.
    let place = unsafe { alloc::alloc::alloc(Layout::new::<u32>()) };
    board::say_number(u32::from(black_box(place).is_null()));
}
