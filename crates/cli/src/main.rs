//! The program `eigenshade`.

mod commands;

use clap::Parser;
use commands::Command;
use eigenshade_cli::message::say_fault;
use std::process::ExitCode;

/// Image irradiance from any isotropic material under any distant light.
///
/// CSV goes to standard output unless --out names a file, messages to standard
/// error. Exit status: 0, 1 for bad input (one line says what, where and what to
/// do), 2 for wrong usage.
#[derive(Debug, Parser)]
#[command(name = "eigenshade", version, arg_required_else_help = true)]
struct Program {
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    match Program::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            say_fault(fault);
            ExitCode::from(1)
        }
    }
}
