//! The wire format: tables as bytes that the runtime reads in place.
//!
//! `docs/formats.md` specifies the format byte by byte. The sections of a file are the arrays of
//! the [records](crate::record), in the same order; empty sections at the end are omitted. This
//! module has the constants of the format, the reader, and with the feature `files` the writer.

#[cfg(feature = "files")]
mod encode;
mod fault;
mod file;

pub use crate::format::NumberFormat;
#[cfg(feature = "files")]
pub use encode::{Endian, encode};
pub use fault::Fault;
pub use file::{Aligned, Header, aligned, read_floats, read_integers};

/// The first bytes of every wire file.
pub const LABEL: [u8; 8] = *b"EIGSWIRE";

/// The number after the label; it reveals the byte order of the rest of the file.
pub const MARK: u32 = 0x0102_0304;

/// The wire format version.
pub const VERSION: u16 = 4;

/// The alignment in bytes of a file and of each of its sections.
pub const ALIGNMENT: usize = 4;

/// Size of the header in bytes: label, mark, version, format, length, shape, number of sections.
pub const HEADER: usize = 28;

/// Size in bytes of a section's entry after the header: its start and its length.
pub const ENTRY: usize = 8;

/// Size in bytes of the checksum at the end of a file.
pub const CHECKSUM: usize = 4;

/// Byte offsets of the numbers in the header.
pub mod place {
    /// u32: [`MARK`](super::MARK).
    pub const MARK: usize = 8;
    /// u16: the version.
    pub const VERSION: usize = 12;
    /// u16: [`NumberFormat::number`](crate::format::NumberFormat::number).
    pub const FORMAT: usize = 14;
    /// u32: length of the whole file in bytes.
    pub const LENGTH: usize = 16;
    /// u16: largest degree l of the light.
    pub const DEGREE: usize = 20;
    /// u16: largest order o of the BRDF.
    pub const ORDER: usize = 22;
    /// u16: number of components.
    pub const COMPONENTS: usize = 24;
    /// u16: number of sections.
    pub const SECTIONS: usize = 26;
}
