//! Tables: the order of their coefficients, modes and rows, their records, and their files.
//!
//! Without a feature, `no_std` and without an allocator, this crate has what the runtime and the
//! host share:
//!
//! * [`light`]: the spherical harmonic coefficient of degree l and order m.
//! * [`material`]: the Koenderink-van Doorn coefficient (o, p, q).
//! * [`pair`]: one Zernike polynomial (p, q), half of a scattering mode.
//! * [`mode`]: the irradiance modes of one azimuth |m|.
//! * [`effect`]: sets of irradiance modes with a visible meaning.
//! * [`format`](mod@format): the number formats.
//! * [`highlights`]: the sizes of sets of small sources, and the metals of their errors.
//! * [`layout`]: the memory layout of the runtime's rows.
//! * [`object`]: the file of a packed object.
//! * [`record`]: the arrays of a table.
//! * [`shadowed`]: the file of an object with shadows.
//! * [`wire`]: tables as bytes that the runtime reads in place.
//!
//! The feature `alloc` adds `source`, records as Rust source. The feature `files` adds the contents
//! of a table, its file formats, and its conversion to the runtime's numbers:
//!
//! * `scene`, `gram`, `table`: the record that a table file contains.
//! * `reduce`, `trim`: smaller tables.
//! * `parts`, `quantize`: a table as the runtime's records, in floats and in integers.
//! * `file`: a table as bytes; also [`wire`].
//! * `statics`: a table as Rust source.
//!
//! Every ordering of coefficients has the prefix property: the coefficients up to a lower degree or
//! order are the first ones of any higher degree or order. "(n)" in these pages is equation n of
//! Nillius and Eklundh, "Phenomenological Eigenfunctions for Image Irradiance", ICCV 2003.
//!
//! ```
//! use eigenshade_table::{light, material};
//!
//! // A light of degree 1 is stored as 00, 1-1, 10, 11.
//! assert_eq!(light::indices(1).collect::<Vec<_>>(), [(0, 0), (1, -1), (1, 0), (1, 1)]);
//! assert_eq!(light::position(1, -1), 1);
//! assert_eq!((light::count(9), material::count(7)), (100, 40));
//! ```
//!
//! `eigenshade-generator` makes tables; the command line reads them. A table file as a wire file
//! for a device:
//!
//! ```
//! # #[cfg(feature = "files")] {
//! use eigenshade_table::decode;
//! use eigenshade_table::wire::{self, Endian, NumberFormat};
//!
//! # let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables");
//! let table = decode(&std::fs::read(format!("{folder}/sphere.bin"))?)?;
//! let bytes = wire::encode(&table, NumberFormat::F32, Endian::Little)?;
//! assert_eq!(bytes, std::fs::read(format!("{folder}/sphere.f32.esw"))?);
//! # }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![cfg_attr(not(feature = "files"), no_std)]
#![cfg_attr(docsrs, feature(doc_cfg))]

#[cfg(feature = "alloc")]
extern crate alloc;

pub mod effect;
pub mod format;
pub mod highlights;
pub mod layout;
pub mod light;
pub mod material;
pub mod mode;
pub mod object;
pub mod pair;
pub mod record;
pub mod shadowed;
#[cfg(feature = "alloc")]
pub mod source;
pub mod wire;

#[cfg(feature = "files")]
mod chebyshev;
#[cfg(feature = "files")]
mod check;
#[cfg(feature = "files")]
pub mod file;
#[cfg(feature = "files")]
mod format_error;
#[cfg(feature = "files")]
pub mod gram;
#[cfg(feature = "files")]
pub mod parts;
#[cfg(feature = "files")]
pub mod quantize;
#[cfg(feature = "files")]
pub mod reduce;
#[cfg(feature = "files")]
pub mod scene;
#[cfg(feature = "files")]
pub mod statics;
#[cfg(feature = "files")]
pub mod table;
#[cfg(feature = "files")]
pub mod trim;

#[cfg(feature = "files")]
pub use file::{FileError, decode, encode};
#[cfg(feature = "files")]
pub use format_error::FormatError;
#[cfg(feature = "files")]
pub use gram::GramFactor;
#[cfg(feature = "files")]
pub use scene::Scene;
#[cfg(feature = "files")]
pub use table::{Component, MaterialTransfer, MeanImage, Profile, Rounding, Summary, Table};
