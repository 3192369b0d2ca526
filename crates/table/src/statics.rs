//! A table as one file of Rust source: its statics in floats, and modules of it in
//! integers.

use crate::quantise::{Format, QuantiseError, QuantisedParts};
use crate::table::Table;
use crate::{rust_quantised, rust_source};

/// The text of a module, and the formats that it lacks.
#[derive(Clone, Debug, PartialEq)]
pub struct Statics {
    /// What [`rust_source::module`] gives, then a `mod q15` or `mod q31` for each format.
    pub text: String,
    /// Formats that do not serve the table, and why.
    pub left_out: Vec<(Format, QuantiseError)>,
}

/// The statics of a table in `f32` and in these integer formats, those that serve it.
/// `command` is what made it, for the first line.
///
/// # Errors
///
/// [`QuantiseError::Folded`] for a table that keeps transfers alone, which has no
/// statics.
pub fn module(table: &Table, command: &str, formats: &[Format]) -> Result<Statics, QuantiseError> {
    if !table.has_projection() {
        return Err(QuantiseError::Folded);
    }
    let mut statics = Statics { text: rust_source::module(table, command), left_out: Vec::new() };
    for &format in formats {
        match QuantisedParts::new(table, format, format.tolerance()) {
            Ok(parts) => {
                let inner = rust_quantised::module(&parts, command);
                let (name, bits) = (format.name(), format.bits());
                let what = format!("/// The same table in mantissas of {bits} bits.");
                statics.text += &format!("{what}\npub mod {name} {{\n{inner}}}\n");
            }
            Err(error) => statics.left_out.push((format, error)),
        }
    }
    Ok(statics)
}
