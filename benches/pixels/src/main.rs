//! How near each path is to the limit of the target's arithmetic, and the pixel loop to the
//! nine-term formula: docs/performance.md says what the limit is. `run` calls it.
//!
//! `times` and `counts` print their table; `--write` puts it into that page, and `counts --check`
//! fails where a path takes more instructions than the page says.

mod color;
mod images;
mod inputs;
mod limit;
mod measured;
mod page;

use std::process::ExitCode;

const USAGE: &str = "times [--write], or counts [--write | --check]";

fn main() -> ExitCode {
    let mut arguments = std::env::args().skip(1);
    let what = arguments.next();
    if what.as_deref() == Some(measured::SHADE) {
        measured::shade(arguments);
        return ExitCode::SUCCESS;
    }
    match report(what.as_deref(), arguments.next().as_deref()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}

fn report(kind: Option<&str>, how: Option<&str>) -> Result<(), String> {
    let table = match (kind, how) {
        (Some(page::TIMES), None | Some("--write")) => {
            let (paths, multiply_add) = measured::timed(&images::all());
            page::of_times(&paths, multiply_add)
        }
        (Some(page::COUNTS), None | Some("--write" | "--check")) => {
            let paths = measured::counted(&images::all());
            if how == Some("--check") {
                page::check(&paths)?;
            }
            page::of_counts(&paths)
        }
        _ => return Err(USAGE.to_owned()),
    };
    println!("{table}");
    match (kind, how) {
        (Some(kind), Some("--write")) => page::write(kind, &table),
        _ => Ok(()),
    }
}
