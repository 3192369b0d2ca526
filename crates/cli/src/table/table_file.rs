//! Tables from files.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_table::Table;
use std::path::Path;

/// Reads a table.
///
/// # Errors
///
/// If the file cannot be read, is no table, of another version, or damaged.
pub fn read(file: impl Into<InputFile>) -> Result<Table> {
    let file = file.into();
    decode(&file.bytes()?).map_err(|error| error.in_file(file.path()))
}

/// The table in a file's bytes.
///
/// # Errors
///
/// If they are no table, of another version, or damaged.
pub fn decode(bytes: &[u8]) -> Result<Table> {
    eigenshade_table::decode(bytes).map_err(|error| Error::table(&error))
}

/// The number of components to use: those that are asked for, or all.
///
/// # Errors
///
/// If more are asked for than the table at `path` has.
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
