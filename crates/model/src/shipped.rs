//! The shipped databases and table, compiled in, so that results do not depend on files in the
//! working directory.

use crate::database::{Lights, Materials};
use crate::error::{Error, Result};
use crate::inputs::coefficient_csv::{read_lights, read_materials};
use crate::inputs::gloss_csv::read_glosses;
use crate::inputs::input_file::InputFile;
use crate::inputs::sheet::Sheet;
use crate::inputs::source_csv::read_sources;
use crate::inputs::source_error_csv::read_source_errors;
use crate::screen::ScreenError;
use crate::source::{NamedGloss, NamedSources, SourceError};
use eigenshade_table::{decode, material};
use std::ffi::OsStr;
use std::path::Path;

/// The contents of `tables/sphere.bin`.
pub const TABLE: &[u8] = include_bytes!("../tables/sphere.bin");
/// The contents of `tables/color.bin`: 160 components of materials in color, for pictures on a
/// host.
pub const COLOR: &[u8] = include_bytes!("../tables/color.bin");
/// The contents of `tables/curet.bin`: 50 components of the measured materials of the paper.
pub const CURET: &[u8] = include_bytes!("../tables/curet.bin");
/// The contents of `tables/pbr.bin`: 250 components of formulas, of degree and order 12.
pub const PBR: &[u8] = include_bytes!("../tables/pbr.bin");
const LIGHTS: &str = include_str!("../tables/inputs/lights.csv");
const MATERIALS: &str = include_str!("../tables/inputs/materials.csv");
const FORMULAS: &str = include_str!("../tables/inputs/pbr-materials.csv");
const COLORED: &str = include_str!("../tables/inputs/merl.csv");
const COLORED_12: &str = include_str!("../tables/inputs/merl-12.csv");

const SOURCES: &str = include_str!("../tables/inputs/sources.csv");
const SOURCE_ERRORS: &str = include_str!("../tables/inputs/sources.errors.csv");
const GLOSS: &str = include_str!("../tables/inputs/gloss.csv");
const ROUGHNESS_WEIGHTS: &str = include_str!("../tables/inputs/roughness-weights.csv");
const ERRORS: &str = include_str!("../tables/inputs/merl.errors.csv");

/// Shipped materials that pictures and reports show, from matte to specular.
pub const SHOWN_MATERIALS: [&str; 7] = [
    "ptfe-633nm",
    "pink-felt",
    "red-fabric2",
    "blue-fabric",
    "green-latex",
    "yellow-plastic",
    "gold-metallic-paint2",
];

/// Shipped lights that pictures and reports show.
pub const SHOWN_LIGHTS: [&str; 4] = ["esplanade", "park", "blender-courtyard", "studio"];

/// The lights in `tables/inputs/lights.csv`.
///
/// # Errors
///
/// As [`read_lights`], for the compiled-in file.
pub fn lights() -> Result<Lights> {
    read_lights(InputFile::of_text(LIGHTS, "tables/inputs/lights.csv"), None)
}

/// The small sources of the captured lights, `tables/inputs/sources.csv`.
///
/// # Errors
///
/// As [`read_sources`], for the compiled-in file.
pub fn sources() -> Result<Vec<NamedSources>> {
    read_sources(InputFile::of_text(SOURCES, "tables/inputs/sources.csv"))
}

/// The errors of pictures under the captured lights without sources and with the first ones,
/// `tables/inputs/sources.errors.csv`.
///
/// # Errors
///
/// As [`read_source_errors`], for the compiled-in file.
pub fn source_errors() -> Result<Vec<SourceError>> {
    read_source_errors(InputFile::of_text(SOURCE_ERRORS, "tables/inputs/sources.errors.csv"))
}

/// The gloss of the materials in color, `tables/inputs/gloss.csv`.
///
/// # Errors
///
/// As [`read_glosses`], for the compiled-in file.
pub fn glosses() -> Result<Vec<NamedGloss>> {
    read_glosses(InputFile::of_text(GLOSS, "tables/inputs/gloss.csv"))
}

/// The weights of the images of five roughnesses, for equally spaced roughnesses from 0.2 to 1,
/// `tables/inputs/roughness-weights.csv`.
///
/// # Errors
///
/// As [`Sheet::read`], for the compiled-in file.
pub fn roughness_weights() -> Result<Vec<[f64; 5]>> {
    let file = InputFile::of_text(ROUGHNESS_WEIGHTS, "tables/inputs/roughness-weights.csv");
    let names = ["w1", "w2", "w3", "w4", "w5"];
    let sheet = Sheet::read(file, "roughness,w1,w2,w3,w4,w5")?;
    let columns = sheet.columns(names).ok_or_else(|| sheet.wrong_header("`w1` to `w5`"))?;
    sheet.rows().map(|row| row.numbers(columns)).collect()
}

/// The materials in `tables/inputs/materials.csv`.
///
/// # Errors
///
/// As [`read_materials`], for the compiled-in file.
pub fn materials() -> Result<Materials> {
    materials_in(Path::new("tables/inputs/materials.csv"))
}

/// All materials that have names, for a table of this order: the materials in color of
/// `tables/inputs/merl.csv`, or from order 12 on of `merl-12.csv`, then the gray ones of
/// [`materials`], whose higher coefficients are 0.
///
/// # Errors
///
/// As [`read_materials`], for the compiled-in files.
pub fn named_materials(order: usize) -> Result<Materials> {
    let file = if order < 12 { "tables/inputs/merl.csv" } else { "tables/inputs/merl-12.csv" };
    let mut named = materials_in(Path::new(file))?;
    let count = material::count(named.order);
    named.entries.extend(materials()?.entries.into_iter().map(|mut gray| {
        gray.rgb.iter_mut().for_each(|channel| channel.resize(count, 0.0));
        gray
    }));
    Ok(named)
}

/// The materials of the shipped database with the name of this file.
///
/// # Errors
///
/// If no shipped database has that name; and as [`read_materials`], for the compiled-in file.
pub fn materials_in(file: &Path) -> Result<Materials> {
    let text = match file.file_name().and_then(OsStr::to_str) {
        Some("materials.csv") => MATERIALS,
        Some("merl.csv") => COLORED,
        Some("merl-12.csv") => COLORED_12,
        Some("pbr-materials.csv") => FORMULAS,
        _ => {
            let what = "no shipped database has that name";
            return Err(Error::new(what, "give the file itself").in_file(file));
        }
    };
    read_materials(InputFile::of_text(text, file), None)
}

/// The materials in color of which no shipped table is made: `tables/color.toml` does not name
/// them.
///
/// # Errors
///
/// As [`read_materials`] and [`decode`], for the compiled-in files.
pub fn unseen_materials() -> Result<Materials> {
    let mut color = materials_in(Path::new("tables/inputs/merl.csv"))?;
    let table = decode(COLOR)
        .map_err(|error| Error::new(error.to_string(), "report it").in_file("tables/color.bin"))?;
    color.entries.retain(|entry| !table.scene.material.names.contains(&entry.name));
    Ok(color)
}

/// The total screen error of a material: its pictures against direct integration of its BRDF under
/// the shipped maps, with the windows that `eigenshade render` chooses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TotalError {
    /// The median over the maps, measure by measure.
    pub median: ScreenError,
    /// What 95 of 100 maps do not exceed.
    pub most: ScreenError,
}

/// The degrees and orders of [`total_error`]: the shipped table's, and the largest that one would
/// use on a device.
pub const ERROR_SIZES: [(usize, usize); 2] = [(9, 7), (12, 12)];

/// The screen error of a shipped material at a degree and an order with at most 0 or 8 sources,
/// from `tables/inputs/merl.errors.csv`, which has no shares of white. `None` if the file has no
/// such row.
#[must_use]
pub fn total_error(material: &str, size: (usize, usize), sources: usize) -> Option<TotalError> {
    ERRORS.lines().find_map(|line| {
        let fields: Vec<&str> = line.split(',').collect();
        let [name, degree, order, most, numbers @ .., _] = &fields[..] else { return None };
        let key = [degree, order, most].map(|text| text.parse().ok());
        if *name != material || key != [size.0, size.1, sources].map(Some) {
            return None;
        }
        let numbers = numbers.iter().map(|text| text.parse().ok()).collect::<Option<Vec<f64>>>()?;
        let [mean, mean_most, p95, p95_most] = numbers[..] else { return None };
        let error = |mean, p95| ScreenError { mean, p95, white: f64::NAN };
        Some(TotalError { median: error(mean, p95), most: error(mean_most, p95_most) })
    })
}
