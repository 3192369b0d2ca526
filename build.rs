//! Decodes the shipped table into typed statics.

use std::path::PathBuf;
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-changed=tables/sphere.bin");
    if env::var_os("CARGO_FEATURE_BAKED").is_none() {
        return;
    }
    if let Err(error) = bake("tables/sphere.bin", "sphere.rs") {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// Writes the statics of the table at `from` to `to` in the output folder.
fn bake(from: &str, to: &str) -> Result<(), String> {
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    let table = eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))?;
    if !table.has_projection() {
        return Err(format!(
            "{from} keeps transfers alone; set store = \"projection\" in its scene"
        ));
    }
    let source = eigenshade_table::rust_source::module(&table, &format!("build.rs, from {from}"));
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(to);
    fs::write(&to, source).map_err(|error| format!("{}: {error}", to.display()))
}
