//! Tables that are loaded at run time, from a flash page, a file or a fetch. They are read in
//! place.
//!
//! `eigenshade pack` writes such a file from a table; `tables/README.md` documents its format byte
//! by byte. [`Basis::from_bytes`], [`GeneralBasis::from_bytes`] and
//! [`quantized::Basis::from_bytes`] return a basis that borrows the bytes: nothing is copied and
//! nothing is allocated. Any sequence of bytes gives either a basis or a [`WireError`]. Bytes after
//! the file, such as the rest of a flash page, are ignored.
//!
//! The checksum is computed four bits at a time, with two look-ups per byte in a table of 64 bytes.
//!
//! The bytes must start at a multiple of four. [`Aligned`] ensures this for bytes embedded at
//! compile time, and [`aligned`] copies bytes that arrive without alignment:
//!
//! ```
//! # const PAGE: &[u8] = &[0; 6];
//! use eigenshade::{quantized, wire, Q15};
//!
//! static TABLE: &wire::Aligned<[u8]> = &wire::Aligned(*b"from include_bytes!");
//! let refused = quantized::Basis::<Q15>::from_bytes(&TABLE.0);
//! assert_eq!(refused.err(), Some(wire::Fault::BadMagic.into()));
//!
//! let mut room = [0; 2];
//! let bytes = wire::aligned(PAGE, &mut room)?;
//! # assert_eq!(bytes, PAGE);
//! # Ok::<(), wire::Fault>(())
//! ```
//!
//! [`Basis::from_bytes`]: crate::Basis::from_bytes
//! [`GeneralBasis::from_bytes`]: crate::GeneralBasis::from_bytes
//! [`quantized::Basis::from_bytes`]: crate::quantized::Basis::from_bytes

mod bases;
mod error;

pub use crate::index::format::{IntegerFormat, NumberFormat};
pub use crate::index::wire::{Aligned, Fault, Header, aligned};
pub use error::WireError;
