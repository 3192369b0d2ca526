//! Projection and reconstruction in every format are close to the results in f64.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::project_reconstruct(bytes));

/// Without libFuzzer: runs on the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::project_reconstruct(&std::fs::read(path)?);
    }
    Ok(())
}
