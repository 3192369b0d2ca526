//! The way from light to pixel in integers, for machines without a float unit.
//!
//! The same mathematics as in floats, and the same names: a [`Basis`] folds a
//! [`Material`] in ([`Basis::fold`]), takes each new [`Light`] ([`Basis::relight`]) and
//! sums the components of each azimuth ([`Basis::collapse`]); a [`Scene`] gives the
//! irradiance of a [`Normal`]. A number is a mantissa times 2^exponent; arrays share
//! exponents, and every answer brings its own.
//!
//! Nothing wraps. The tables are scaled so that no sum over them can leave its
//! accumulator, which [`Basis::new`] checks when it is compiled; what depends on light
//! and material is scaled by what it is, and what cannot be represented saturates.
//! Transfers made by hand are checked, coefficients may be any. What a profile states of
//! its size is believed: where that is too small a pixel is wrong, but never a panic.
//! The answers are the same bits on every machine.

mod basis;
mod coefficients;
mod collapse;
mod estimate;
mod fold;
mod inputs;
#[doc(hidden)]
pub mod kernels;
mod normal;
mod parts;
mod relight;
mod shade;

pub use basis::Basis;
pub use coefficients::Coefficients;
pub use collapse::{Scene, SceneBuffer};
pub use estimate::Estimate;
pub use fold::{Transfer, TransferBuffer};
pub use inputs::{Light, Material};
pub use normal::Normal;
pub use parts::{Parts, Profile};
