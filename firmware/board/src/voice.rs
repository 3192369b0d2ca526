//! What a program says to the host, by semihosting and without `core::fmt`.

use semihosting::process::ExitCode;
use semihosting::sys::arm_compat::sys_writec;

/// Says a text.
pub fn say(text: &str) {
    text.bytes().for_each(sys_writec);
}

/// Says a number, after a space.
pub fn say_number(number: u32) {
    sys_writec(b' ');
    let mut unit = 1;
    while number / unit >= 10 {
        unit *= 10;
    }
    let mut rest = number;
    while unit > 0 {
        // One digit each time: below 10.
        sys_writec(b'0' + (rest / unit) as u8);
        rest %= unit;
        unit /= 10;
    }
}

/// Ends the program.
pub fn exit(well: bool) -> ! {
    if well { ExitCode::SUCCESS.exit_process() } else { ExitCode::FAILURE.exit_process() }
}
