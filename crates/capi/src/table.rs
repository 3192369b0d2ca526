//! The table of the library: the shipped one, or that of a scene of one's own.

#[cfg(feature = "own-table")]
pub(crate) use eigenshade::generated::*;
#[cfg(not(feature = "own-table"))]
pub(crate) use eigenshade::sphere::*;
