//! Image irradiance of any isotropic material under any distant light, for small machines.
//!
//! The irradiance of an object is a sum of a few eigenimages (Nillius and Eklundh,
//! "Phenomenological Eigenfunctions for Image Irradiance", ICCV 2003). A number in parentheses,
//! such as (19), refers to an equation of that paper. A [`Basis`] holds the eigenimages of one
//! scene. The steps from light to pixel are:
//!
//! 1. [`Light`] and [`Material`] hold coefficients: spherical harmonics for light, the
//!    Koenderink-van Doorn basis for materials.
//! 2. [`Basis::project`] gives the coefficients d = UᵀMc of the eigenimages. If the material stays
//!    the same, [`Basis::transfer`] takes it in once and [`Basis::relight`] applies each new light.
//! 3. [`Basis::collapse`] sums the components of each azimuth into a [`Scene`].
//! 4. [`Scene::shade`] gives the irradiance of one [`Normal`], [`Scene::shade_slice`] of many.
//! 5. [`Scene::bake`] makes a map of the image. On processors without vectors, a look-up costs less
//!    than shading.
//! 6. To turn the light, call [`Light::turned`] with a [`Rotation`]; integers have their own
//!    ([`q15::Rotation`]). A [`Window`] keeps a light from ringing, and [`NegativePolicy`] sets
//!    how to handle irradiance below zero.
//! 7. A module `color` of each table has these steps in three channels; [`Display`] makes pixels of
//!    8, 6 or 5 bits of an [`Rgb`], and the module `presets` has lights and materials by name. For a
//!    frame of many pixels, a [`Palette`] has the colors of some 900 normals.
//! 8. [`Disc`] iterates over the pixels of a sphere, [`NormalMap`] over the pixels of any object,
//!    and [`Matcap`] over the texels of a look-up by normal.
//! 9. Glossy materials mirror lamps and the sun more sharply than the harmonics of a light can
//!    represent. [`Rgb::residual`] takes each such [`Source`] out of the light, and [`Highlights`]
//!    adds its reflection on a [`Gloss`].
//! 10. [`Shader`] writes a scene and its highlights as a function of GLSL or WGSL, for graphics
//!     processors.
//! 11. In the other direction, [`Basis::estimate`] takes pixels one by one and estimates d.
//!
//! ```
//! # #[cfg(feature = "baked")] {
//! use eigenshade::{Light, Material, Normal, sphere};
//!
//! // White light from everywhere and more from the camera; a matte white sphere.
//! let light = Light::new(&[3.5, 0.0, 1.0, 0.0])?;
//! let material = Material::new(&[2.0])?;
//! let scene = sphere::collapse(&sphere::project(&light, &material)?);
//! let facing = scene.shade(Normal::new(0.0, 0.0, 1.0)?);
//! let rim = scene.shade(Normal::new(1.0, 0.0, 0.0)?);
//! assert!(facing > rim && rim > 0.0);
//! # }
//! # Ok::<(), eigenshade::Error>(())
//! ```
//!
//! A table as a module, such as `sphere` or one that a build script makes, has the functions
//! `project`, `transfer`, `relight`, `collapse` and so on, with all its sizes as constants, and the
//! types `Coefficients`, `Transfer` and `Scene`. The methods of [`Basis`] do the same for a table
//! whose size is known only at run time; they take sizes as constants or slices. The module [`q15`]
//! does all of this in integers.
//!
//! The crate is `no_std`, needs no allocator and does not panic. Loops over pixels use no
//! trigonometry, no roots and no division, except that [`Highlights`] takes one of each for a
//! source and a pixel.
//!
//! `mul_add` is not in `core`: on targets with the target feature `fma`, such as x86-64 with
//! `-C target-cpu=x86-64-v3`, the feature `std` fuses sums of products, which is faster and changes
//! their last bits. On other targets the feature changes nothing.
//!
//! [`Disc`]: object::Disc
//! [`Display`]: screen::Display
//! [`Matcap`]: object::Matcap
//! [`Palette`]: screen::Palette
//! [`NegativePolicy`]: screen::NegativePolicy
//! [`NormalMap`]: object::NormalMap
//! [`Shader`]: shader::Shader
//! [`Window`]: lights::Window
#![no_std]
// docs.rs shows which feature adds an item; only nightly compilers can.
#![cfg_attr(docsrs, feature(doc_cfg))]
#![deny(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

#[cfg(all(feature = "std", target_feature = "fma"))]
extern crate std;

// The generated statics refer to this crate by name, as user code does.
#[cfg(any(feature = "baked", feature = "generate"))]
extern crate self as eigenshade;

pub(crate) use eigenshade_table as index;

mod float;

mod error;

mod mathematics;

mod checked_slice;

mod groups;

mod buffer;

mod light;

mod rotation;

mod turn;

mod analytic;

mod material;

mod normal;

mod known_table;

mod basis;

mod transfer;

mod region;

mod rows;

mod relight;

mod projection;

mod scene;

mod nine_terms;

mod shade;

mod eigenimages;

mod table;

/// The items that the macros of a table name, in files of the steps. The kernels are the steps of
/// [`Basis::project`], [`Basis::relight`], [`Basis::collapse`] and [`Scene::shade`], with constants
/// for all sizes and positions.
#[doc(hidden)]
pub mod specialized {
    pub use crate::index::{layout, material, pair, record};
    pub use crate::known_table::{KnownTable, checked, whole};
    pub use crate::relight::{accept_light, coefficients, transfer_numbers};
    pub use crate::scene::{blank_scene, collapse, terms, terms_mut};
    pub use crate::shade::mirrored::{Mirrored, by_image};
    pub use crate::shade::slice::{ONE_BY_ONE, shade_each, shade_normals};
    pub use crate::shade::{Block, azimuth, pole};
    pub use crate::transfer::accept_material;

    /// Relighting, part by part.
    pub mod relight {
        pub use crate::relight::{GROUPS, run, sums, write};
    }

    /// Projecting, part by part.
    pub mod project {
        pub use crate::projection::{lights, rows, scatter, table_rows, transposed, write};
    }
}

pub mod truncation;

mod bake;

pub mod q15;

mod estimate;

mod color;

mod table_in_color;

mod source;

mod gloss;

mod highlights;

mod shader_text;

pub mod shader;

mod graphics;

mod display;

mod meter;

mod disc;

mod normal_code;

mod normal_map;

mod packed_object;

mod blend;

mod sphere_map;

mod srgb;

mod shadowed;

mod object_coefficients;

mod matcap;

mod nodes;

mod grid;

mod encoded;

mod pixel;

mod target;

mod object_colors;

mod painted;

mod palette;

mod linear_palette;

mod textured_object;

mod sent;

pub mod wire;

#[cfg(feature = "defmt")]
mod defmt_check;

#[cfg(feature = "mint")]
mod mint;

/// The shipped table: every normal of a sphere, degree 9, order 7, 46 components, learned from
/// captured light on measured materials and formulas.
#[cfg(feature = "baked")]
pub mod sphere {
    include!(concat!(env!("OUT_DIR"), "/sphere_f32.rs"));

    /// The same table with 15-bit mantissas.
    pub mod q15 {
        include!(concat!(env!("OUT_DIR"), "/sphere_q15.rs"));
    }
}

#[cfg(feature = "presets")]
mod metallic_roughness;

#[cfg(feature = "presets")]
pub mod presets;

/// The table of a scene, generated when this crate was built. The environment variable
/// `EIGENSHADE_SCENE` names the scene file at build time; without it, the shipped one is used.
///
/// This module has the same items as the module `sphere`, with the sizes of its own scene. The
/// module `q15` exists if the scene can be represented in integers.
#[cfg(feature = "generate")]
pub mod generated {
    include!(concat!(env!("OUT_DIR"), "/generated.rs"));
}

pub use basis::Basis;
pub use buffer::Buffer;
pub use color::Rgb;
pub use error::{Argument, Error};
pub use estimate::Estimate;
pub use gloss::Gloss;
pub use highlights::Highlights;
pub use index::effect::Effect;
pub use light::Light;
pub use material::Material;
pub use normal::{Normal, Normals};
pub use q15::Q15;
pub use relight::Coefficients;
pub use rotation::Rotation;
pub use scene::Scene;
pub use source::Source;
pub use transfer::Transfer;

/// Light from formulas and from other programs, and windows against its ringing.
pub mod lights {
    pub use crate::analytic::AnalyticLight;
    pub use crate::graphics::Convention;
    pub use crate::light::Window;
    pub use crate::nine_terms::NineTerms;
}

/// Pixels of objects: discs, normal maps, and irradiance baked by normal.
pub mod object {
    pub use crate::bake::{BakedMap, MapPoint};
    pub use crate::disc::{Disc, DiscPixel};
    pub use crate::matcap::{Matcap, MatcapTexel};
    pub use crate::normal_code::NormalCode;
    pub use crate::normal_map::{NormalMap, NormalPixel, NormalPixels};
    pub use crate::object_coefficients::ObjectCoefficients;
    pub use crate::packed_object::{Object, ObjectPixel};
    pub use crate::region::Region;
    pub use crate::shadowed::ShadowedObject;
    pub use crate::textured_object::TexturedObject;
}

/// From irradiance to the pixels of a display.
pub mod screen {
    pub use crate::blend::{blend565, blend8888};
    pub use crate::display::{Display, Exposure, Linear, Tone};
    pub use crate::grid::AnyNormal;
    pub use crate::linear_palette::LinearPalette;
    pub use crate::meter::Meter;
    pub use crate::nodes::Nodes;
    pub use crate::painted::Painted;
    pub use crate::palette::{Dithered, Palette};
    pub use crate::pixel::Pixel;
    pub use crate::sent::Sent;
    pub use crate::shade::NegativePolicy;
    pub use crate::target::Target;
}

// Runs the examples of the pages as tests.
#[cfg(all(doctest, feature = "baked", feature = "presets"))]
#[doc = include_str!("../README.md")]
struct Readme;
#[cfg(all(doctest, feature = "baked", feature = "presets"))]
#[doc = include_str!("../docs/rust.md")]
struct Pages;
