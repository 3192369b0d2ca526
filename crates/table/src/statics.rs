//! A table as Rust source: statics in floats, and a module with the table in integers.

use crate::format_error::FormatError;
use crate::parts;
use crate::quantize;
use crate::record::Q15;
use crate::record::integers::OwnedParts;
use crate::source;
use crate::table::Table;

/// The text of a module, and why it lacks integers.
#[derive(Clone, Debug, PartialEq)]
pub struct Statics {
    /// The text of [`floats`], then a `mod q15` if the table can be converted to integers.
    pub text: String,
    /// Why the table cannot be converted to integers.
    pub without_integers: Option<FormatError>,
}

/// The statics of a table in `f32`, and in integers if it can be converted. `command`, the command
/// that made the table, appears in the first line.
///
/// # Errors
///
/// As [`floats`].
pub fn module(table: &Table, command: &str) -> Result<Statics, FormatError> {
    let mut text = floats(table, command)?;
    let without_integers = match quantize::integers(table, quantize::TOLERANCE) {
        Ok(parts) => {
            let inner = integers(&parts, command);
            text += &format!("/// The same table in integers.\npub mod q15 {{\n{inner}}}\n");
            None
        }
        Err(error) => Some(error),
    };
    Ok(Statics { text, without_integers })
}

/// The statics of a table in `f32`.
///
/// # Errors
///
/// As [`parts::check`].
pub fn floats(table: &Table, command: &str) -> Result<String, FormatError> {
    parts::check(table)?;
    let parts = parts::floats(table).convert(|&number| number as f32);
    Ok(source::floats::module(&parts.borrow(), command))
}

/// The statics of a table in integers.
#[must_use]
pub fn integers(parts: &OwnedParts<Q15>, command: &str) -> String {
    source::integers::module(&parts.borrow(), command)
}
