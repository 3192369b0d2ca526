//! Tables that are loaded at run time, from a flash page, a file or a fetch, and read in place.
//!
//! `eigenshade pack` writes such a file from a table; `docs/formats.md` documents its format byte
//! by byte. [`Basis::from_bytes`] and [`q15::Basis::from_bytes`] return a basis that borrows the
//! bytes: nothing is copied and nothing is allocated. Any sequence of bytes gives either a basis or
//! a [`WireError`]. Bytes after the file, such as the rest of a flash page, are ignored.
//!
//! The checksum is computed four bits at a time, with two look-ups per byte in a table of 64 bytes.
//!
//! The bytes must start at a multiple of four. [`Aligned`] ensures this for bytes embedded at
//! compile time, and [`aligned`] copies bytes that arrive without alignment:
//!
//! ```
//! # const PAGE: &[u8] = &[0; 6];
//! use eigenshade::{q15, wire};
//!
//! static TABLE: &wire::Aligned<[u8]> = &wire::Aligned(*b"from include_bytes!");
//! let refused = q15::Basis::from_bytes(&TABLE.0);
//! assert_eq!(refused.err(), Some(wire::Fault::BadMagic.into()));
//!
//! let mut room = [0; 2];
//! let bytes = wire::aligned(PAGE, &mut room)?;
//! # assert_eq!(bytes, PAGE);
//! # Ok::<(), wire::Fault>(())
//! ```

pub use crate::basis::Parts;
pub use crate::index::format::NumberFormat;
pub use crate::index::wire::{Aligned, Fault, Header, aligned};

use crate::basis::Basis;
use crate::error::Error;
use crate::index::wire::{read_floats, read_integers};
use crate::q15;
use core::fmt;

/// The first problem found in some bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum WireError {
    /// The bytes are not the expected wire file.
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

impl<'a> Basis<'a> {
    /// Reads a basis from a [wire](crate::wire) file that starts at a multiple of four.
    ///
    /// Cost: the checksum, with two look-ups per byte, and the checks of [`new`](Self::new).
    ///
    /// # Errors
    ///
    /// A [`WireError`] for any bytes that are not such a file.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
        Ok(Self::new(read_floats(bytes)?)?)
    }
}

impl<'a> q15::Basis<'a> {
    /// Reads a basis from a [wire](crate::wire) file that starts at a multiple of four.
    ///
    /// Cost: the checksum, with two look-ups per byte, and the checks of [`new`](Self::new). The
    /// largest values that a profile states are not checked: in a forged file, as opposed to a
    /// damaged one, they may make a pixel wrap.
    ///
    /// # Errors
    ///
    /// A [`WireError`] for any bytes that are not such a file.
    pub fn from_bytes(bytes: &'a [u8]) -> Result<Self, WireError> {
        Ok(Self::new(read_integers(bytes)?)?)
    }
}
