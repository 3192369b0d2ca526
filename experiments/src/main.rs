//! The program `experiments`.

mod commands;

use clap::Parser;
use commands::Command;
use eigenshade_cli::messages::report_error;
use std::process::ExitCode;

/// Measures what the documentation of eigenshade states.
///
/// Run it from the repository's root. Messages go to standard error. Exit status: 0, 1 if a check
/// fails or an input is bad, 2 for wrong usage.
#[derive(Debug, Parser)]
#[command(name = "experiments", arg_required_else_help = true)]
struct Program {
    #[command(subcommand)]
    command: Command,
}

fn main() -> ExitCode {
    #[cfg(unix)]
    eigenshade_cli::output::clean_up_on_signals();
    match Program::parse().command.run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            report_error(fault);
            ExitCode::from(1)
        }
    }
}
