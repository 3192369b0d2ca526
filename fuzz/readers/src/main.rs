//! The fuzz target of the host's readers. The environment variable `READER` chooses the reader:
//! `exr`, `hdr`, `pfm`, `png`, `obj`, `stl`, `ply`, `csv`, `toml`, `merl`, `formula` or `bin`.
#![cfg_attr(fuzzing, no_main)]

use eigenshade_fuzz_readers::chosen;

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|bytes: &[u8]| chosen()(bytes));

/// Without libFuzzer: reads the files that the arguments name.
#[cfg(not(fuzzing))]
fn main() -> std::io::Result<()> {
    for path in std::env::args_os().skip(1) {
        chosen()(&std::fs::read(path)?);
    }
    Ok(())
}
