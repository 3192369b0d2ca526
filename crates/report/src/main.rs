//! The program `report`.

mod commands;

use clap::Parser;
use commands::Command;
use eigenshade_cli::messages::report_error;
use std::process::ExitCode;

fn main() -> ExitCode {
    #[cfg(unix)]
    eigenshade_cli::output::clean_up_on_signals();
    match Command::parse().run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            report_error(fault);
            ExitCode::from(1)
        }
    }
}
