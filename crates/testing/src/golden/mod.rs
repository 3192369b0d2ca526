//! The golden file: results that every machine must reproduce.

pub mod answers;
pub mod record;
