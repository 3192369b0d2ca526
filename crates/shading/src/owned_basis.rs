//! A table read at run time, as a runtime basis.

use crate::shader::beyond;
use eigenshade::Basis;
use eigenshade_model::error::{Error, Result};
use eigenshade_table::record::floats::OwnedParts;
use eigenshade_table::{FormatError, Table, parts};

/// The owned records of a basis.
#[derive(Clone, Debug)]
pub struct OwnedBasis {
    parts: OwnedParts<f32>,
    transfers: Vec<OwnedTransfer>,
}

/// A material whose transfer the table stores.
#[derive(Clone, Debug)]
pub struct OwnedTransfer {
    /// The fingerprint of the material's coefficients: [`eigenshade_table::reduce::fingerprint`].
    pub fingerprint: u32,
    /// The transfer, for [`Basis::relight_into`].
    pub transfer: Vec<f32>,
}

impl OwnedBasis {
    /// Rounds a table's numbers to f32.
    ///
    /// # Errors
    ///
    /// If the table has a mean image, a selection of modes, or a degree or order that f32 does not
    /// support.
    pub fn new(table: &Table) -> Result<Self> {
        match parts::check(table) {
            // Those of a table of transfers are drawn.
            Ok(()) | Err(FormatError::TransfersOnly) => {}
            Err(FormatError::High { degree, order }) => return Err(beyond(degree, order)),
            Err(error) => {
                let line = format!("f32 does not draw the table: {error}");
                let (what, remedy) = line.rsplit_once("; ").unwrap_or((&line, "take another"));
                return Err(Error::new(what, format!("use --format f64, or {remedy}")));
            }
        }
        let parts = parts::floats(table);
        let transfers = table.transfers.iter().map(|one| {
            let numbers = parts::transfer(&parts, &one.numbers);
            let transfer = numbers.iter().map(|&number| number as f32).collect();
            OwnedTransfer { fingerprint: one.fingerprint, transfer }
        });
        Ok(Self { transfers: transfers.collect(), parts: parts.convert(|&number| number as f32) })
    }

    /// The materials whose transfers the table stores; empty for a table that projects.
    #[must_use]
    pub fn transfers(&self) -> &[OwnedTransfer] {
        &self.transfers
    }

    /// The basis.
    ///
    /// # Errors
    ///
    /// As [`Basis::new`], for a table whose parts contradict each other.
    pub fn basis(&self) -> std::result::Result<Basis<'_>, eigenshade::Error> {
        Basis::new(self.parts.borrow())
    }
}
