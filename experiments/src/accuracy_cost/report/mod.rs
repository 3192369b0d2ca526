//! The charts, and the tables of the page.

mod charts;
mod tables;

use super::Measured;
use super::machines::MACHINES;
use super::sheet::csv;
use crate::figures::OutputFile;
use crate::numbers;
use crate::pages::{Part, with_parts};
use eigenshade_cli::messages::grouped;
use eigenshade_model::error::{Error, Result};
use std::fs;
use std::path::Path;

pub const PAGE: &str = "accuracy-cost.md";
/// The page into which tables are inserted where a folder has none.
const TEMPLATE: &str = include_str!("../../../../docs/accuracy-cost/accuracy-cost.md");
/// A number that was not measured.
const MISSING: &str = "-";

/// The files of a folder: CSV, charts, and the page with its tables replaced.
pub fn files(measured: &Measured, folder: &Path) -> Result<Vec<OutputFile>> {
    let path = folder.join(PAGE);
    let page = if path.exists() {
        fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))?
    } else {
        TEMPLATE.to_owned()
    };
    let page = with_parts(&page, &tables(measured))
        .map_err(|fault| Error::new(fault, "restore these markers").in_file(&path))?;
    let sheets = measured.sheets().into_iter().map(|(form, rows)| csv(form, rows));
    let mut files = sheets.collect::<Result<Vec<OutputFile>>>()?;
    files.extend(charts::all(measured)?);
    files.push(OutputFile::text(PAGE, page));
    Ok(files)
}

fn tables(measured: &Measured) -> Vec<Part> {
    let mut parts: Vec<Part> = MACHINES
        .iter()
        .map(|machine| (machine.key, tables::of_machine(&measured.settings, machine)))
        .collect();
    parts.push(choice(measured));
    parts.push(("total", tables::total(measured)));
    parts.push(("rivals", tables::rivals(measured)));
    parts.push(("components", tables::components(measured)));
    parts.push(("model", tables::model(&measured.model)));
    parts.push(("mathematics", tables::mathematics(&measured.settings)));
    parts.push(("effects", tables::effects(&measured.settings)));
    parts
}

/// The table by which a setting is chosen, which other pages show too.
pub fn choice(measured: &Measured) -> Part {
    ("choice", tables::choice(&measured.settings))
}

/// An error in percent with two digits, or as a power of ten below 0.01 %.
fn percent(error: f64) -> String {
    match error {
        _ if !error.is_finite() => MISSING.into(),
        ..1e-4 => format!("{error:.1e}"),
        _ => numbers::percent(error, 2),
    }
}

/// A cost with three digits, or four if it is large.
fn cost(value: f64) -> String {
    match value {
        1000.0.. => {
            let unit = 10f64.powi(value.log10() as i32 - 3);
            grouped((unit * (value / unit).round()) as usize)
        }
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// Counted instructions: all digits of small counts.
fn instructions(value: f64) -> String {
    if value < 1000.0 { grouped(value as usize) } else { cost(value) }
}

fn difference(value: f64) -> String {
    format!("{value:.1}")
}
