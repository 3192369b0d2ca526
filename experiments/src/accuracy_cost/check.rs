//! Compares the errors, bytes and counted instructions in a folder with freshly computed ones.
//! Times, and anything that depends on them, are not compared.

use super::growth;
use super::sheet::{self, Form, Record};
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// The allowed relative difference of an error: hosts round differently, and rounding may end a
/// polynomial a term earlier or later.
pub const ERROR: f64 = 0.02;
/// The difference of an error that is always allowed: errors below it are f32 rounding, which a
/// fused multiplication halves.
pub const ROUNDING: f64 = 1e-6;
/// The allowed relative difference of bytes: one such term in all profiles of an azimuth.
pub const BYTES: f64 = 0.02;
/// The allowed difference between a fitted exponent of bytes and the theoretical one. Lower powers
/// still contribute at the largest sizes, (24 / 2 + 1)² of the order. Azimuths grow as the root of
/// the components, so that a row lacks two of ten numbers among the first, five among the last.
pub const EXPONENT: f64 = 0.3;

/// How a column is compared.
enum Kind {
    /// As text.
    Text,
    /// As a number, within a relative and an absolute tolerance.
    Number(f64, f64),
    /// Not at all: times, and decibels, which repeat the errors.
    Time,
}

fn kind(column: &str) -> Kind {
    let ends = |ends: &[&str]| ends.iter().any(|end| column.ends_with(end));
    if column.starts_with("host_") || column.starts_with("wasm_") || ends(&["_db"]) {
        Kind::Time
    } else if ends(&["median", "most", "worst"]) {
        Kind::Number(ERROR, ROUNDING)
    } else if ends(&["_bytes", "counted"]) {
        Kind::Number(BYTES, 0.0)
    } else if ends(&["_pixel", "_light", "_flash", "_ram"]) {
        Kind::Number(0.0, 0.0)
    } else if column == "terms" {
        Kind::Number(BYTES, 2.0)
    } else {
        Kind::Text
    }
}

/// The amount of data compared.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Compared {
    /// The number of rows.
    pub rows: usize,
    /// The number of numbers.
    pub numbers: usize,
}

/// Compares these records with those of the file in `folder`. Rows of times are not compared. With
/// `whole`, the file must not have other rows; otherwise fields that the records lack are skipped.
///
/// # Errors
///
/// The first difference, with its file and line.
pub fn compare(
    form: &Form,
    fresh: &[Record],
    folder: &Path,
    whole: bool,
    compared: &mut Compared,
) -> Result<()> {
    let again = || {
        let folder = folder.display();
        format!(
            "make it again with `cargo run --release -p experiments -- accuracy-cost --out {folder}`"
        )
    };
    let sheet = sheet::open(form, folder)?;
    let recorded = sheet::read(form, folder)?;
    let is_count = |record: &&Record| record.text("unit") != "ns";
    let rows = fresh.iter().filter(is_count).count();
    for record in fresh.iter().filter(is_count) {
        let (key, name) = (record.key(form), record.key(form).join(", "));
        let place = recorded.iter().position(|other| other.key(form) == key);
        let missing = || sheet.fault(format!("it has no row of `{name}`"), again());
        let place = place.ok_or_else(missing)?;
        for column in form.columns.split(',') {
            let [new, old] = [record, &recorded[place]].map(|record| record.text(column));
            let is_near = match kind(column) {
                Kind::Time => true,
                Kind::Number(..) if new.is_empty() && !whole => true,
                Kind::Number(relative, least) => match (number(new), number(old)) {
                    (Some(new), Some(old)) => {
                        compared.numbers += 1;
                        (new - old).abs() <= (relative * new.abs().max(old.abs())).max(least)
                    }
                    _ => new == old,
                },
                Kind::Text => new == old,
            };
            if !is_near {
                let what = format!("`{name}`: {column} is {old} where {new} belongs");
                let fault =
                    |row: eigenshade_model::inputs::sheet::Row<'_>| row.fault(&what, again());
                return Err(sheet.rows().nth(place).map_or_else(missing, fault));
            }
        }
    }
    compared.rows += rows;
    let there = recorded.iter().filter(is_count).count();
    if whole && there != rows {
        return Err(sheet.fault(format!("it has {there} rows where {rows} belong"), again()));
    }
    Ok(())
}

/// Compares the fitted exponents of bytes with theory.
///
/// # Errors
///
/// The first exponent that differs.
pub fn exponents(growth: &[Record]) -> Result<()> {
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
    }
    Ok(())
}

/// The number in a field, if it holds one.
fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
