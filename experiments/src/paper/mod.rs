//! The figures of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV
//! 2003, on the shipped databases. Each file from `variance` to `bound` makes one figure, as CSV
//! and as a picture; `tables` makes the tables of `docs/paper.md` from the CSV.

pub mod study;

mod plate;

pub mod variance;

pub mod reconstruction;

mod eigenimages;

mod spheres;

pub mod error;

pub mod bound;

pub mod tables;

use crate::figures::{Figures, OutputFile};
use crate::{numbers, pages};
use eigenshade_model::error::Result;
use std::fmt::Display;
use std::path::Path;
use study::Study;

/// The file name of the page.
const PAGE: &str = "paper.md";
/// The files of the command.
pub const FIGURES: Figures = Figures { command: "paper", folder: "paper/", is_exact: false };
/// Significant digits of the figures' numbers.
const DIGITS: usize = 6;

/// Makes the page in `folder` with its tables replaced, and the figures below it.
pub fn make(folder: &Path) -> Result<Vec<OutputFile>> {
    let path = folder.join(PAGE);
    // Done first, so that missing markers are reported before the long computation.
    pages::filled(&path, &tables::empty_parts())?;
    let study = Study::new()?;
    let mut files = [
        variance::Variance::new(&study).files()?,
        eigenimages::files(&study)?,
        spheres::files(&study)?,
        error::files(&study)?,
        reconstruction::files(&study)?,
        bound::files(&study)?,
    ]
    .concat();
    let page = pages::filled(&path, &tables::parts(&files)?)?;
    files.push(OutputFile::text(PAGE, page));
    Ok(files)
}

/// A row of a CSV: texts, then numbers with six significant digits.
fn row(texts: &[&dyn Display], numbers: impl IntoIterator<Item = f64>) -> Vec<String> {
    let texts = texts.iter().map(ToString::to_string);
    texts.chain(numbers.into_iter().map(digits)).collect()
}

/// A number with six significant digits.
fn digits(value: f64) -> String {
    numbers::digits(value, DIGITS)
}
