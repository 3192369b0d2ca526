//! Tables as files, and what is said of them.

#[cfg(feature = "generate")]
pub mod compare;
#[cfg(feature = "generate")]
pub mod recorded_errors;
pub mod rounding;
pub mod table_file;
pub mod wire_file;
