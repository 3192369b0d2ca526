//! BRDFs as functions: isotropic, reciprocal, one color channel each.
//!
//! An isotropic BRDF that is even in Δφ depends on only three cosines: those of θ_i, of θ_r and of
//! the angle between the two directions; see [`Geometry`].

mod formulas;
mod geometry;
mod overlaps;
pub mod projection;

pub use formulas::{Abc, Ggx, Lambertian, OrenNayar};
pub use geometry::{Brdf, Geometry};
pub use projection::{Measure, Projected, Surface};
