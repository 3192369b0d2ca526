//! A table read at run time, as a runtime basis in a chosen number format.

use eigenshade::{Basis, GeneralBasis, Scalar};
use eigenshade_index::record::floats::{OwnedGeneralParts, OwnedParts};
use eigenshade_table::{Table, parts};

/// The owned records of a basis.
#[derive(Clone, Debug)]
pub struct OwnedBasis<S> {
    parts: OwnedParts<S>,
    general: OwnedGeneralParts<S>,
    transfers: Vec<OwnedTransfer<S>>,
}

/// A material whose transfer the table stores.
#[derive(Clone, Debug)]
pub struct OwnedTransfer<S> {
    /// The fingerprint of its coefficients: [`eigenshade_table::reduce::fingerprint`].
    pub fingerprint: u32,
    /// Its transfer, for [`Basis::relight_into`].
    pub transfer: Vec<S>,
}

impl<S: Scalar> OwnedBasis<S> {
    /// Rounds a table's numbers to the format.
    #[must_use]
    pub fn new(table: &Table) -> Self {
        let parts = parts::floats(table);
        let transfers = table.transfers.iter().map(|one| {
            let numbers = parts::transfer(&parts, &one.numbers);
            let transfer = numbers.iter().map(|&number| S::from_f64(number)).collect();
            OwnedTransfer { fingerprint: one.fingerprint, transfer }
        });
        Self {
            transfers: transfers.collect(),
            parts: parts.convert(|&number| S::from_f64(number)),
            general: parts::general(table).convert(|&number| S::from_f64(number)),
        }
    }

    /// The materials whose transfers the table stores; empty for a table that projects.
    #[must_use]
    pub fn transfers(&self) -> &[OwnedTransfer<S>] {
        &self.transfers
    }

    /// The basis of the table, of either kind.
    ///
    /// # Errors
    ///
    /// See [`basis`](Self::basis).
    pub fn any(&self) -> Result<AnyBasis<'_, S>, eigenshade::Error> {
        let basis = self.basis()?;
        match self.general.components {
            0 => Ok(AnyBasis::Sphere(basis)),
            _ => GeneralBasis::new(basis, self.general.borrow()).map(AnyBasis::General),
        }
    }

    /// The basis itself, or the span of a general basis.
    ///
    /// # Errors
    ///
    /// As [`Basis::new`], for a table whose parts contradict each other.
    pub fn basis(&self) -> Result<Basis<'_, S>, eigenshade::Error> {
        Basis::new(self.parts.borrow())
    }
}

/// A basis of either kind.
#[derive(Clone, Copy, Debug)]
pub enum AnyBasis<'a, S> {
    /// Each eigenimage has a single azimuth.
    Sphere(Basis<'a, S>),
    /// Eigenimages are sums over several azimuths.
    General(GeneralBasis<'a, S>),
}

impl<'a, S> From<Basis<'a, S>> for AnyBasis<'a, S> {
    fn from(basis: Basis<'a, S>) -> Self {
        Self::Sphere(basis)
    }
}
