//! BRDFs as functions: isotropic, reciprocal, one color channel each.
//!
//! An isotropic BRDF that is even in Δφ depends on only three cosines: those of θ_i, of θ_r and of
//! the angle between the two directions; see [`Geometry`].

mod fitted;
mod formulas;
mod overlaps;
pub mod projection;
mod surface;

pub use fitted::{Abc, Sgd};
pub use formulas::{Ggx, Lambertian, OrenNayar};
pub use projection::Measure;
pub use surface::{Part, Projected, Surface};

/// Cosines of the polar angles of light and view, and of the angle between light and view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Geometry {
    /// cos θ_i, in \[0, 1\].
    pub incident: f64,
    /// cos θ_r, in \[0, 1\].
    pub reflected: f64,
    /// sin θ_i sin θ_r cos Δφ + cos θ_i cos θ_r, in \[-1, 1\].
    pub between: f64,
}

impl Geometry {
    /// From polar angles in \[0, π/2\] and Δφ = φ_i - φ_r, in radians: Δφ = 0 is backscatter, π is
    /// the plane of the mirror direction.
    #[must_use]
    pub fn from_angles(theta_i: f64, theta_r: f64, delta_phi: f64) -> Self {
        Slants::new(theta_i, theta_r).at(delta_phi).0
    }

    /// |i + r|², the square of twice the half-way vector: 2 + 2 times the cosine of the angle
    /// between the directions.
    #[must_use]
    pub fn sum_squared(self) -> f64 {
        (2.0 + 2.0 * self.between).max(0.0)
    }

    /// cos θ_d, for the angle between either direction and the half-way direction.
    #[must_use]
    pub fn difference_cosine(self) -> f64 {
        (0.5 * self.sum_squared().sqrt()).min(1.0)
    }

    /// cos² θ_h and sin² θ_h, for the angle between the normal and the half-way direction; (0, 1)
    /// if the two directions are opposite.
    #[must_use]
    pub fn half_squared(self) -> (f64, f64) {
        let (sum, up) = (self.sum_squared(), self.incident + self.reflected);
        if sum <= 0.0 {
            return (0.0, 1.0);
        }
        let cosine = (up * up / sum).min(1.0);
        (cosine, ((sum - up * up) / sum).max(0.0))
    }

    /// cos Δφ; 1 where a direction coincides with the normal and Δφ is undefined.
    #[must_use]
    pub fn azimuth_cosine(self) -> f64 {
        let sines = ((1.0 - self.incident * self.incident)
            * (1.0 - self.reflected * self.reflected))
            .max(0.0)
            .sqrt();
        if sines <= 0.0 {
            return 1.0;
        }
        ((self.between - self.incident * self.reflected) / sines).clamp(-1.0, 1.0)
    }
}

/// Two polar angles, for several Δφ.
pub(super) struct Slants {
    cosines: [f64; 2],
    /// cos (θ_i + θ_r).
    opposite: f64,
    /// sin θ_i sin θ_r.
    sines: f64,
}

impl Slants {
    pub(super) fn new(theta_i: f64, theta_r: f64) -> Self {
        let ((sin_i, cos_i), (sin_r, cos_r)) = (theta_i.sin_cos(), theta_r.sin_cos());
        let sines = sin_i * sin_r;
        Self { cosines: [cos_i.max(0.0), cos_r.max(0.0)], opposite: cos_i * cos_r - sines, sines }
    }

    /// See [`Geometry::from_angles`]; and cos Δφ.
    pub(super) fn at(&self, delta_phi: f64) -> (Geometry, f64) {
        // cos Δφ = 2 cos²(Δφ/2) - 1 keeps precision where the directions have opposite azimuths.
        let half = (0.5 * delta_phi).cos();
        let [incident, reflected] = self.cosines;
        let twice = 2.0 * half * half;
        let between = self.opposite + self.sines * twice;
        (Geometry { incident, reflected, between }, twice - 1.0)
    }
}

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

    /// Whether f is known to have no kinks, so that panels as wide as [`width`](Self::width) need
    /// fewer nodes. Most models have kinks, where a minimum changes from one term to another or a
    /// term ends.
    fn is_smooth(&self) -> bool {
        false
    }
}
