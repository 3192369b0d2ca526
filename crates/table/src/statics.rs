//! A table as Rust source: statics in floats, and modules with the table in integers.

use crate::parts;
use crate::quantize::{self, IntegerFormat, QuantizeError, in_q15, in_q31};
use crate::table::Table;
use eigenshade_index::record::integers::OwnedParts;
use eigenshade_index::source;

/// The text of a module, and the formats that it does not contain.
#[derive(Clone, Debug, PartialEq)]
pub struct Statics {
    /// The text of [`floats`], then a `mod q15` or `mod q31` for each format.
    pub text: String,
    /// Formats to which the table cannot be converted, with the reasons.
    pub left_out: Vec<(IntegerFormat, QuantizeError)>,
}

/// The statics of a table in `f32` and in those of the given integer formats to which it can be
/// converted. `command`, the command that made the table, appears in the first line.
///
/// # Errors
///
/// [`QuantizeError::TransfersOnly`] for a table that stores only transfers: it has no statics.
pub fn module(
    table: &Table,
    command: &str,
    formats: &[IntegerFormat],
) -> Result<Statics, QuantizeError> {
    if !table.has_projection() {
        return Err(QuantizeError::TransfersOnly);
    }
    let mut statics = Statics { text: floats(table, command), left_out: Vec::new() };
    for &format in formats {
        match quantize::integers(table, format, format.tolerance()) {
            Ok(parts) => {
                let inner = integers(&parts, format, command);
                let (name, bits) = (format.name(), format.bits());
                let what = format!("/// The same table in mantissas of {bits} bits.");
                statics.text += &format!("{what}\npub mod {name} {{\n{inner}}}\n");
            }
            Err(error) => statics.left_out.push((format, error)),
        }
    }
    Ok(statics)
}

/// The statics of a table in `f32`.
///
/// Domain: a table that [projects](Table::has_projection).
#[must_use]
pub fn floats(table: &Table, command: &str) -> String {
    let parts = parts::floats(table).convert(|&number| number as f32);
    let general = parts::general(table).convert(|&number| number as f32);
    source::floats::module(&parts.borrow(), &general.borrow(), command)
}

/// The statics of a table in integers.
#[must_use]
pub fn integers(parts: &OwnedParts<i32>, format: IntegerFormat, command: &str) -> String {
    match format {
        IntegerFormat::Q15 => source::integers::module(&in_q15(parts).borrow(), command),
        IntegerFormat::Q31 => source::integers::module(&in_q31(parts).borrow(), command),
    }
}
