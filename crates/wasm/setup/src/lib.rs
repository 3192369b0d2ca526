//! The part of `eigenshade-wasm` that runs once for a light or a material.
//!
//! A crate of its own, because the optimization level is that of a crate: the loops over pixels are
//! compiled for speed, this crate for size. Its exports are exports of the module.
#![cfg(target_arch = "wasm32")]
#![no_std]

mod table;

pub mod shared;

mod inputs;

pub mod scene;

#[cfg(feature = "sources")]
pub mod highlights;

mod shader;
