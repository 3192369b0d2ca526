//! The figures of Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV
//! 2003, on the shipped databases. Each file from `variance` to `bound` makes one figure, as CSV
//! and as a picture; `tables` makes the tables of `docs/paper.md` from the CSV.

pub mod study;

pub mod output_file;

pub(crate) mod chart;

mod plate;

pub mod variance;

pub mod reconstruction;

mod eigenimages;

mod spheres;

pub mod error;

pub mod bound;

pub mod tables;

pub mod compare;

use crate::pages;
use eigenshade_model::error::{Error, Result};
use indicatif::ProgressBar;
use output_file::{Content, OutputFile};
use std::fs;
use std::path::Path;
use study::Study;

/// The file name of the page.
const PAGE: &str = "paper.md";

/// Makes the page in `folder` with its tables replaced, and the figures below it.
///
/// # Errors
///
/// If the page or the markers of its tables are missing, or the folder for temporary files,
/// through which the shipped data are read, fails.
pub fn make(folder: &Path, progress: &ProgressBar) -> Result<Vec<OutputFile>> {
    let path = folder.join(PAGE);
    let page = fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))?;
    let with_parts = |parts: &[pages::Part]| {
        pages::with_parts(&page, parts)
            .map_err(|fault| Error::new(fault, "restore these markers").in_file(&path))
    };
    // Done first, so that missing markers are reported before the long computation.
    with_parts(&tables::empty_parts())?;
    let study = Study::new(progress)?;
    let mut files = [
        variance::Variance::new(&study).files()?,
        eigenimages::files(&study)?,
        spheres::files(&study, progress)?,
        error::files(&study, progress)?,
        reconstruction::files(&study)?,
        bound::files(&study, progress)?,
    ]
    .concat();
    let page = with_parts(&tables::parts(&files))?;
    files.push(OutputFile { name: PAGE.into(), content: Content::Text(page) });
    Ok(files)
}
