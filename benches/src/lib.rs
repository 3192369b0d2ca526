//! The paths and the files of results, for the counts and for the comparisons.

pub mod shipped;

pub mod paths;

pub mod sheet;
