//! Why bytes are not a basis.

use super::Fault;
use crate::error::Error;
use core::fmt;

/// The first problem found in some bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum WireError {
    /// They are not the expected wire file.
    File(Fault),
    /// The parts of the basis are inconsistent.
    Parts(Error),
}

impl From<Fault> for WireError {
    fn from(fault: Fault) -> Self {
        Self::File(fault)
    }
}

impl From<Error> for WireError {
    fn from(error: Error) -> Self {
        Self::Parts(error)
    }
}

impl fmt::Display for WireError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(fault) => fault.fmt(f),
            Self::Parts(error) => write!(f, "wire file: {error}; pack the table again"),
        }
    }
}

impl core::error::Error for WireError {}
