//! Reads images and estimates light and material from them.

pub mod image_reading;
pub mod linear_image;
pub mod pixel_mask;
pub mod pixel_normals;
