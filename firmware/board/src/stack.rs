//! How much stack something takes: the stack is painted, and afterwards the paint that
//! is left is measured.

use core::hint::black_box;

const PAINT: u32 = 0x5bad_c0de;

/// Bytes that are painted, where there are so many.
const REACH: usize = 12 * 1024;

/// Bytes below this function's own place that are not painted: its callees'.
const MARGIN: usize = 128;

#[expect(unsafe_code, reason = "an address that the linker knows; nothing is read there")]
unsafe extern "C" {
    #[cfg(target_arch = "arm")]
    #[link_name = "__sheap"]
    static END_OF_STATICS: u32;
    #[cfg(not(target_arch = "arm"))]
    #[link_name = "__ebss"]
    static END_OF_STATICS: u32;
}

/// Bytes of stack that `something` takes, to within a frame of this function.
#[inline(never)]
pub fn taken(something: impl FnOnce()) -> u32 {
    let here = 0_u32;
    let top = black_box(&raw const here) as usize;
    let lowest = ((&raw const END_OF_STATICS) as usize).max(top - REACH);
    let painted = (lowest.next_multiple_of(4)..top - MARGIN).step_by(4);
    painted.clone().for_each(|address| {
        #[expect(unsafe_code, reason = "below the stack pointer and above the statics nothing lives")]
        // SAFETY: RAM, aligned, and no interrupt is on that might use it.
        unsafe {
            (address as *mut u32).write_volatile(PAINT);
        }
    });
    something();
    let touched = painted.clone().find(|&address| {
        #[expect(unsafe_code, reason = "reads what was painted")]
        // SAFETY: RAM, aligned.
        unsafe {
            (address as *const u32).read_volatile() != PAINT
        }
    });
    // All paint left: the margin was enough.
    touched.map_or(MARGIN, |address| top - address) as u32
}
