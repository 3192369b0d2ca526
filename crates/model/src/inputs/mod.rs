//! Coefficients and normals as files.

pub mod coefficient_csv;
mod coefficient_kind;
pub mod input_file;
pub mod normals;
pub mod rounding;
pub mod sheet;
