//! The library's table: the shipped one or, with the feature `own-table`, the table of your scene.

#[cfg(feature = "own-table")]
pub(crate) use eigenshade::generated::*;
#[cfg(not(feature = "own-table"))]
pub(crate) use eigenshade::sphere::*;
