//! Writes the tables as modules, for any material or, in Q15, for the one material of a scene.

mod one_material;

use eigenshade_table::quantize;
use eigenshade_table::reduce::with_components;
use eigenshade_table::trim::trim;
use eigenshade_table::{Table, statics};
use one_material::{COMMAND, one_material, parts};
use std::path::PathBuf;
use std::{env, fs, process};

type Result<T> = std::result::Result<T, String>;

/// The list of the tables of several sizes.
const SIZES: &str = "sizes.csv";

/// Light of degree 2 on Lambertian materials, and how far its polynomials are trimmed.
const LAMBERTIAN: (&str, f64) = ("lambertian.bin", 2e-4);

/// The folder of the scenes' tables. The databases that they name are relative to it.
const SCENES: &str = "../scenes";

fn main() {
    if let Err(error) = modules().and_then(|text| write(&text)) {
        println!("cargo::error={error}");
        process::exit(1);
    }
}

/// A module for each table.
fn modules() -> Result<String> {
    let mut text = String::new();
    let mut table = decoded(LAMBERTIAN.0)?;
    trim(&mut table, LAMBERTIAN.1);
    text += &any_material("lambertian", &table)?;
    let sizes = read(SIZES)?;
    for line in sizes.lines().filter(|line| !line.starts_with('#')).skip(1) {
        text += &size(line).map_err(|fault| format!("{SIZES}: `{line}`: {fault}"))?;
    }
    println!("cargo::rerun-if-changed={SCENES}");
    let fault = |error| format!("{SCENES}: {error}");
    let files = fs::read_dir(SCENES).map_err(fault)?.map(|file| file.map(|file| file.path()));
    let mut files: Vec<PathBuf> = files.collect::<std::io::Result<_>>().map_err(fault)?;
    files.retain(|path| path.extension().is_some_and(|extension| extension == "bin"));
    files.sort();
    for path in files {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let path = path.to_string_lossy();
        text += &one_scene(&name, &decoded(&path)?).map_err(|fault| format!("{path}: {fault}"))?;
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
    let mut text = statics::floats(table, COMMAND);
    text += &in_module("q15", &statics::integers(&parts(table)?, COMMAND));
    Ok(in_module(name, &text))
}

/// The module of a scene: f32 for any material, Q15 for its material.
fn one_scene(name: &str, table: &Table) -> Result<String> {
    let material = coefficients(table)?;
    let (mantissas, exponents) = quantize::material(table.gram.order, &material);
    let in_q15 = one_material(table, &exponents, &mantissas)?;
    let text = statics::floats(table, COMMAND) + &in_module("q15", &in_q15);
    Ok(in_module(name, &text))
}

/// The material that a scene names, or the first of its database, whose rows are in storage order.
fn coefficients(table: &Table) -> Result<Vec<f64>> {
    let [database] = table.scene.material.database.as_slice() else {
        return Err("a scene needs one material database".into());
    };
    let database = format!("{SCENES}/{database}");
    let text = read(&database)?;
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let mut rows = rows.filter_map(|row| row.split_once(',')).peekable();
    let first = rows.peek().map(|(name, _)| (*name).to_owned());
    let name = table.scene.material.names.first().cloned().or(first).unwrap_or_default();
    let values = rows.filter(|(found, _)| *found == name);
    let value = |(_, row): (&str, &str)| row.rsplit(',').next().and_then(|one| one.parse().ok());
    let count = eigenshade::index::material::count(table.gram.order);
    let values: Option<Vec<f64>> = values.take(count).map(value).collect();
    let values = values.filter(|values| values.len() == count);
    values.ok_or_else(|| format!("{database}: `{name}` has no {count} values"))
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
