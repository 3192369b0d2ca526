//! The program `eigenshade`, as a library: what its commands share.

pub mod named;

pub mod table;

pub mod notes;

pub mod picture;

#[cfg(feature = "generate")]
pub mod reading;

pub mod output;
