//! What a program says to the host, by semihosting and without `core::fmt`.

use semihosting::process::ExitCode;
use semihosting::sys::arm_compat::sys_writec;

/// Says a text.
pub fn say(text: &str) {
    text.bytes().for_each(sys_writec);
}

/// Says one character.
pub fn say_character(character: u8) {
    sys_writec(character);
}

/// The powers of ten.
static UNITS: [u32; 10] =
    [1_000_000_000, 100_000_000, 10_000_000, 1_000_000, 100_000, 10_000, 1_000, 100, 10, 1];

/// Says a number, after a space.
pub fn say_number(number: u32) {
    sys_writec(b' ');
    let mut rest = number;
    let mut started = false;
    for &unit in &UNITS {
        // Small machines do not divide.
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

/// Ends the program.
pub fn exit(well: bool) -> ! {
    if well { ExitCode::SUCCESS.exit_process() } else { ExitCode::FAILURE.exit_process() }
}
