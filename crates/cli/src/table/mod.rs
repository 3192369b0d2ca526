//! Table files and their properties.

#[cfg(feature = "generate")]
pub mod compare;
#[cfg(feature = "generate")]
pub mod recorded_errors;
pub mod rounding;
pub mod table_file;
pub mod wire_file;
