//! Special functions, one per file, by normalized recurrences: accurate to degree 64 and more, at
//! the poles and at tiny angles.

pub mod gauss_legendre;
pub mod graded;
pub mod legendre;
pub mod spherical_harmonic;
pub mod wigner;
pub mod zernike;
