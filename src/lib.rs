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
//!    the same, [`Basis::transfer`] folds it in once and [`Basis::relight`] applies each new light.
//! 3. [`Basis::collapse`] sums the components of each azimuth into a [`Scene`].
//! 4. [`Scene::shade`] gives the irradiance of one [`Normal`], [`Scene::shade_slice`] that of many.
//! 5. There are cheaper ways to shade a pixel: [`Scene::lookup`] samples the azimuths of the image,
//!    [`Scene::bake`] the image itself.
//! 6. To turn the light, call [`Light::turned`] with a [`Rotation`]. A [`Window`] keeps a light
//!    from ringing, and [`Negatives`] sets how to handle irradiance below zero.
//! 7. In the other direction, [`Basis::estimate`] takes pixels one by one and estimates d.
//!
//! A [`GeneralBasis`] does the same for objects other than a sphere.
//!
//! ```
//! # #[cfg(feature = "baked")] {
//! use eigenshade::{Light, Material, Normal, sphere};
//!
//! // White light from everywhere and more from the camera; a matte white sphere.
//! let light = Light::new(1, &[3.5, 0.0, 1.0, 0.0])?;
//! let material = Material::new(0, &[2.0])?;
//! let scene = sphere::collapse(&sphere::project(&light, &material)?)?;
//! let facing = scene.shade(Normal::new(0.0, 0.0, 1.0)?);
//! let rim = scene.shade(Normal::new(1.0, 0.0, 0.0)?);
//! assert!(facing > rim && rim > 0.0);
//! # }
//! # Ok::<(), eigenshade::Error>(())
//! ```
//!
//! The crate needs no allocator and does not panic. Its loops over pixels use no trigonometry, no
//! roots and no division.
#![no_std]
#![deny(clippy::indexing_slicing, clippy::unwrap_used, clippy::expect_used, clippy::panic)]

// `mul_add` is not in `core`. It comes from `std` on targets with fused multiply-add and an
// operating system; no other build links `std`.
#[cfg(all(target_feature = "fma", any(unix, windows)))]
extern crate std;

// The generated statics refer to this crate by name, as user code does.
#[cfg(any(feature = "baked", feature = "generate"))]
extern crate self as eigenshade;

pub use eigenshade_index as index;

mod format;

mod scalar;

mod error;

pub mod mathematics;

mod lanes;

mod chunks;

mod buffer;

mod light;

mod rotation;

mod turn;

mod window;

mod material;

mod normal;

mod polynomial;

mod parts;

mod basis;

mod scattering;

mod projection;

mod transfer;

mod relight;

mod descent;

mod nine_terms;

mod scene;

mod shade;

pub mod fixed;

mod economy;

mod negatives;

mod lookup;

mod paraboloid;

mod bake;

pub mod quantised;

mod bake_integer;

mod general;

mod estimate;

pub mod wire;

#[cfg(feature = "defmt")]
mod logged;

#[cfg(feature = "mint")]
mod mint;

#[cfg(feature = "baked")]
pub mod sphere;

#[cfg(feature = "generate")]
pub mod generated;

pub use bake::{BakedMap, MapBuffer};
pub use bake_integer::IntegerMap;
pub use basis::Basis;
pub use economy::{Economy, Shape, Tolerance};
pub use error::{Error, What};
pub use estimate::Estimate;
pub use format::{Fixed, Format, Q15, Q31, Wide};
pub use general::{GeneralBasis, GeneralParts};
pub use index::effect::{Effect, Effects};
pub use light::Light;
pub use lookup::{Lookup, LookupBuffer};
pub use material::Material;
pub use negatives::Negatives;
pub use nine_terms::NineTerms;
pub use normal::{Normal, Normals};
pub use paraboloid::MapPoint;
pub use parts::{Coupling, Parts, Pass, ProfilePlace, Recurrences, Row};
pub use projection::Coefficients;
pub use rotation::Rotation;
pub use scalar::Scalar;
pub use scene::{Scene, SceneBuffer};
pub use transfer::Transfer;
pub use turn::LightBuffer;
pub use window::Window;

// Runs the README's example as a test.
#[cfg(all(doctest, feature = "baked"))]
#[doc = include_str!("../README.md")]
struct Readme;
