//! The shipped table of [`eigenshade`] for firmware written in C: the header
//! `include/eigenshade.h` and a static library.
//!
//! In the order of the mathematics: a material is folded in, a light relights it, the
//! coefficients are collapsed to a scene, the scene gives the irradiance of normals. In
//! `f32` ([`float`]) and in integers ([`q15`], [`q31`]); a program links what it calls.
//!
//! The caller owns every array. No function allocates, keeps a pointer, or has a state:
//! all of them may be called from interrupts and threads at once, on arguments of their
//! own. Pointers may not be NULL and have the alignment of what they point to, which is
//! checked; an argument that is written to may not overlap another, which is checked where
//! both are arrays of one format.
//!
//! On bare metal the static library has a panic handler: see `panic.rs`.
#![no_std]

// Panics of hosts' programs are std's.
#[cfg(not(target_os = "none"))]
extern crate std;

mod sizes;

mod status;

mod version;

mod boundary;

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
