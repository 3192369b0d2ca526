//! The contents of an eigenshade table, its file format, and its conversion to the runtime's
//! numbers.
//!
//! `eigenshade-generator` makes tables; the runtime's build script and the command line read them.
//! "(n)" in these pages is equation n of Nillius and Eklundh, "Phenomenological Eigenfunctions for
//! Image Irradiance", 2003.

pub mod scene;

pub mod gram;

pub mod general;

pub mod table;

pub mod transfer;

mod check;

pub mod file;

pub mod manifest;

mod polynomials;

pub mod parts;

pub mod passes;

pub mod components;

pub mod cut;
pub mod trim;

pub mod quantise;

mod rust_kernels;

mod rust_scene;

pub mod rust_quantised;
mod rust_quantised_functions;

pub mod rust_source;

pub mod statics;

pub mod wire;

pub use file::{FileError, decode, encode};
pub use general::General;
pub use gram::GramFactor;
pub use parts::Parts;
pub use scene::Scene;
pub use table::{Component, MeanImage, Profile, Rounding, Summary, Table};
pub use transfer::MaterialTransfer;
