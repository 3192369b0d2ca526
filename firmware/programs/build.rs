//! Tables and golden vectors as statics, and the linker script of the start-up code.

use eigenshade_table::quantise::{Format, QuantisedParts};
use eigenshade_table::{rust_quantised, rust_source};
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
        if let Err(error) = bake(&from, name, tolerance) {
            println!("cargo::error={error}");
            process::exit(1);
        }
    }
}

/// Writes the statics of the table at `from`, trimmed, to the output folder: `name`.rs,
/// `name`_q15.rs and `name`_q31.rs.
fn bake(from: &str, name: &str, tolerance: f64) -> Result<(), String> {
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    let mut table = eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))?;
    let command = format!("build.rs, from {from}");
    for (format, suffix) in [(Format::Q15, "q15"), (Format::Q31, "q31")] {
        let parts = QuantisedParts::new(&table, format, tolerance)
            .map_err(|error| format!("{from}: {error}"))?;
        write(&format!("{name}_{suffix}.rs"), &rust_quantised::module(&parts, &command))?;
    }
    eigenshade_table::trim::trim(&mut table, tolerance);
    write(&format!("{name}.rs"), &rust_source::module(&table, &command))
}

/// Writes a file of the output folder.
fn write(name: &str, text: &str) -> Result<(), String> {
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(name);
    fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
}
