//! Writes the table that `EIGENSHADE_TABLE` names as statics to the output folder. Without it the
//! module has the shipped table.

use eigenshade_table::{Table, statics};
use std::path::{Path, PathBuf};
use std::{env, fs, process};

fn main() {
    println!("cargo::rerun-if-env-changed=EIGENSHADE_TABLE");
    println!("cargo::rustc-check-cfg=cfg(own_table)");
    let Some(path) = env::var_os("EIGENSHADE_TABLE").map(PathBuf::from) else { return };
    println!("cargo::rerun-if-changed={}", path.display());
    println!("cargo::rustc-cfg=own_table");
    if let Err(error) = bake(&path) {
        println!("cargo::error=EIGENSHADE_TABLE: {}: {error}", path.display());
        process::exit(1);
    }
}

/// Writes the statics of a table: `table.rs`.
fn bake(path: &Path) -> Result<(), String> {
    if !path.is_absolute() {
        return Err("build scripts run in another folder; give the whole path".into());
    }
    let bytes = fs::read(path).map_err(|error| error.to_string())?;
    let table = eigenshade_table::decode(&bytes).map_err(|error| error.to_string())?;
    fits(&table)?;
    let command = format!("build.rs, from {}", path.display());
    let text = statics::floats(&table, &command).map_err(|error| error.to_string())?;
    write("table.rs", &text)
}

/// Whether the module can project with a table.
fn fits(table: &Table) -> Result<(), String> {
    if !table.has_projection() {
        return Err("it stores only transfers; set store = \"projection\" in its scene".into());
    }
    Ok(())
}

/// Writes a file to the output folder.
fn write(name: &str, text: &str) -> Result<(), String> {
    let to = PathBuf::from(env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?).join(name);
    fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
}
