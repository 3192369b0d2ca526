//! Inputs and outputs of the build script.

use std::path::PathBuf;
use std::{env, fs};

/// The lines of a file, without comments; if the file changes, the script runs again.
///
/// # Errors
///
/// If the file cannot be read.
pub fn read_lines(path: &str) -> Result<Vec<String>, String> {
    println!("cargo::rerun-if-changed={path}");
    let text = fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))?;
    Ok(text.lines().filter(|line| !line.starts_with('#')).map(str::to_owned).collect())
}

/// Writes a file of the output folder.
///
/// # Errors
///
/// If it cannot be written.
pub fn write_output(file: &str, text: &str) -> Result<(), String> {
    let folder = env::var_os("OUT_DIR").ok_or("OUT_DIR is not set")?;
    let to = PathBuf::from(folder).join(file);
    fs::write(&to, text).map_err(|error| format!("{}: {error}", to.display()))
}
