//! Objects that shadow themselves: what their points see, how their pixels reflect light of every
//! direction, and the eigenimages of that, compressed for the runtime's `ShadowedObject`.
//!
//! ```no_run
//! use eigenshade_generator::material::brdf::Ggx;
//! use eigenshade_generator::object::{mesh, surface::View};
//! use eigenshade_model::shipped;
//! use eigenshade_shadows::light_root::Turns;
//! use eigenshade_shadows::{material::Material, object::Object, packed::Compression};
//!
//! let surface = mesh::surface(&"coin.obj".into(), &View::default())?;
//! let silver = Ggx::new(0.5, 0.95, 0.0)?;
//! let coin = Object::new(&surface, 96, 16, &[Material::Formula(&silver)], &())?;
//! let light = &shipped::lights()?.truncated(16).entries[0].rgb[1];
//! let pixels = coin.irradiance(light, &[1.0]);
//! let file = coin.packed(&shipped::lights()?, Turns::All, &[[1.0; 3]], Compression::default())?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod directions;
pub mod visibility;

pub mod bounce;
pub mod lit;
pub mod material;
pub mod pixels;
pub mod transport;
pub mod weights;

pub mod light_root;

pub mod codebook;
pub mod eigenimages;
pub mod object;
pub mod packed;
pub mod textured;
