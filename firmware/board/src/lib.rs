//! Support for a program on an emulated board: start-up code, output and its end by semihosting and
//! without `core::fmt`, an instruction count and the depth of the stack.
//!
//! The target determines the board: see `memory/`.
#![no_std]

#[cfg(target_arch = "arm")]
pub use cortex_m_rt::entry;
#[cfg(target_arch = "riscv32")]
pub use riscv_rt::entry;

pub mod stack;

pub mod measure;

use ::semihosting::process::ExitCode;
use ::semihosting::sys::arm_compat::sys_writec;
pub use measure::{Passes, holds, measure, measure_named};

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

/// Prints a text.
pub fn print(text: &str) {
    text.bytes().for_each(sys_writec);
}

/// Prints one byte.
pub fn print_byte(byte: u8) {
    sys_writec(byte);
}

/// The powers of ten.
static UNITS: [u32; 10] =
    [1_000_000_000, 100_000_000, 10_000_000, 1_000_000, 100_000, 10_000, 1_000, 100, 10, 1];

/// Prints a space and a number.
pub fn print_u32(number: u32) {
    sys_writec(b' ');
    let mut rest = number;
    let mut started = false;
    for &unit in &UNITS {
        // Small processors have no division.
        let mut digit = b'0';
        while rest >= unit {
            rest -= unit;
            digit += 1;
        }
        started |= digit > b'0' || unit == 1;
        if started {
            sys_writec(digit);
        }
    }
}

/// Ends the program with exit status 0, or 1 unless `success`.
pub fn exit(success: bool) -> ! {
    if success { ExitCode::SUCCESS.exit_process() } else { ExitCode::FAILURE.exit_process() }
}
