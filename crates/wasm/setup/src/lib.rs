//! The part of `eigenshade-wasm` that runs once for a light or a material.
//!
//! A crate of its own, because the optimization level is that of a crate: the loops over pixels are
//! compiled for speed, this crate for size. Its exports are exports of the module.
#![cfg(target_arch = "wasm32")]
#![no_std]

/// The shipped table.
#[cfg(not(own_table))]
pub use eigenshade::sphere as table;

/// The table that `EIGENSHADE_TABLE` named when the module was built, written by `build.rs`.
#[cfg(own_table)]
pub mod table {
    include!(concat!(env!("OUT_DIR"), "/table.rs"));

    /// The same table in mantissas of 15 bits.
    #[cfg(feature = "q15")]
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/table_q15.rs"));
    }

    /// The same table in mantissas of 31 bits.
    #[cfg(feature = "q31")]
    pub mod q31 {
        include!(concat!(env!("OUT_DIR"), "/table_q31.rs"));
    }
}

pub mod buffers;

#[cfg(feature = "f32")]
pub mod floats;

#[cfg(any(feature = "q15", feature = "q31"))]
pub mod integers;
