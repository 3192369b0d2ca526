//! The shipped table: every normal of a sphere, degree 9, order 7, fifty
//! components, learned from captured light on measured materials.

include!(concat!(env!("OUT_DIR"), "/sphere.rs"));

/// The same table in mantissas of 15 bits.
pub mod q15 {
    include!(concat!(env!("OUT_DIR"), "/sphere_q15.rs"));
}

/// The same table in mantissas of 31 bits.
pub mod q31 {
    include!(concat!(env!("OUT_DIR"), "/sphere_q31.rs"));
}
