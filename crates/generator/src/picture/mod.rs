//! Reads picture files.

pub mod png_curve;
pub mod png_samples;
