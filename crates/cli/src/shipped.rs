//! The shipped databases and table, compiled in: what is shown does not depend on the
//! files that lie about.

use eigenshade_generator::database::{Lights, Materials};
use eigenshade_generator::error::{Error, Result};
use eigenshade_generator::inputs::coefficient_csv::{read_lights, read_materials};
use std::io::Write;
use std::path::Path;

/// `tables/sphere.bin`.
pub const TABLE: &[u8] = include_bytes!("../../../tables/sphere.bin");
const LIGHTS: &str = include_str!("../../../tables/inputs/lights.csv");
const MATERIALS: &str = include_str!("../../../tables/inputs/materials.csv");

/// Materials of the shipped set that pictures and reports show, from matte to specular.
pub const SHOWN_MATERIALS: [&str; 7] = [
    "ptfe-633nm",
    "10-plaster-a",
    "07-velvet",
    "13-artificial-grass",
    "05-leather",
    "15-aluminum-foil",
    "34-slate-b",
];

/// Lights of the shipped set that pictures and reports show.
pub const SHOWN_LIGHTS: [&str; 4] = ["esplanade", "park", "blender-courtyard", "studio"];

/// `tables/inputs/lights.csv`.
///
/// # Errors
///
/// The faults of the folder for temporary files.
pub fn lights() -> Result<Lights> {
    from_text(LIGHTS, |path| read_lights(path, None))
}

/// `tables/inputs/materials.csv`.
///
/// # Errors
///
/// The faults of the folder for temporary files.
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
