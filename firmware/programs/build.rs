//! Tables and golden vectors as statics, and the linker script of the start-up code.

use std::path::PathBuf;
use std::{env, fs, process};

/// The tables by name of the module; `sphere` is the runtime's own.
const TABLES: [&str; 2] = ["full", "lambertian"];

fn main() {
    if env::var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    for name in TABLES {
        let from = format!("../tables/{name}.bin");
        println!("cargo::rerun-if-changed={from}");
        if let Err(error) = bake(&from, &format!("{name}.rs")) {
            println!("cargo::error={error}");
            process::exit(1);
        }
    }
}

/// Writes the statics of the table at `from` to `to` in the output folder.
fn bake(from: &str, to: &str) -> Result<(), String> {
    let bytes = fs::read(from).map_err(|error| format!("{from}: {error}"))?;
    let table = eigenshade_table::decode(&bytes).map_err(|error| format!("{from}: {error}"))?;
    let source = eigenshade_table::rust_source::module(&table, &format!("build.rs, from {from}"));
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(to);
    fs::write(&to, source).map_err(|error| format!("{}: {error}", to.display()))
}
