//! Look-ups, baking, rotations, windows, truncation and estimates with any numbers: no panic, and
//! further invariants for moderate numbers.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::public_interface(bytes));

/// Without libFuzzer: runs on the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::public_interface(&std::fs::read(path)?);
    }
    Ok(())
}
