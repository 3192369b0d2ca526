//! Tables that arrive at run time: bytes of a flash page, a file or a fetch, read where
//! they lie.
//!
//! `eigenshade pack` writes such a file from a table; `tables/README.md` has it byte by
//! byte. [`Basis::from_bytes`], [`GeneralBasis::from_bytes`] and
//! [`quantised::Basis::from_bytes`] give a basis that borrows the bytes: nothing is
//! copied, nothing allocated. Any bytes give a basis or one [`WireError`]. What follows a
//! file, like the rest of its page, is not looked at.
//!
//! The checksum is computed four bits at a time: two look-ups a byte, a table of 64
//! bytes.
//!
//! The bytes have to start at a multiple of four. [`Aligned`] sees to that where they
//! are compiled in, [`aligned`] copies them where they come as they come:
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
