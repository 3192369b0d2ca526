//! BRDFs as functions: isotropic, reciprocal, one colour channel each.
//!
//! An isotropic BRDF that is even in Δφ depends on three cosines alone, those of
//! θ_i, of θ_r and of the angle between the two directions; see [`Geometry`].

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
    /// f in 1/sr. The same if the two directions are exchanged.
    ///
    /// Domain: both directions above the surface, cosines > 0; models may diverge
    /// where both graze it.
    fn value(&self, at: Geometry) -> f64;

    /// The angle, radians, between the surface's normal and the half-way direction
    /// over which f changes by its own size: quadrature is as fine as that about the
    /// mirror direction and at grazing angles. In (0, 1\].
    fn width(&self) -> f64;
}
