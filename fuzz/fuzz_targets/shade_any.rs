//! Any light, material, normals, transfer and coefficients: f32 stays finite, and integers stay in
//! range and never wrap.
#![cfg_attr(fuzzing, no_main)]

#[path = "../../tests/invariants/mod.rs"]
mod invariants;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| invariants::shade_any(bytes));

/// Without libFuzzer: runs on the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        invariants::shade_any(&std::fs::read(path)?);
    }
    Ok(())
}
