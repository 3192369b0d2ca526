//! Inverse rendering: from pixels and their normals back to the components d, the modes c, the
//! light L and the material b.
//!
//! The pixels are collected once into an [`Observation`](observation::Observation), which then
//! represents them in every estimate. It has at most a few rows more than the number of components.
//! Each channel is an independent image.
//!
//! Tables for any object and any rotation of the light are supported: if components are sums over a
//! span, so are their images, transfers and modes.
//!
//! The derivations are in `docs/reading.md`.

pub mod eigenimage_values;

pub mod reduction;

pub mod observation;

pub mod coefficients;

pub mod fit;

pub mod transfer;

pub mod light_prior;

pub mod prior;

pub mod posterior;

pub mod modes;

pub mod rank_one;

pub mod light_estimate;

pub mod nearest;
