//! The program `eigenshade`.

mod commands;

use clap::Parser;
use commands::{Command, Memory};
use eigenshade_cli::output::message::say_fault;
use std::process::ExitCode;

/// Image irradiance from any isotropic material under any distant light.
///
/// CSV goes to standard output unless --out names a file, messages to standard
/// error. Exit status: 0, 1 for bad input (one line says what, where and what to
/// do), 2 for wrong usage.
#[derive(Debug, Parser)]
#[command(name = "eigenshade", version, arg_required_else_help = true)]
#[cfg_attr(
    not(feature = "generate"),
    command(
        after_help = "This build has no feature `generate`: light, material, basis and read are missing."
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
    eigenshade_cli::output::signals::clean_up_on_end();
    let Program { memory, command } = Program::parse();
    match command.run(memory) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            say_fault(fault);
            ExitCode::from(1)
        }
    }
}
