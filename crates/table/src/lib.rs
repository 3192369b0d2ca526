//! The contents of an eigenshade table, its file formats, and its conversion to the runtime's
//! numbers.
//!
//! * [`scene`], [`gram`], [`table`]: the record that a table file contains.
//! * [`reduce`], [`trim`]: smaller tables.
//! * [`parts`], [`quantize`]: a table as the runtime's records, in floats and in integers.
//! * [`file`](mod@file), [`wire`]: a table as bytes.
//! * [`statics`]: a table as Rust source.
//!
//! `eigenshade-generator` makes tables; the command line reads them. A table file as a wire file
//! for a device:
//!
//! ```
//! use eigenshade_table::decode;
//! use eigenshade_table::wire::{self, Endian, NumberFormat};
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables");
//! let table = decode(&std::fs::read(format!("{folder}/sphere.bin"))?)?;
//! let bytes = wire::encode(&table, NumberFormat::F32, Endian::Little)?;
//! assert_eq!(bytes, std::fs::read(format!("{folder}/sphere.f32.esw"))?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! "(n)" in these pages is equation n of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", 2003.

pub mod scene;

pub mod gram;

pub mod table;

mod chebyshev;

pub mod trim;

pub mod reduce;

mod format_error;

pub mod parts;

pub mod quantize;

mod check;

pub mod file;

pub mod wire;

pub mod statics;

pub use file::{FileError, decode, encode};
pub use format_error::FormatError;
pub use gram::GramFactor;
pub use scene::Scene;
pub use table::{
    Component, General, MaterialTransfer, MeanImage, Profile, Rounding, Summary, Table,
};
