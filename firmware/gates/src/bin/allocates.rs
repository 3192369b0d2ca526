//! Has an allocator and allocates.
#![no_std]
#![no_main]

extern crate alloc;

use core::alloc::{GlobalAlloc, Layout};
use core::hint::black_box;

board::program!(main);

struct NoMemory;

#[expect(unsafe_code, reason = "allocators are unsafe")]
// SAFETY: it always returns null.
unsafe impl GlobalAlloc for NoMemory {
    #[inline(never)]
    unsafe fn alloc(&self, _: Layout) -> *mut u8 {
        black_box(core::ptr::null_mut())
    }
    unsafe fn dealloc(&self, _: *mut u8, _: Layout) {}
}

#[global_allocator]
static ALLOCATOR: NoMemory = NoMemory;

fn main() {
    #[expect(unsafe_code, reason = "allocators are unsafe")]
    // SAFETY: the layout has a size.
    let place = unsafe { alloc::alloc::alloc(Layout::new::<u32>()) };
    board::print_u32(u32::from(black_box(place).is_null()));
}
