//! The whole path from light to pixel in fixed point, for machines without a float unit.
//!
//! The mathematics is the same as in floating point: a [`Basis`] computes the transfer of a
//! [`Material`] ([`Basis::transfer`]), relights it with each new [`Light`] ([`Basis::relight`]) and
//! sums the components of each azimuth ([`Basis::collapse`]). The resulting [`Scene`] gives the
//! irradiance of a [`Normal`]. A number is a mantissa times 2^exponent; the numbers of an array
//! share exponents, and every result has its own.
//!
//! No result wraps. The tables are scaled so that no sum over them can overflow its accumulator, and
//! [`Basis::new`] checks this when it is compiled. Numbers that depend on light and material are
//! scaled to their size, and values that cannot be represented saturate. Transfers made by hand are
//! checked; coefficients may have any value. The sizes that a profile states are trusted: if they
//! are too small, a pixel is wrong, but nothing panics. Results are the same bits everywhere.
//!
//! Maps are baked, and lights windowed, in floating point, on the host or on a machine with a float
//! unit. A [`BakedMap`] is looked up, and a light is turned, in integers.
//!
//! ```
//! # #[cfg(feature = "baked")]
//! # fn main() -> Result<(), eigenshade::Error> {
//! use eigenshade::q15::{Light, Material, Normal, Q15};
//! use eigenshade::sphere::q15;
//!
//! // Mantissas times 2^exponent: b_00^0 = 2, a white matte; light 3.5, 0, 1, 0.
//! let matte = Material::new(&[-13], &[Q15(16_384)])?;
//! let light = Light::new(-12, &[Q15(14_336), Q15(0), Q15(4_096), Q15(0)])?;
//! let transfer = q15::transfer(&matte)?;
//! let scene = q15::collapse(&q15::relight(&transfer.view(), &light)?);
//! let normal = Normal::from_unit(Q15(0), Q15(19_661), Q15(26_214))?; // (0, 0.6, 0.8)
//! let mantissa = scene.shade(normal); // times 2^scene.exponent()
//! let irradiance = f64::from(mantissa) * f64::from(scene.exponent()).exp2();
//! assert!((irradiance - 1.249).abs() < 0.01, "{irradiance}");
//! # Ok(())
//! # }
//! # #[cfg(not(feature = "baked"))]
//! # fn main() {}
//! ```

mod about_view;
mod arithmetic;
mod baked_map;
mod basis;
mod collapse;
mod estimate;
mod exposure;
mod highlights;
mod inputs;
mod map_point;
mod mirrored;
mod nine_terms;
mod normal;
mod relight;
mod rotation;
mod scene;
mod table;
mod tabulated;
mod transfer;
mod turn;

/// The items that `integer_table!` names, in files of the steps. Its kernels compute the same bits as
/// the methods of a [`Basis`] and a [`Scene`], with constants for all sizes and positions.
#[doc(hidden)]
pub mod kernels {
    pub use super::collapse::{Shifts, Size, azimuths, collapse_azimuth, finish, mantissas};
    pub use super::mirrored::Mirrored;
    pub use super::relight::{
        NONE, align, coefficients, common, exponent, inputs, relight_azimuth,
    };
    pub use super::scene::{Pixel, blank_scene, terms, terms_mut};
    pub use super::transfer::{
        Degree, Orders, accept_material, transfer_azimuth, transfer_numbers, weighted_coefficients,
    };
}

pub use crate::index::record::Q15;
pub use baked_map::BakedMap;
pub use basis::{Basis, Parts, Profile};
pub use estimate::Estimate;
pub use exposure::Exposure;
pub use highlights::{Highlights, Irradiance, Lobe};
pub use inputs::{Light, Material, MaterialBuffer};
#[cfg(feature = "presets")]
pub(crate) use inputs::{mantissas, quantized_light};
pub use map_point::MapPoint;
pub use nine_terms::NineTerms;
pub use normal::Normal;
pub use relight::Coefficients;
pub use rotation::Rotation;
pub use scene::Scene;
pub use transfer::{Transfer, TransferBuffer};
pub use turn::LightBuffer;
