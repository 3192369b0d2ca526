//! Pictures of spheres.

pub mod canvas;
pub mod png_file;
pub mod sphere_view;
pub mod tone;
