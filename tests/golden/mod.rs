//! The golden file: what every machine has to answer.
#![allow(dead_code, reason = "the test and the example take different parts")]

pub mod answers;
pub mod record;

pub(crate) use crate::tolerances;
