//! BRDFs as functions: isotropic, reciprocal, one color channel each.
//!
//! An isotropic BRDF that is even in Δφ depends on only three cosines: those of θ_i, of θ_r and of
//! the angle between the two directions; see [`Geometry`].

mod abc;
mod geometry;
mod ggx;
mod lambertian;
mod merl;
mod oren_nayar;
mod overlaps;
pub mod projection;
mod surface;

pub use abc::Abc;
pub use geometry::Geometry;
pub use ggx::Ggx;
pub use lambertian::Lambertian;
pub use merl::{BINS, Merl};
pub use oren_nayar::OrenNayar;
pub use projection::Measure;
pub use surface::{Projected, Surface};

/// One channel of an isotropic, reciprocal BRDF.
pub trait Brdf: Send + Sync {
    /// f in 1/sr, symmetric under exchange of the two directions.
    ///
    /// Domain: both directions above the surface, cosines > 0. Models may diverge where both
    /// directions graze it.
    fn value(&self, at: Geometry) -> f64;

    /// The change of angle between the normal and the half-way direction, in radians, over which f
    /// changes by its own size. Quadrature is this fine around the mirror direction and at grazing
    /// angles. In (0, 1\].
    fn width(&self) -> f64;
}
