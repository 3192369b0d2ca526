//! What accuracy costs: every knob turned, its error and its price.

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

/// What makes the files; each says so in its first line.
pub const COMMAND: &str = "experiments accuracy-cost";

/// What is measured, and how much of it.
#[derive(Clone, Copy)]
pub struct Extent<'a> {
    /// A part of the settings, surfaces and sizes.
    pub quick: bool,
    /// Whether times are measured, too.
    pub times: Times<'a>,
}

/// Where times come from.
#[derive(Clone, Copy)]
pub enum Times<'a> {
    /// There are none.
    None,
    /// They are measured.
    Measured,
    /// They are those of an earlier run.
    Kept(&'a Kept),
}

/// All that was measured.
pub struct Measured {
    /// The model's errors.
    pub models: Vec<Row>,
    /// The settings.
    pub points: Vec<Point>,
    /// What grows.
    pub growths: Vec<Growth>,
}

impl Measured {
    /// Measures; the environment maps are in `maps`.
    ///
    /// # Errors
    ///
    /// A map that is missing or cannot be read.
    pub fn new(extent: Extent<'_>, maps: &Path, progress: &ProgressBar) -> Result<Self> {
        let Extent { quick, times } = extent;
        let models = model::rows(maps, quick, progress)?;
        let points = points::measure(extent, &models, progress)?;
        let growths = growth::all(quick, times)?;
        Ok(Self { models, points, growths })
    }

    /// The files of numbers, by name.
    ///
    /// # Errors
    ///
    /// None in truth.
    pub fn sheets(&self) -> Result<[(&'static str, String); 3]> {
        Ok([
            (sheet::POINTS, sheet::points(&self.points)?),
            (sheet::MODEL, sheet::model(&self.models)?),
            (sheet::GROWTH, sheet::growth(&self.growths)?),
        ])
    }

    /// All files, by name: numbers, charts and the page.
    ///
    /// # Errors
    ///
    /// None in truth.
    pub fn files(&self) -> Result<Vec<(String, String)>> {
        let sheets = self.sheets()?.into_iter().map(|(name, text)| (name.to_owned(), text));
        let mut files: Vec<(String, String)> = sheets.collect();
        files.extend(figures::all(&self.points, &self.models, &self.growths)?);
        let page = page::page(&self.points, &self.models, &self.growths);
        files.push((page::PAGE.to_owned(), page));
        Ok(files)
    }
}
