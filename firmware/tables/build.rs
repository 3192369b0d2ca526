//! Writes the tables as modules.

use eigenshade_table::quantize::{self, TOLERANCE};
use eigenshade_table::reduce::with_components;
use eigenshade_table::trim::trim;
use eigenshade_table::{Table, statics};
use std::path::PathBuf;
use std::{env, fs, process};

type Result<T> = std::result::Result<T, String>;

/// The list of the tables of several sizes.
const SIZES: &str = "sizes.csv";

/// The first line of each generated module.
const COMMAND: &str = "build.rs";

fn main() {
    if let Err(error) = modules().and_then(|text| write(&text)) {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// A module for each table.
fn modules() -> Result<String> {
    let mut text = String::new();
    let sizes = read(SIZES)?;
    for line in sizes.lines().filter(|line| !line.starts_with('#')).skip(1) {
        text += &size(line).map_err(|fault| format!("{SIZES}: `{line}`: {fault}"))?;
    }
    Ok(text)
}

fn in_module(name: &str, text: &str) -> String {
    format!("/// A table.\npub mod {name} {{\n{text}}}\n")
}

/// A table of the list: the first components of the one in a file, trimmed.
fn size(line: &str) -> Result<String> {
    let fields: Vec<&str> = line.split(',').collect();
    let [name, file, components, tolerance] = fields[..] else {
        return Err("four fields expected".into());
    };
    let fault = |error: &dyn std::fmt::Display| error.to_string();
    let components: usize = components.parse().map_err(|error| fault(&error))?;
    let whole = decoded(file)?;
    let mut table = with_components(&whole, |number, _| number < components);
    if !tolerance.is_empty() {
        trim(&mut table, tolerance.parse().map_err(|error| fault(&error))?);
    }
    any_material(name, &table)
}

/// The module of a table in the formats of its programs.
fn any_material(name: &str, table: &Table) -> Result<String> {
    let mut text = statics::floats(table, COMMAND).map_err(|error| error.to_string())?;
    let parts = quantize::integers(table, TOLERANCE).map_err(|error| error.to_string())?;
    text += &in_module("q15", &statics::integers(&parts, COMMAND));
    Ok(in_module(name, &text))
}

/// Reads a file, and builds again when it changes.
fn read(path: &str) -> Result<String> {
    println!("cargo::rerun-if-changed={path}");
    fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))
}

/// Reads a table.
fn decoded(path: &str) -> Result<eigenshade_table::Table> {
    println!("cargo::rerun-if-changed={path}");
    let bytes = fs::read(path).map_err(|error| format!("{path}: {error}"))?;
    eigenshade_table::decode(&bytes).map_err(|error| format!("{path}: {error}"))
}

fn write(text: &str) -> Result<()> {
    let folder = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?;
    let path = PathBuf::from(folder).join("tables.rs");
    fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))
}
