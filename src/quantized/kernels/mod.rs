//! Kernels for tables that are known when the program is compiled: `integer_table!` calls them, once
//! for each azimuth.
//!
//! They compute the same bits as [`Basis::transfer`](super::Basis::transfer),
//! [`Basis::relight`](super::Basis::relight), [`Basis::collapse`](super::Basis::collapse) and
//! [`Scene::shade`](super::Scene::shade), with constants for all sizes and positions. If an argument
//! does not have the expected shape, the general functions are called instead.

pub mod collapse;
pub mod transfer;

/// Relighting, part by part.
pub mod relight {
    pub use crate::quantized::relight::{
        NONE, align, azimuth, coefficients, common, exponent, inputs,
    };
}

pub use super::pixel::Pixel;
