//! Output to the host and the end of a program, by semihosting and without `core::fmt`.

use ::semihosting::process::ExitCode;
use ::semihosting::sys::arm_compat::sys_writec;

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
