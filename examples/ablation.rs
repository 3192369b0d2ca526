//! What each effect costs and is worth, as a page:
//! `cargo run --release --example ablation -- --out docs/ablation.md`, or with `--check` instead
//! of `--out` to compare the page with what is counted and computed now. Times are told,
//! not compared.

#[path = "../tests/ablation/mod.rs"]
mod ablation;
#[path = "../tests/tolerances/mod.rs"]
mod tolerances;

use ablation::{compare, page, speed};
use std::process::ExitCode;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (purpose, path) = match arguments.as_slice() {
        [purpose, path] if purpose == "--out" || purpose == "--check" => (purpose, path),
        _ => {
            eprintln!("usage: ablation --out FILE | --check FILE");
            return ExitCode::from(2);
        }
    };
    let text = page::page(|scene| match scene {
        Some(scene) => vec![speed::of_scene(scene)],
        None => speed::of_changes().to_vec(),
    });
    let answer = if purpose == "--out" {
        std::fs::write(path, text).map_err(|error| format!("{path}: {error}"))
    } else {
        std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}")).and_then(
            |recorded| {
                compare::compare(&recorded, &text).map_err(|fault| format!("{path}: {fault}"))
            },
        )
    };
    match answer {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}; make it again with `{}`", page::COMMAND);
            ExitCode::from(1)
        }
    }
}
