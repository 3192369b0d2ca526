//! Images from a table on the host: the runtime's methods in every number format, and the direct
//! sum as the reference.

pub mod parallel;

pub mod overflow;

pub mod shipped;

pub mod owned_basis;

pub mod shader;

pub mod methods;

pub mod integer_shader;

pub mod reference_image;

pub mod sphere_rings;
