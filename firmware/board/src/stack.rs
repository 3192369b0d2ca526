//! The stack that a call uses: the free stack is filled with a pattern, and afterwards the part
//! that was overwritten is measured.

use core::arch::asm;

/// The pattern.
const PAINT: u32 = 0x5bad_c0de;

/// Maximum number of bytes to fill.
const REACH: usize = 48 * 1024;

#[expect(unsafe_code, reason = "the linker defines this address; nothing is read there")]
unsafe extern "C" {
    #[cfg(target_arch = "arm")]
    #[link_name = "__sheap"]
    static END_OF_STATICS: u32;
    #[cfg(not(target_arch = "arm"))]
    #[link_name = "__ebss"]
    static END_OF_STATICS: u32;
}

/// Bytes of stack that a call of `operation` uses.
#[inline(never)]
pub fn used(operation: impl FnMut()) -> u32 {
    let top = pointer();
    let lowest = ((&raw const END_OF_STATICS) as usize).max(top - REACH).next_multiple_of(4);
    let mut address = lowest;
    while address < top {
        #[expect(
            unsafe_code,
            reason = "the memory between the statics and the stack pointer is unused"
        )]
        // SAFETY: aligned RAM that no interrupt uses, since all are off.
        unsafe {
            (address as *mut u32).write_volatile(PAINT);
        }
        address += 4;
    }
    call(operation);
    let mut address = lowest;
    while address < top {
        #[expect(unsafe_code, reason = "reads the pattern back")]
        // SAFETY: aligned RAM.
        let found = unsafe { (address as *const u32).read_volatile() };
        if found != PAINT {
            break;
        }
        address += 4;
    }
    (top - address) as u32
}

/// Not inlined, so that everything it uses lies below the caller's stack pointer.
#[inline(never)]
fn call(mut operation: impl FnMut()) {
    operation();
}

/// The stack pointer.
#[inline(always)]
fn pointer() -> usize {
    let pointer: usize;
    #[expect(unsafe_code, reason = "the core library has no function for it")]
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
