//! Tables and golden vectors as statics, and the linker script of the start-up code.

use std::path::PathBuf;
use std::{env, fs, process};

/// The tables by name of the module, and how far their polynomials are trimmed; `sphere`
/// is the runtime's own.
const TABLES: [(&str, f64); 2] = [("full", 1e-4), ("lambertian", 1e-4)];

fn main() {
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    for (name, tolerance) in TABLES {
        let from = format!("../tables/{name}.bin");
        println!("cargo::rerun-if-changed={from}");
        if let Err(error) = bake(&from, &format!("{name}.rs"), tolerance) {
            println!("cargo::error={error}");
            process::exit(1);
        }
    }
}

/// Writes the statics of the table at `from`, trimmed, to `to` in the output folder.
fn bake(from: &str, to: &str, tolerance: f64) -> Result<(), String> {
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    let mut table = eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))?;
    eigenshade_table::trim::trim(&mut table, tolerance);
    let source = eigenshade_table::rust_source::module(&table, &format!("build.rs, from {from}"));
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(to);
    fs::write(&to, source).map_err(|error| format!("{}: {error}", to.display()))
}
