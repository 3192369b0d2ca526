//! The golden file: what every machine has to answer.

pub mod answers;
pub mod record;
