//! Captured light: environment maps and their coefficients.

pub mod convention;
pub mod environment;
pub(crate) mod map_exr;
pub(crate) mod map_exr_check;
pub(crate) mod map_hdr;
pub(crate) mod map_pfm;
pub mod projection;
pub mod statistics;
