//! Reads tables from files.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_table::Table;
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
pub fn components(table: &Table, asked: Option<usize>, path: &Path) -> Result<usize> {
    let all = table.count();
    match asked {
        Some(count) if count > all => Err(Error::new(
            format!("it has {all} components, asked for are {count}"),
            format!("ask for {all} at most, or make a larger table with `eigenshade basis`"),
        )
        .in_file(path)),
        _ => Ok(asked.unwrap_or(all)),
    }
}
