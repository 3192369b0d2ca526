//! Reads a text line by line, with a limit on the memory for each line.

use std::io::{BufRead, Error, ErrorKind, Read, Result};

/// Maximum length of a line in bytes, enough for a polygon of a hundred thousand corners.
pub(crate) const LONGEST: usize = 1 << 20;

/// Appends the next line, including its line end, to `line`. Returns false at the end of the text.
///
/// # Errors
///
/// The errors of the reader, and a line that makes `line` longer than [`LONGEST`].
pub(crate) fn append(reader: &mut impl BufRead, line: &mut Vec<u8>) -> Result<bool> {
    let room = (LONGEST + 1).saturating_sub(line.len());
    let read = reader.by_ref().take(room as u64).read_until(b'\n', line)?;
    if line.len() > LONGEST {
        return Err(Error::new(ErrorKind::InvalidData, "a line of more than 1 MiB"));
    }
    Ok(read > 0)
}

/// Converts a line to text.
///
/// # Errors
///
/// If it is not UTF-8.
pub(crate) fn text(line: &[u8]) -> Result<&str> {
    str::from_utf8(line).map_err(|_| Error::new(ErrorKind::InvalidData, "it is not UTF-8 text"))
}
