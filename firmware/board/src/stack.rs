//! How much stack something takes: the stack is painted, and afterwards the paint that
//! is left is measured.

use core::arch::asm;

const PAINT: u32 = 0x5bad_c0de;

/// Bytes that are painted, where there are so many.
const REACH: usize = 12 * 1024;

#[expect(unsafe_code, reason = "an address that the linker knows; nothing is read there")]
unsafe extern "C" {
    #[cfg(target_arch = "arm")]
    #[link_name = "__sheap"]
    static END_OF_STATICS: u32;
    #[cfg(not(target_arch = "arm"))]
    #[link_name = "__ebss"]
    static END_OF_STATICS: u32;
}

/// Bytes of stack that a call of `something` takes.
#[inline(never)]
pub fn taken(something: impl FnMut()) -> u32 {
    let top = pointer();
    let lowest = ((&raw const END_OF_STATICS) as usize).max(top - REACH).next_multiple_of(4);
    let mut address = lowest;
    while address < top {
        #[expect(
            unsafe_code,
            reason = "below the stack pointer and above the statics nothing lives"
        )]
        // SAFETY: RAM, aligned, and no interrupt is on that might use it.
        unsafe {
            (address as *mut u32).write_volatile(PAINT);
        }
        address += 4;
    }
    apart(something);
    let mut address = lowest;
    while address < top {
        #[expect(unsafe_code, reason = "reads what was painted")]
        // SAFETY: RAM, aligned.
        let found = unsafe { (address as *const u32).read_volatile() };
        if found != PAINT {
            break;
        }
        address += 4;
    }
    (top - address) as u32
}

/// Apart from its caller, so that all it takes lies below the caller's stack pointer.
#[inline(never)]
fn apart(mut something: impl FnMut()) {
    something();
}

/// The stack pointer.
#[inline(always)]
fn pointer() -> usize {
    let pointer: usize;
    #[expect(unsafe_code, reason = "no function of the core library tells it")]
    // SAFETY: reads a register.
    unsafe {
        #[cfg(target_arch = "arm")]
        asm!("mov {}, sp", out(reg) pointer, options(nomem, nostack));
        #[cfg(target_arch = "riscv32")]
        asm!("mv {}, sp", out(reg) pointer, options(nomem, nostack));
        #[cfg(not(any(target_arch = "arm", target_arch = "riscv32")))]
        asm!("mov {}, rsp", out(reg) pointer, options(nomem, nostack));
    }
    pointer
}
