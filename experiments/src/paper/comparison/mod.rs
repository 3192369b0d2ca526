//! Compares a folder of figures with those that the program makes now: the page, CSV, charts and
//! pictures. Neither side may have additional files.

mod charts;
mod pictures;
mod texts;

pub use charts::compare_charts;
pub use pictures::compare_pictures;
pub use texts::compare_texts;

use super::FOLDER;
use super::artefact::{Artefact, Content};
use eigenshade_generator::picture::png_samples;
use eigenshade_model::error::{Error, Result};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The amount of data compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Compared {
    /// Number of files.
    pub files: usize,
    /// Numbers in the page and the CSV files.
    pub numbers: usize,
    /// Coordinates and colors in the charts.
    pub marks: usize,
    /// Pixels in the pictures.
    pub pixels: usize,
}

/// Compares every file with the one in `folder`.
///
/// # Errors
///
/// The first file that is missing, differs, or does not belong; for a text, with its line.
pub fn compare(artefacts: &[Artefact], folder: &Path) -> Result<Compared> {
    let again = || {
        format!(
            "make it again with `cargo run --release -p experiments -- paper --out {}`",
            folder.display()
        )
    };
    let mut compared = Compared::default();
    for artefact in artefacts {
        let path = folder.join(&artefact.name);
        let fault = |error: std::io::Error| match error.kind() {
            ErrorKind::NotFound => Error::new("this figure is missing", again()).in_file(&path),
            _ => Error::io(&path, &error),
        };
        fs::metadata(&path).map_err(fault)?;
        match &artefact.content {
            Content::Text(text) => {
                let found = fs::read_to_string(&path).map_err(fault)?;
                let at_line = |(line, what)| Error::new(what, again()).at_line(&path, line);
                if artefact.name.ends_with(".svg") {
                    compared.marks += compare_charts(&found, text).map_err(at_line)?;
                } else {
                    compared.numbers += compare_texts(&found, text).map_err(at_line)?;
                }
            }
            Content::Picture(canvas) => {
                let found = png_samples::read(&path).map_err(|error| error.with_remedy(again()))?;
                compared.pixels += compare_pictures(&found, canvas)
                    .map_err(|what| Error::new(what, again()).in_file(&path))?;
            }
        }
        compared.files += 1;
    }
    no_others(artefacts, folder)?;
    Ok(compared)
}

/// An extra file among the figures would be mistaken for a figure.
fn no_others(artefacts: &[Artefact], folder: &Path) -> Result<()> {
    let figures = folder.join(FOLDER);
    let fault = |error: std::io::Error| Error::io(&figures, &error);
    let mut names = Vec::new();
    for entry in fs::read_dir(&figures).map_err(fault)? {
        names.push(entry.map_err(fault)?.file_name());
    }
    names.sort();
    let belongs = |name: &std::ffi::OsString| {
        let name = name.to_str().map(|name| format!("{FOLDER}/{name}"));
        artefacts.iter().any(|artefact| Some(&artefact.name) == name.as_ref())
    };
    match names.iter().find(|name| !belongs(name)) {
        None => Ok(()),
        Some(name) => {
            let remedy = "remove it, or keep it elsewhere";
            Err(Error::new("the program makes no such figure", remedy).in_file(figures.join(name)))
        }
    }
}
