//! Tables that are loaded at run time, from a flash page, a file or a fetch. They are read in
//! place.
//!
//! `eigenshade pack` writes such a file from a table; `tables/README.md` documents its format byte
//! by byte. [`Basis::from_bytes`], [`GeneralBasis::from_bytes`] and
//! [`quantised::Basis::from_bytes`] return a basis that borrows the bytes: nothing is copied and
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
//! use eigenshade::{quantised, wire, Q15};
//!
//! static TABLE: &wire::Aligned<[u8]> = &wire::Aligned(*b"from include_bytes!");
//! let refused = quantised::Basis::<Q15>::from_bytes(&TABLE.0);
//! assert_eq!(refused.err(), Some(wire::WireError::Foreign));
//!
//! let mut room = [0; 2];
//! let bytes = wire::aligned(PAGE, &mut room)?;
//! # assert_eq!(bytes, PAGE);
//! # Ok::<(), wire::WireError>(())
//! ```
//!
//! [`Basis::from_bytes`]: crate::Basis::from_bytes
//! [`GeneralBasis::from_bytes`]: crate::GeneralBasis::from_bytes
//! [`quantised::Basis::from_bytes`]: crate::quantised::Basis::from_bytes

mod aligned;
mod checksum;
mod error;
mod file;
mod floats;
mod format;
mod header;
mod integers;

pub use aligned::{Aligned, aligned};
pub use error::WireError;
pub use format::WireFormat;
pub use header::Header;
