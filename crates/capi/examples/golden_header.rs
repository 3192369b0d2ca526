//! Prints the golden file as a C header of constant arrays:
//! `cargo run -p eigenshade-capi --example golden_header > golden.h`.

#[path = "../tests/support/golden_header.rs"]
mod golden_header;

use std::process::ExitCode;

fn main() -> ExitCode {
    match golden_header::text() {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(fault) => {
            eprintln!("error: tests/golden/sphere.csv: {fault}");
            ExitCode::FAILURE
        }
    }
}
