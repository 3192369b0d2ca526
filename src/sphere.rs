//! The shipped table: every normal of a sphere, degree 9, order 7, fifty components, learned from
//! captured light on measured materials.

include!(concat!(env!("OUT_DIR"), "/sphere.rs"));

/// The same table with 15-bit mantissas.
pub mod q15 {
    include!(concat!(env!("OUT_DIR"), "/sphere_q15.rs"));
}

/// The same table with 31-bit mantissas.
pub mod q31 {
    include!(concat!(env!("OUT_DIR"), "/sphere_q31.rs"));
}
