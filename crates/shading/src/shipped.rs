//! The shipped databases and table, compiled in, so that results do not depend on files in the
//! working directory.

use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::coefficient_csv::{parse_lights, parse_materials};

/// The contents of `tables/sphere.bin`.
pub const TABLE: &[u8] = include_bytes!("../../../tables/sphere.bin");
const LIGHTS: &str = include_str!("../../../tables/inputs/lights.csv");
const MATERIALS: &str = include_str!("../../../tables/inputs/materials.csv");
const COLORED: &str = include_str!("../../../tables/inputs/merl.csv");

/// Shipped materials that pictures and reports show, from matte to specular.
pub const SHOWN_MATERIALS: [&str; 7] = [
    "ptfe-633nm",
    "10-plaster-a",
    "07-velvet",
    "13-artificial-grass",
    "05-leather",
    "15-aluminum-foil",
    "34-slate-b",
];

/// Shipped lights that pictures and reports show.
pub const SHOWN_LIGHTS: [&str; 4] = ["esplanade", "park", "blender-courtyard", "studio"];

/// The lights in `tables/inputs/lights.csv`.
///
/// # Errors
///
/// As [`parse_lights`], for the compiled-in file.
pub fn lights() -> Result<Lights> {
    parse_lights(LIGHTS, "tables/inputs/lights.csv", None)
}

/// The materials in `tables/inputs/materials.csv`.
///
/// # Errors
///
/// As [`parse_materials`], for the compiled-in file.
pub fn materials() -> Result<Materials> {
    parse_materials(MATERIALS, "tables/inputs/materials.csv", None)
}

/// All materials that have names: those in color of `tables/inputs/merl.csv`, then the gray ones of
/// [`materials`].
///
/// # Errors
///
/// As [`parse_materials`], for the compiled-in files.
pub fn named_materials() -> Result<Materials> {
    let mut named = parse_materials(COLORED, "tables/inputs/merl.csv", None)?;
    named.entries.extend(materials()?.truncated(named.order).entries);
    Ok(named)
}
