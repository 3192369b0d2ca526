//! The golden file, what every machine has to answer in every number format:
//! `cargo run --release --example golden -- --out tests/golden/sphere.csv`, or with
//! `--check` instead of `--out` to compare the file with what is answered now.
//!
//! Integers have to be the same; floats may differ by the tolerance that the file states.

#[path = "../tests/golden/mod.rs"]
mod golden;
#[path = "../tests/tolerances/mod.rs"]
mod tolerances;

use golden::record::{Golden, Row};
use std::process::ExitCode;

const COMMAND: &str = "cargo run --release --example golden -- --out tests/golden/sphere.csv";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (purpose, path) = match arguments.as_slice() {
        [purpose, path] if purpose == "--out" || purpose == "--check" => (purpose, path),
        _ => {
            eprintln!("usage: golden --out FILE | --check FILE");
            return ExitCode::from(2);
        }
    };
    let answered = golden::answers::golden();
    let result = if purpose == "--out" {
        let head = [COMMAND, "What the rows are: docs/formats.md"];
        std::fs::write(path, answered.text(&head)).map_err(|error| format!("{path}: {error}"))
    } else {
        std::fs::read_to_string(path)
            .map_err(|error| format!("{path}: {error}"))
            .and_then(|text| Golden::parse(&text).map_err(|fault| format!("{path}: {fault}")))
            .and_then(|recorded| compare(path, &recorded, &answered))
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}; make it again with `{COMMAND}`");
            ExitCode::from(1)
        }
    }
}

fn compare(path: &str, recorded: &Golden, answered: &Golden) -> Result<(), String> {
    if recorded.rows.len() != answered.rows.len() {
        return Err(format!("{path}: it has other rows"));
    }
    for (old, new) in recorded.rows.iter().zip(&answered.rows) {
        if old != new && !near(old, new)? {
            let (pair, array) = (new.pair.join(" "), &new.array);
            return Err(format!("{path}: {} {pair} {array}: it is another now", new.format));
        }
    }
    Ok(())
}

/// Whether both are the same array of floats, to the tolerance times the largest.
fn near(old: &Row, new: &Row) -> Result<bool, String> {
    if old.format != "f32" || (&old.pair, &old.array) != (&new.pair, &new.array) {
        return Ok(false);
    }
    let (old, new) = (old.floats()?, new.floats()?);
    let largest = new.iter().fold(0.0f32, |most, number| most.max(number.abs()));
    let within = |(a, b): (&f32, &f32)| (a - b).abs() <= golden::tolerances::GOLDEN_F32 * largest;
    Ok(old.len() == new.len() && old.iter().zip(&new).all(within))
}
