//! Files that a command either writes or compares.

use super::purpose::Purpose;
use eigenshade_cli::output::destination;
use eigenshade_model::error::{Error, Result};
use experiments::pages::{self, Part};
use std::fs;

/// Writes `text` to `--out`, or compares it with the file of `--check`: `compare(recorded, text)`
/// returns the first difference. `command` is the command that rewrites the page.
pub fn write_or_compare(
    purpose: &Purpose,
    text: &str,
    command: &str,
    compare: impl Fn(&str, &str) -> std::result::Result<(), String>,
) -> Result<()> {
    if let Some(path) = &purpose.out {
        destination::write_text(Some(path), text)?;
    }
    if let Some(path) = &purpose.check {
        let recorded = fs::read_to_string(path).map_err(|error| Error::io(path, &error))?;
        compare(&recorded, text).map_err(|fault| {
            Error::new(fault, format!("make it again with `{command}`")).in_file(path)
        })?;
    }
    Ok(())
}

/// Inserts generated parts into the page of `--out`, or compares the page of `--check` with the
/// same page after its parts are regenerated.
pub fn insert_or_compare(
    purpose: &Purpose,
    parts: &[Part],
    command: &str,
    compare: impl Fn(&str, &str) -> std::result::Result<(), String>,
) -> Result<()> {
    let Some(path) = purpose.out.as_ref().or(purpose.check.as_ref()) else { return Ok(()) };
    let page = fs::read_to_string(path).map_err(|error| Error::io(path, &error))?;
    let text = pages::with_parts(&page, parts)
        .map_err(|fault| Error::new(fault, "restore them").in_file(path))?;
    write_or_compare(purpose, &text, command, compare)
}
