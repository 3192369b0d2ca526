//! A table as a basis of the runtime in any of its float formats, for tests of its mathematics.

use eigenshade::{Basis, GeneralBasis, Scalar};
use eigenshade_index::record::floats::{OwnedGeneralParts, OwnedParts};
use eigenshade_table::{Table, parts};

pub struct OwnedBasis<S> {
    parts: OwnedParts<S>,
    general: OwnedGeneralParts<S>,
    /// The fingerprint and the transfer of each material that the table stores.
    pub transfers: Vec<(u32, Vec<S>)>,
}

impl<S: Scalar> OwnedBasis<S> {
    pub fn new(table: &Table) -> Self {
        let parts = parts::floats(table);
        let transfers = table.transfers.iter().map(|one| {
            let numbers = parts::transfer(&parts, &one.numbers);
            (one.fingerprint, numbers.iter().map(|&number| S::from_f64(number)).collect())
        });
        Self {
            transfers: transfers.collect(),
            parts: parts.convert(|&number| S::from_f64(number)),
            general: parts::general(table).convert(|&number| S::from_f64(number)),
        }
    }

    /// The basis, or the span of a general one.
    pub fn basis(&self) -> Basis<'_, S> {
        Basis::new(self.parts.borrow()).expect("parts of a table")
    }

    /// The general basis, of a table for other normals than a sphere's.
    pub fn general(&self) -> Option<GeneralBasis<'_, S>> {
        let parts = self.general.borrow();
        (parts.components > 0).then(|| GeneralBasis::new(self.basis(), parts).expect("parts"))
    }
}
