//! What `eigenshade-wasm` does once for a light or a material.
//!
//! Apart, because an optimisation level is a crate's: the loops over pixels are compiled
//! for speed, this for size. Its exports are exports of the module.
#![cfg(target_arch = "wasm32")]
#![no_std]

pub mod shared;

/// The table: the shipped one.
#[cfg(not(own_table))]
pub use eigenshade::sphere as table;

#[cfg(own_table)]
pub mod table;

pub mod inputs;

#[cfg(feature = "f32")]
pub mod floats;

#[cfg(feature = "relight")]
mod relight;

#[cfg(feature = "map")]
pub mod map;

#[cfg(any(feature = "q15", feature = "q31"))]
pub mod integers;
