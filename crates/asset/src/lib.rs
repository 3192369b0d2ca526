//! Objects with materials of their own: glTF, Wavefront files with `.mtl`, and polygon files with
//! vertex colors.
//!
//! [`Asset::read`](asset::Asset::read) reads a file, and [`Texels::of`](texels::Texels::of) samples
//! it: each pixel of its picture shows one or more [texels](eigenshade_shading::textured::Texel),
//! which [`irradiance`](eigenshade_shading::textured::irradiance) shades:
//!
//! ```no_run
//! use eigenshade_asset::{asset::Asset, texels::Texels};
//! use eigenshade_generator::object::surface::View;
//! use eigenshade_model::shipped;
//! use eigenshade_shading::owned_basis::OwnedBasis;
//! use eigenshade_shading::shader::Shader;
//! use eigenshade_shading::textured::irradiance;
//!
//! let file = "watch.glb".into();
//! let asset = Asset::read(&file)?.ok_or("no materials")?;
//! let texels = Texels::of(&file, &asset, 256, &View::default())?;
//! let table = eigenshade_table::decode(shipped::PBR)?;
//! let owned = OwnedBasis::new(&table)?;
//! let mut shader = Shader::new(owned.any()?, table.count());
//! let lights = shipped::lights()?.truncated(12);
//! let colors = irradiance(&mut shader, &lights.entries[0], 12, &texels.texels, &[])?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod asset;

pub mod image;
pub mod texture;

mod accessor;
mod buffers;
mod gltf_file;
mod gltf_materials;
mod gltf_meshes;
mod wavefront;

mod tangents;

pub mod texels;

pub mod packed;
