//! Compares the errors, bytes and counted instructions in a folder with freshly computed ones.
//! Times, and anything that depends on them, are not compared.

use super::growth::Growth;
use super::sheet::{GROWTH, MODEL, POINTS};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::sheet::{Row, Sheet};
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
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// As text.
    Word,
    /// As a number, within a relative and an absolute tolerance.
    Number(f64, f64),
    /// Not at all: times, and values that repeat another column.
    Time,
}

fn kind(column: &str) -> Kind {
    let ends = |ends: &[&str]| ends.iter().any(|end| column.ends_with(end));
    if column.starts_with("host_") || column.starts_with("wasm_") {
        Kind::Time
    } else if ends(&["_db"]) {
        // These repeat the errors.
        Kind::Time
    } else if ends(&["_median", "_most", "_worst"]) || matches!(column, "median" | "worst") {
        Kind::Number(ERROR, ROUNDING)
    } else if ends(&["_bytes"]) || column == "counted" {
        Kind::Number(BYTES, 0.0)
    } else if ends(&["_pixel", "_light", "_flash", "_ram"]) {
        Kind::Number(0.0, 0.0)
    } else if column == "terms" {
        Kind::Number(BYTES, 2.0)
    } else {
        Kind::Word
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

/// Compares the rows of these texts with those of the files of the same names in `folder`. Empty
/// fields of a fresh row are not compared. With `whole`, the files must not have other rows.
///
/// # Errors
///
/// The first difference, with its file and line, or an exponent that differs from theory.
pub fn compare(
    fresh: &[(&str, String)],
    growths: &[Growth],
    folder: &Path,
    whole: bool,
) -> Result<Compared> {
    let mut compared = Compared::default();
    for (name, text) in fresh {
        of_file(&folder.join(name), text, keys(name), whole, &mut compared)?;
    }
    for growth in growths.iter().filter(|growth| growth.unit == "bytes") {
        let Some(found) = growth.exponent() else { continue };
        if !whole && growth.points.len() < 4 {
            continue;
        }
        let Some(theory) = growth.theory else { continue };
        let is_near = (found - theory).abs() <= EXPONENT;
        if !is_near {
            let (measure, quantity) = (growth.measure, growth.quantity);
            let what = format!(
                "bytes of {measure} grow with {quantity} to the power {found:.2}, theory says {theory}"
            );
            return Err(Error::new(what, "find out which of the two is wrong"));
        }
    }
    Ok(compared)
}

/// The number of columns that identify a row.
fn keys(name: &str) -> &'static [&'static str] {
    match name {
        POINTS => &["setting"],
        MODEL => &["surface", "degree", "order"],
        GROWTH => &["quantity", "measure", "unit", "size"],
        _ => &[],
    }
}

fn of_file(
    path: &Path,
    text: &str,
    keys: &[&str],
    whole: bool,
    compared: &mut Compared,
) -> Result<()> {
    let again = || {
        let folder = path.parent().unwrap_or(Path::new(".")).display();
        format!(
            "make it again with `cargo run --release -p experiments -- accuracy-cost --out {folder}`"
        )
    };
    let fresh = Sheet::parse(text.as_bytes().to_vec(), path, "")?;
    let columns: Vec<&str> = fresh.header().collect();
    let found = Sheet::read(path, &columns.join(","))?;
    let places: Option<Vec<usize>> = columns.iter().map(|name| found.column(name)).collect();
    let places = places.ok_or_else(|| found.wrong_header(&columns.join(",")))?;
    let of_keys = |sheet: &Sheet, row: Row<'_>| -> Vec<String> {
        let columns = keys.iter().filter_map(|key| sheet.column(key));
        columns.map(|column| row.text(column).to_owned()).collect()
    };
    let mut rows = 0;
    for row in fresh.rows() {
        let name = of_keys(&fresh, row);
        let Some(other) = found.rows().find(|other| of_keys(&found, *other) == name) else {
            let what = format!("it has no row of `{}`", name.join(", "));
            return Err(Error::new(what, again()).in_file(path));
        };
        rows += 1;
        let pairs = columns.iter().zip(&places).enumerate();
        for (column, (title, &place)) in pairs {
            let (new, old) = (row.text(column), other.text(place));
            let fault = || {
                let name = name.join(", ");
                let what = format!("`{name}`: {title} is {old} where {new} belongs");
                other.fault(what, again())
            };
            match kind(title) {
                Kind::Time => {}
                // This run did not compute the value.
                Kind::Number(..) if new.is_empty() && !whole => {}
                Kind::Number(relative, least) => match (number(new), number(old)) {
                    (Some(new), Some(old)) => {
                        let allowed = (relative * new.abs().max(old.abs())).max(least);
                        let is_near = (new - old).abs() <= allowed;
                        if !is_near {
                            return Err(fault());
                        }
                        compared.numbers += 1;
                    }
                    _ if new == old => {}
                    _ => return Err(fault()),
                },
                Kind::Word if new == old => {}
                Kind::Word => return Err(fault()),
            }
        }
    }
    compared.rows += rows;
    // A row that holds only a time is not recomputed.
    let unit = found.column("unit");
    let is_time = |row: &Row<'_>| unit.is_some_and(|unit| row.text(unit) == "ns");
    let there = found.rows().filter(|row| !is_time(row)).count();
    if whole && there != rows {
        let what = format!("it has {there} rows where {rows} belong");
        return Err(Error::new(what, again()).in_file(path));
    }
    Ok(())
}

/// The number in a field, if it holds one.
fn number(text: &str) -> Option<f64> {
    text.parse().ok().filter(|value: &f64| value.is_finite())
}
