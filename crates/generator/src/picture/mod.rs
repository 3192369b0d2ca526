//! Pictures as files.

pub mod png_curve;
pub mod png_samples;
