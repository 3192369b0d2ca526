//! A table as one Rust source file: statics in floats, and modules with the table in integers.

use crate::quantize::{self, Format, QuantizeError};
use crate::table::Table;
use crate::{rust_quantized, rust_source};

/// The text of a module, and the formats that it does not contain.
#[derive(Clone, Debug, PartialEq)]
pub struct Statics {
    /// The text of [`rust_source::module`], then a `mod q15` or `mod q31` for each format.
    pub text: String,
    /// Formats to which the table cannot be converted, with the reasons.
    pub left_out: Vec<(Format, QuantizeError)>,
}

/// The statics of a table in `f32` and in those of the given integer formats to which it can be
/// converted. `command`, the command that made the table, appears in the first line.
///
/// # Errors
///
/// [`QuantizeError::TransfersOnly`] for a table that stores only transfers: it has no statics.
pub fn module(table: &Table, command: &str, formats: &[Format]) -> Result<Statics, QuantizeError> {
    if !table.has_projection() {
        return Err(QuantizeError::TransfersOnly);
    }
    let mut statics = Statics { text: rust_source::module(table, command), left_out: Vec::new() };
    for &format in formats {
        match quantize::integers(table, format, format.tolerance()) {
            Ok(parts) => {
                let inner = rust_quantized::module(&parts, format, command);
                let (name, bits) = (format.name(), format.bits());
                let what = format!("/// The same table in mantissas of {bits} bits.");
                statics.text += &format!("{what}\npub mod {name} {{\n{inner}}}\n");
            }
            Err(error) => statics.left_out.push((format, error)),
        }
    }
    Ok(statics)
}
