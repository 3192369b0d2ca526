//! The program `eigenshade`.

mod commands;

use clap::{CommandFactory, Parser};
use commands::{Command, Memory};
use eigenshade_cli::messages::{be_quiet, report_error};
use std::process::ExitCode;

/// Image irradiance from any isotropic material under any distant light.
///
/// CSV goes to standard output unless --out names a file, and messages to standard error. The file
/// `-` is standard input, where a CSV, a table or a scene is read. Exit status: 0; 1 for bad input
/// (one line says what is wrong, where, and how to fix it); 2 for wrong usage.
#[derive(Debug, Parser)]
#[command(name = "eigenshade", version, arg_required_else_help = true)]
#[cfg_attr(
    not(feature = "generate"),
    command(
        after_help = "This build lacks the feature `generate`, and therefore light, material, basis, pack-normals, read and npz."
    )
)]
struct Program {
    #[command(flatten)]
    memory: Memory,
    /// Show errors, but no warnings, notes, reports and progress
    #[arg(short, long, global = true, display_order = 900)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    #[cfg(unix)]
    eigenshade_cli::output::clean_up_on_signals();
    let Program { memory, quiet, command } = Program::parse();
    if quiet {
        be_quiet();
    }
    match command.run(memory, Program::command()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            report_error(error);
            ExitCode::from(1)
        }
    }
}
