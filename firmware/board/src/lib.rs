//! What a program needs on an emulated board: start-up code, output, an instruction count and the
//! depth of the stack.
//!
//! The target determines the board: see `memory/`.
#![no_std]

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

pub mod semihosting;

pub mod stack;

pub mod measure;

pub use measure::{Passes, holds, measure, measure_named};
pub use semihosting::{exit, print, print_byte, print_u32};

/// Makes the function of this name the program.
#[macro_export]
macro_rules! program {
    ($body:path) => {
        #[$crate::entry]
        fn start() -> ! {
            $body();
            $crate::exit(true)
        }
    };
}

/// Calls an undefined symbol, so that a program with a reachable panic fails to link.
#[cfg(target_os = "none")]
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    #[expect(unsafe_code, reason = "the symbol is undefined on purpose")]
    unsafe extern "C" {
        fn a_panic_can_be_reached() -> !;
    }
    #[expect(unsafe_code, reason = "never linked, so never called")]
    // SAFETY: a program with this call is not linked.
    unsafe {
        a_panic_can_be_reached()
    }
}
