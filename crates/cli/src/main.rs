//! The program `eigenshade`.

mod commands;

use clap::Parser;
use commands::{Command, Memory};
use eigenshade_cli::messages::report_error;
use std::process::ExitCode;

/// Image irradiance from any isotropic material under any distant light.
///
/// CSV goes to standard output unless --out names a file, and messages to standard
/// error. Exit status: 0; 1 for bad input (one line says what is wrong, where, and
/// how to fix it); 2 for wrong usage.
#[derive(Debug, Parser)]
#[command(name = "eigenshade", version, arg_required_else_help = true)]
#[cfg_attr(
    not(feature = "generate"),
    command(
        after_help = "This build lacks the feature `generate`, and therefore light, material, basis, pack-normals and read."
    )
)]
struct Program {
    #[command(flatten)]
    memory: Memory,
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    #[cfg(unix)]
    eigenshade_cli::output::clean_up_on_signals();
    let Program { memory, command } = Program::parse();
    match command.run(memory) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            report_error(error);
            ExitCode::from(1)
        }
    }
}
