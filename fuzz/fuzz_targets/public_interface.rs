//! Any numbers into look-ups, baking, rotation, windows, truncation and estimates: no panic, and
//! what holds of moderate numbers.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::public_interface(bytes));

/// Without libFuzzer: the files that are named.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::public_interface(&std::fs::read(path)?);
    }
    Ok(())
}
