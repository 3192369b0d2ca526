//! The module's table: the shipped one, or the one that `EIGENSHADE_TABLE` named when the module was
//! built, written by `build.rs`.

#[cfg(not(own_table))]
pub use eigenshade::sphere::*;

#[cfg(own_table)]
include!(concat!(env!("OUT_DIR"), "/table.rs"));
