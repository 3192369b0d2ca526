//! Table files, their contents and their errors.

#[cfg(feature = "generate")]
pub mod compare;
#[cfg(feature = "generate")]
pub mod recorded_errors;
pub mod rounding;

use crate::messages::grouped;
use eigenshade::wire::{Header, WireError, WireFormat, aligned};
use eigenshade::{Basis, GeneralBasis, GeneralParts, Parts, Q15, Q31, quantized};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::wire::{ENTRY, HEADER, LABEL};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_table::Table;
use std::fmt::Write;
use std::path::Path;

/// Reads a table.
///
/// # Errors
///
/// If the file cannot be read, is not a table, has another version, or is damaged.
pub fn read(file: impl Into<InputFile>) -> Result<Table> {
    let file = file.into();
    decode(&file.bytes()?).map_err(|error| error.in_file(file.path()))
}

/// Decodes a table from the bytes of a file.
///
/// # Errors
///
/// If the bytes are not a table, have another version, or are damaged.
pub fn decode(bytes: &[u8]) -> Result<Table> {
    eigenshade_table::decode(bytes).map_err(|error| Error::table(&error))
}

/// The number of components to use: the requested number, or all.
///
/// # Errors
///
/// If the request exceeds the number of components of the table at `path`.
pub fn components(table: &Table, requested: Option<usize>, path: &Path) -> Result<usize> {
    let all = table.count();
    match requested {
        Some(count) if count > all => Err(Error::new(
            format!("it has {all} components, but {count} are requested"),
            format!("request {all} at most, or make a larger table with `eigenshade basis`"),
        )
        .in_file(path)),
        _ => Ok(requested.unwrap_or(all)),
    }
}

/// Whether the bytes begin like a wire file.
#[must_use]
pub fn is_wire(bytes: &[u8]) -> bool {
    bytes.starts_with(&LABEL)
}

/// Describes the contents of a wire file, line by line.
///
/// # Errors
///
/// If the runtime refuses the bytes.
pub fn wire_description(bytes: &[u8]) -> Result<String> {
    let header = checked(bytes).map_err(|error| described(&error))?;
    let (format, names) = match WireFormat::of(header.format) {
        Some(WireFormat::F32) | None => {
            (WireFormat::F32, [Parts::<f32>::ARRAYS, GeneralParts::<f32>::ARRAYS].concat())
        }
        Some(format) => (format, quantized::Parts::<Q15>::ARRAYS.to_vec()),
    };
    let mut text = String::new();
    let lines = [
        ("wire version", header.version.to_string()),
        ("format", format.name().to_owned()),
        ("degree", header.degree.to_string()),
        ("order", header.order.to_string()),
        ("effects", effect_names(header.effects)),
        ("components", header.images.max(header.components).to_string()),
        ("span", if header.images == 0 { 0 } else { header.components }.to_string()),
    ];
    for (what, value) in lines {
        let _ = writeln!(text, "{what:<24} {value}");
    }
    for (number, name) in names.into_iter().take(header.sections).enumerate() {
        let name = name.replace('_', " ");
        let at = HEADER + ENTRY * number + ENTRY / 2;
        let length = u32::from_ne_bytes(std::array::from_fn(|k| bytes[at + k]));
        let _ = writeln!(text, "{name:<24} {:>9} bytes", grouped(length as usize));
    }
    let _ = writeln!(text, "{:<24} {:>9} bytes", "file", grouped(header.length));
    Ok(text)
}

/// The names of effects.
#[must_use]
pub fn effect_names(effects: Effects) -> String {
    let names = Effect::ALL.into_iter().filter(|&effect| effects.has(effect)).map(Effect::name);
    names.collect::<Vec<_>>().join(" ")
}

/// The header of a file that the runtime accepts.
fn checked(bytes: &[u8]) -> std::result::Result<Header, WireError> {
    let header = Header::read(bytes)?;
    let mut room = vec![0; bytes.len().div_ceil(4)];
    let bytes = aligned(bytes, &mut room)?;
    match WireFormat::of(header.format) {
        Some(WireFormat::Q15) => quantized::Basis::<Q15>::from_bytes(bytes).map(drop)?,
        Some(WireFormat::Q31) => quantized::Basis::<Q31>::from_bytes(bytes).map(drop)?,
        _ if header.images > 0 => GeneralBasis::<f32>::from_bytes(bytes).map(drop)?,
        _ => Basis::<f32>::from_bytes(bytes).map(drop)?,
    }
    Ok(header)
}

/// Splits the one line of [`WireError`] into the problem and the remedy.
fn described(error: &WireError) -> Error {
    let line = error.to_string();
    let (what, remedy) = line.rsplit_once("; ").unwrap_or((&line, "pack the table again"));
    Error::new(what, remedy)
}
