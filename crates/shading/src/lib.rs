//! Images from a table on the host by the runtime's methods, in f32 and in integers.
//!
//! The feature `sources` finds small bright sources in captured light.
//!
//! A shipped material under a shipped light:
//!
//! ```
//! use eigenshade_shading::owned_basis::OwnedBasis;
//! use eigenshade_shading::shader::{OwnedNormals, Shader, fitted};
//! use eigenshade_model::shipped;
//!
//! let table = eigenshade_table::decode(shipped::TABLE)?;
//! let (lights, materials) = fitted(&table, &shipped::lights()?, &shipped::materials()?);
//! let owned = OwnedBasis::new(&table)?;
//! let mut shader = Shader::new(owned.basis()?, 46);
//! let normals = OwnedNormals::new(&[[0.0, 0.0, 1.0], [0.6, 0.0, 0.8]]);
//! let (light, material) = (&lights.entries[0], &materials.entries[0]);
//! let rgb = shader.color(light, material, &normals)?;
//! assert!(rgb.iter().all(|channel| channel.len() == 2 && channel[0] > 0.0));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod owned_basis;

pub mod shader;

pub mod textured;

pub mod methods;

pub mod integer_shader;

pub mod highlights;

pub mod presets;

pub mod estimate;

pub mod preview;

pub mod picture;

#[cfg(feature = "sources")]
pub mod sources;
