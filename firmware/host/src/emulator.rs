//! Running a program on its board.

use crate::Result;
use crate::board::Board;
use std::path::Path;
use std::process::Command;

/// Seconds after which a program hangs.
const PATIENCE: &str = "120";

/// Runs a program to its end; gives what it said.
///
/// # Errors
///
/// If it ends with another status than 0, or not at all.
pub fn run(board: Board, program: &Path) -> Result<String> {
    let (emulator, machine) = board.emulator();
    let mut command = Command::new("timeout");
    command
        .args([PATIENCE, emulator])
        .args(machine)
        .args(["-display", "none", "-monitor", "none", "-serial", "none", "-icount", "shift=0"])
        .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
        .arg(program);
    let output = command.output().map_err(|error| format!("{command:?}: {error}"))?;
    // The emulator writes what the program says to its standard error.
    let said = String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned();
    if output.status.success() {
        return Ok(said);
    }
    let status = match output.status.code() {
        Some(124) => format!("does not end within {PATIENCE} s"),
        Some(127) => format!("no {emulator}: apt-get install qemu-system-arm qemu-system-misc"),
        code => format!("ends with status {code:?}"),
    };
    Err(format!("{} on {}: {status}\n{said}", program.display(), board.name()))
}
