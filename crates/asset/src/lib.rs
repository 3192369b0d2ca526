//! Objects with materials of their own: glTF, Wavefront files with `.mtl`, and polygon files with
//! vertex colors.
//!
//! [`Asset::read`](asset::Asset::read) reads a file, and [`Picture::of`](picture::Picture::of) draws
//! it under a light:
//!
//! ```no_run
#![doc = include_str!("../examples/draw_glb.rs")]
//! ```
//!
//! [`Texels::of`](texels::Texels::of) samples an object without a light: each pixel of its picture
//! shows one or more [texels](eigenshade_shading::textured::Texel).

pub mod asset;

pub mod image;
pub mod texture;

mod accessor;
mod buffers;
mod gltf_file;
mod gltf_materials;
mod gltf_meshes;
mod gltf_pose;
mod wavefront;

mod tangents;

pub mod texels;

pub mod packed;

pub mod picture;
