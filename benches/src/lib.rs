//! What the counts and the comparisons share.

pub mod shipped;

pub mod paths;

pub mod sheet;
