//! The shipped table: every normal of a sphere, degree 9, order 7, fifty
//! components, learned from captured light on measured materials.

include!(concat!(env!("OUT_DIR"), "/sphere.rs"));
