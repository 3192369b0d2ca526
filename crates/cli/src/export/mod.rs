//! Lights, materials, tables and scenes for other programs: as source in Rust, C and JavaScript,
//! and as arrays in JSON and numpy's npz.

pub mod array;

pub mod coefficients;

pub mod shown;

pub mod table;

pub mod scene;

#[cfg(feature = "generate")]
pub mod npz;

pub mod entry;

pub mod highlights;

mod source;

pub mod rust;

pub mod c;

pub mod js;
