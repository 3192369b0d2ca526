//! Reads materials of any kind from a path: measurements, tables or formulas.

use crate::light::map_file::extension;
use crate::material::brdf::Surface;
use crate::material::measurements;
use crate::material::measurements::Measured;
use crate::material::{analytic, merl, published_fits};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::Sheet;
use std::path::{Path, PathBuf};

/// A material before it has coefficients.
pub enum Source {
    /// Samples, which are fitted.
    Measured(Measured),
    /// BRDF functions, which are projected.
    Surface(Surface),
}

impl Source {
    /// Name of the material.
    #[must_use]
    pub fn name(&self) -> &str {
        match self {
            Self::Measured(measured) => &measured.name,
            Self::Surface(surface) => &surface.name,
        }
    }
}

/// Reads materials by file type. A `.binary` file is a MERL table ([`merl::read`]), a `.toml` file
/// holds formulas ([`analytic::read`]), any other file is a CSV of [`published_fits`] or of
/// measurements ([`measurements::read`]). A folder with an `abrdf.dat` is a CUReT folder
/// ([`measurements::read_curet`]); from any other folder all `.binary`, `.toml` and `.csv` files
/// are read, sorted by name.
///
/// # Errors
///
/// The errors of these readers, and a folder with nothing to read.
pub fn read(file: impl Into<InputFile>) -> Result<Vec<Source>> {
    let file = file.into();
    let path = file.path();
    if !path.is_dir() {
        return read_file(file);
    }
    if path.join("abrdf.dat").is_file() {
        return Ok(measurements::read_curet(file)?.into_iter().map(Source::Measured).collect());
    }
    let files = files_in(path)?;
    if files.is_empty() {
        return Err(Error::new(
            "no materials in this folder",
            "give a folder with an abrdf.dat (CUReT) or with .csv, .binary or .toml files",
        )
        .in_file(path));
    }
    let read: Vec<Vec<Source>> =
        files.iter().map(|one| read_file(file.other(one))).collect::<Result<_>>()?;
    Ok(read.into_iter().flatten().collect())
}

/// The files that [`read`](fn@read) would read, whether or not they exist; none for a folder that
/// cannot be listed.
#[must_use]
pub fn files(path: &Path) -> Vec<PathBuf> {
    if !path.is_dir() {
        return vec![path.to_owned()];
    }
    if path.join("abrdf.dat").is_file() {
        return measurements::CURET_FILES.map(|file| path.join(file)).to_vec();
    }
    files_in(path).unwrap_or_default()
}

/// The files of a folder with a material extension, sorted by name.
fn files_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut files: Vec<PathBuf> = std::fs::read_dir(folder)
        .and_then(|entries| entries.map(|entry| Ok(entry?.path())).collect())
        .map_err(|error| Error::io(folder, &error))?;
    files.retain(|file| matches!(extension(file).as_deref(), Some("binary" | "toml" | "csv")));
    files.sort();
    Ok(files)
}

fn read_file(file: InputFile) -> Result<Vec<Source>> {
    Ok(match extension(file.path()).as_deref() {
        Some("binary") => vec![Source::Surface(merl::read(file)?)],
        Some("toml") => analytic::read(file)?.into_iter().map(Source::Surface).collect(),
        _ => {
            let sheet = Sheet::read(file.clone(), measurements::COLUMNS)?;
            match published_fits::of_sheet(&sheet)? {
                Some(surfaces) => surfaces.into_iter().map(Source::Surface).collect(),
                None => vec![Source::Measured(measurements::of_sheet(&sheet, file.path())?)],
            }
        }
    })
}
