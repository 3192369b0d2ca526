//! Any bytes as a table give an error, or a basis that projects and shades, never a panic.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::from_bytes(bytes));

/// Without libFuzzer: runs on the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::from_bytes(&std::fs::read(path)?);
    }
    Ok(())
}
