//! The program `eigenshade`.

mod commands;

use clap::{CommandFactory, FromArgMatches, Parser};
use commands::Command;
use eigenshade_cli::messages::{be_quiet, report_error};
use std::process::ExitCode;

/// Image irradiance from any isotropic material under any distant light.
///
/// CSV goes to standard output unless --out names a file, and messages to standard error. The file
/// `-` is standard input, where a CSV, a table or a scene is read. Exit status: 0; 1 for an error
/// (one line says what is wrong, where, and how to fix it); 2 for options that cannot be parsed.
#[derive(Debug, Parser)]
#[command(name = "eigenshade", version, arg_required_else_help = true)]
#[cfg_attr(
    not(feature = "generate"),
    command(
        after_help = "This build lacks the feature `generate`, and therefore light, material, basis, pack-object and read."
    )
)]
struct Program {
    /// Show errors, but no warnings, notes, reports and progress
    #[arg(short, long, global = true, display_order = 900)]
    quiet: bool,
    #[command(subcommand)]
    command: Command,
}

/// Lets every option take a negative number, which is then refused as a value and not as an option.
fn with_negative_numbers(command: clap::Command) -> clap::Command {
    command
        .mut_args(|one| {
            let takes = one.get_action().takes_values() && !one.is_positional();
            if takes { one.allow_negative_numbers(true) } else { one }
        })
        .mut_subcommands(with_negative_numbers)
}

fn main() -> ExitCode {
    #[cfg(unix)]
    eigenshade_cli::output::clean_up_on_signals();
    let matches = with_negative_numbers(Program::command()).get_matches();
    let program = Program::from_arg_matches(&matches);
    let Program { quiet, command } =
        program.unwrap_or_else(|error| error.format(&mut Program::command()).exit());
    if quiet {
        be_quiet();
    }
    match command.run(Program::command()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            report_error(error);
            ExitCode::from(1)
        }
    }
}
