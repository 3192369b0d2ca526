//! The cost of accuracy: the error and the price of varying every parameter.

pub mod setting;

pub mod knobs;

pub mod materials;

pub mod bases;

pub mod images;

pub mod shading;

pub mod method;

pub mod sizes;

pub mod times;

pub mod kept;

pub mod model;

pub mod machine;

pub mod ladder;

pub mod boards;

pub mod wasm;

pub mod points;

pub mod front;

pub mod choice;

pub mod exponent;

pub mod growth;

mod chart;

pub mod words;

pub mod figures;

pub mod page;

pub mod sheet;

pub mod check;

use eigenshade_model::error::Result;
use growth::Growth;
use indicatif::ProgressBar;
use kept::Kept;
use model::Row;
use points::Point;
use std::path::Path;

/// The command that makes the files; the first line of each file names it.
pub const COMMAND: &str = "experiments accuracy-cost";

/// What is measured, and to what extent.
#[derive(Clone, Copy)]
pub struct Extent<'a> {
    /// Whether to measure only a part of the settings, surfaces and sizes.
    pub quick: bool,
    /// Where times come from.
    pub times: Times<'a>,
}

/// The source of times.
#[derive(Clone, Copy)]
pub enum Times<'a> {
    /// No times.
    None,
    /// Times are measured.
    Measured,
    /// Times of an earlier run.
    Kept(&'a Kept),
}

/// All measurements.
pub struct Measured {
    /// The errors of the model.
    pub models: Vec<Row>,
    /// The settings.
    pub points: Vec<Point>,
    /// The growth curves.
    pub growths: Vec<Growth>,
}

impl Measured {
    /// Runs the measurements with the environment maps in `maps`.
    ///
    /// # Errors
    ///
    /// If a map is missing or cannot be read.
    pub fn new(extent: Extent<'_>, maps: &Path, progress: &ProgressBar) -> Result<Self> {
        let Extent { quick, times } = extent;
        let models = model::rows(maps, quick, progress)?;
        let points = points::measure(extent, &models, progress)?;
        let growths = growth::all(quick, times)?;
        Ok(Self { models, points, growths })
    }

    /// The CSV files by name.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn sheets(&self) -> Result<[(&'static str, String); 3]> {
        Ok([
            (sheet::POINTS, sheet::points(&self.points)?),
            (sheet::MODEL, sheet::model(&self.models)?),
            (sheet::GROWTH, sheet::growth(&self.growths)?),
        ])
    }

    /// All files by name: CSV, charts and the page.
    ///
    /// # Errors
    ///
    /// Never in practice.
    pub fn files(&self) -> Result<Vec<(String, String)>> {
        let sheets = self.sheets()?.into_iter().map(|(name, text)| (name.to_owned(), text));
        let mut files: Vec<(String, String)> = sheets.collect();
        files.extend(figures::all(&self.points, &self.models, &self.growths)?);
        let page = page::page(&self.points, &self.models, &self.growths);
        files.push((page::PAGE.to_owned(), page));
        Ok(files)
    }
}
