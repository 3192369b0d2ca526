//! The shipped databases, compiled in: they are there whatever files lie about.

use eigenshade_generator::database::{Lights, Materials};
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::coefficient_csv::{read_lights, read_materials};
use std::io::Write;
use std::path::Path;

const LIGHTS: &str = include_str!("../../../tables/inputs/lights.csv");
const MATERIALS: &str = include_str!("../../../tables/inputs/materials.csv");

/// The 26 captured lights.
///
/// # Errors
///
/// If the folder for temporary files cannot be written to.
pub fn lights() -> Result<Lights> {
    from_text(LIGHTS, |path| read_lights(path, None))
}

/// The 62 materials.
///
/// # Errors
///
/// As [`lights`].
pub fn materials() -> Result<Materials> {
    from_text(MATERIALS, |path| read_materials(path, None))
}

/// Reads a text that is not in a file by way of one.
fn from_text<T>(text: &str, read: impl FnOnce(&Path) -> Result<T>) -> Result<T> {
    let fault = |error: std::io::Error| Error::io(std::env::temp_dir(), &error);
    let mut file = tempfile::NamedTempFile::new().map_err(fault)?;
    file.write_all(text.as_bytes()).map_err(fault)?;
    read(file.path())
}
