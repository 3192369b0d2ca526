//! The shipped table of [`eigenshade`] for firmware written in C: the header
//! `include/eigenshade.h` and a static library.
//!
//! The steps are: compute the transfer of a material, relight it with a light, collapse the
//! coefficients to a scene, and shade normals with the scene. They exist in `f32` ([`float`]) and in
//! integers ([`q15`], [`q31`]); a program links only what it calls.
//!
//! The caller owns every array. No function allocates, keeps a pointer, or has state, so all may be
//! called from interrupts and threads at once on separate arguments. Pointers must not be NULL and must
//! be aligned, which is checked. Arguments that are written to must not overlap others, which is
//! checked too.
//!
//! On bare metal the static library has a panic handler: see `panic.rs`.
#![no_std]

// On a host, std handles panics.
#[cfg(not(target_os = "none"))]
extern crate std;

mod sizes;

mod status;

mod version;

mod boundary;

mod relight_only;

pub mod float;

mod integers;

pub mod q15;

pub mod q31;

#[cfg(target_os = "none")]
mod panic;

pub use sizes::{
    EIGENSHADE_COMPONENTS, EIGENSHADE_DEGREE, EIGENSHADE_LIGHT, EIGENSHADE_MATERIAL,
    EIGENSHADE_ORDER, EIGENSHADE_PROFILES, EIGENSHADE_SCENE_F32, EIGENSHADE_SCENE_Q15,
    EIGENSHADE_SCENE_Q31, EIGENSHADE_TRANSFER, EIGENSHADE_TRANSFER_F32, EIGENSHADE_WORKSPACE,
    EIGENSHADE_WORKSPACE_F32,
};
pub use status::{Status, eigenshade_message};
pub use version::eigenshade_version;
