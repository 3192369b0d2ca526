//! Writes CSV row by row.

use crate::output::destination::fault;
use eigenshade_model::error::{Error, Result};
use std::io::Write;

/// A CSV writer.
pub struct Rows<'a>(csv::Writer<&'a mut dyn Write>);

impl<'a> Rows<'a> {
    /// Starts the CSV with its header.
    ///
    /// # Errors
    ///
    /// If the output fails.
    pub fn new<T: AsRef<[u8]>>(
        out: &'a mut dyn Write,
        header: impl IntoIterator<Item = T>,
    ) -> Result<Self> {
        // Setting the comment character makes the writer quote names that begin with it.
        let writer = csv::WriterBuilder::new().comment(Some(b'#')).from_writer(out);
        let mut rows = Self(writer);
        rows.row(header)?;
        Ok(rows)
    }

    /// Writes one row, which has as many fields as the header.
    ///
    /// # Errors
    ///
    /// If the output fails.
    pub fn row<T: AsRef<[u8]>>(&mut self, fields: impl IntoIterator<Item = T>) -> Result<()> {
        let written = self.0.write_record(fields);
        written.map_err(|error| Error::new(error.to_string(), "check where the output goes"))
    }

    /// Flushes the output.
    ///
    /// # Errors
    ///
    /// If the output fails.
    pub fn finish(mut self) -> Result<()> {
        self.0.flush().map_err(|error| fault(&error))
    }
}
