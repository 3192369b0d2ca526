//! Compares the errors, bytes and counted instructions in a folder with freshly computed ones.
//! Times, and anything that depends on them, are not compared.

use super::growth;
use super::sheet::FIGURES;
use crate::sheet::{self, Form, Record};
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// The allowed relative difference of an error: hosts round differently, and rounding may end a
/// polynomial a term earlier or later.
const ERROR: f64 = 0.02;
/// The difference of an error that is always allowed: errors below it are f32 rounding, which a
/// fused multiplication halves.
const ROUNDING: f64 = 1e-6;
/// The allowed relative difference of bytes: one such term in all profiles of an azimuth.
const BYTES: f64 = 0.02;
/// The allowed difference between a fitted exponent of bytes and the theoretical one. Lower powers
/// still contribute at the largest sizes, (24 / 2 + 1)² of the order. Azimuths grow as the root of
/// the components, so that a row lacks two of ten numbers among the first, five among the last.
const EXPONENT: f64 = 0.3;

/// The allowed relative and absolute difference of a column's numbers. Texts must be equal, and so
/// must numbers without a tolerance.
fn tolerance(column: &str) -> [f64; 2] {
    let ends = |ends: &[&str]| ends.iter().any(|end| column.ends_with(end));
    if ends(&["median", "most", "worst"]) {
        [ERROR, ROUNDING]
    } else if ends(&["_bytes", "counted"]) {
        [BYTES, 0.0]
    } else if column == "terms" {
        [BYTES, 2.0]
    } else {
        [0.0, 0.0]
    }
}

/// Whether a column is not compared: times, and decibels, which repeat the errors.
fn is_time(column: &str) -> bool {
    column.starts_with("host_") || column.starts_with("wasm_") || column.ends_with("_db")
}

/// Compares these records with those of the file in `folder`. Rows of times are not compared. With
/// `whole`, the file must not have other rows; otherwise fields that the records lack are skipped.
/// Returns the numbers of rows and of numbers compared. The error is the first difference, with its
/// file and line.
pub fn compare(form: &Form, fresh: &[Record], folder: &Path, whole: bool) -> Result<[usize; 2]> {
    let again = || FIGURES.again(folder, " --keep-times");
    let sheet = sheet::open(form, folder)?;
    let recorded = sheet::records(&sheet);
    let is_count = |record: &&Record| record.text("unit") != "ns";
    let (rows, mut numbers) = (fresh.iter().filter(is_count).count(), 0);
    for record in fresh.iter().filter(is_count) {
        let (key, name) = (record.key(form), record.key(form).join(", "));
        let found = sheet.rows().zip(&recorded).find(|(_, other)| other.key(form) == key);
        let missing = || sheet.fault(format!("it has no row of `{name}`"), again());
        let (row, other) = found.ok_or_else(missing)?;
        for column in form.columns.split(',').filter(|column| !is_time(column)) {
            let ([new, old], [relative, least]) =
                ([record, other].map(|record| record.text(column)), tolerance(column));
            let is_near = match number(new).zip(number(old)) {
                Some((new, old)) => {
                    numbers += 1;
                    (new - old).abs() <= (relative * new.abs().max(old.abs())).max(least)
                }
                // A quick run lacks the error of the model.
                None => new == old || new.is_empty() && relative > 0.0 && !whole,
            };
            if !is_near {
                let what = format!("`{name}`: {column} is {old} where {new} belongs");
                return Err(row.fault(what, again()));
            }
        }
    }
    let there = recorded.iter().filter(is_count).count();
    if whole && there != rows {
        return Err(sheet.fault(format!("it has {there} rows where {rows} belong"), again()));
    }
    Ok([rows, numbers])
}

/// Compares the fitted exponents of bytes with theory. Returns how many were compared.
pub fn exponents(growth: &[Record]) -> Result<usize> {
    let mut compared = 0;
    for curve in growth::curves(growth).iter().filter(|curve| curve.unit == "bytes") {
        // A quick run has too few orders for the highest power to dominate.
        let fitted = curve.exponent().filter(|_| curve.points.len() >= 4);
        let Some((found, theory)) = fitted.zip(curve.theory) else { continue };
        let is_near = (found - theory).abs() <= EXPONENT;
        if !is_near {
            let what = format!(
                "bytes of {} grow with {} to the power {found:.2}, theory says {theory}",
                curve.measure, curve.quantity
            );
            return Err(Error::new(what, "find out which of the two is wrong"));
        }
        compared += 1;
    }
    Ok(compared)
}

/// The number in a field, if it holds one.
fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
