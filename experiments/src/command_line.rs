//! The comment line of a generated file.

use eigenshade_cli::messages::printable;
use eigenshade_cli::output::write_error;
use eigenshade_model::error::Result;
use std::io::Write;

/// Writes the comment line `# experiments ...` with the command that makes this file.
///
/// # Errors
///
/// If the output fails.
pub fn write_command_line(out: &mut dyn Write) -> Result<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let line = printable(&arguments.join(" "));
    writeln!(out, "# experiments {line}").map_err(|error| write_error(&error))
}
