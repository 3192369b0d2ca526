//! Images to be read, and their reading.

pub mod image_reading;
pub mod linear_image;
pub mod pixel_mask;
pub mod pixel_normals;
