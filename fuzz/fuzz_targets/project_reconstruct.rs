//! Projection, then reconstruction, in every format: near what f64 gives.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::project_reconstruct(bytes));

/// Without libFuzzer: the files that are named.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::project_reconstruct(&std::fs::read(path)?);
    }
    Ok(())
}
