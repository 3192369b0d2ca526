//! A crate with a table of its own: `build.rs` makes it of `scene.toml`.
#![no_std]

/// The table: in `f32`, and in 15 bits in [`table::q15`].
pub mod table {
    include!(concat!(env!("OUT_DIR"), "/table.rs"));
}
