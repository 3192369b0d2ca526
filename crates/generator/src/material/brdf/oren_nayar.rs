//! Rough matte surfaces: M. Oren and S. K. Nayar, "Generalization of Lambert's Reflectance Model",
//! SIGGRAPH 1994. This is the qualitative model at the end of the paper, which leaves out the
//! interreflection between facets. Renderers use the name for this model.

use crate::material::brdf::lambertian::share;
use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::{FRAC_PI_2, PI};

/// f = (albedo / π)(A + B max(0, cos Δφ) sin α tan β), where α is the larger of θ_i and θ_r, β is
/// the smaller, A = 1 - σ² / 2(σ² + 0.33) and B = 0.45 σ² / (σ² + 0.09).
///
/// f grows as 1 / cos β without bound where both directions graze the surface on the same side. The
/// reflected light stays finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrenNayar {
    albedo: f64,
    flat: f64,
    rough: f64,
}

impl OrenNayar {
    /// From the albedo and the standard deviation σ of the facets' slope angle in radians; σ = 0 is
    /// Lambertian.
    ///
    /// # Errors
    ///
    /// If the albedo is outside \[0, 1\] or σ is outside \[0, π/2\].
    pub fn new(albedo: f64, sigma: f64) -> Result<Self> {
        if !(0.0..=FRAC_PI_2).contains(&sigma) {
            return Err(Error::new(
                format!("sigma = {sigma} is outside [0, pi/2]"),
                "give the deviation of the facets' angle in radians",
            ));
        }
        let square = sigma * sigma;
        Ok(Self {
            albedo: share("albedo", albedo)?,
            flat: 1.0 - 0.5 * square / (square + 0.33),
            rough: 0.45 * square / (square + 0.09),
        })
    }
}

impl Brdf for OrenNayar {
    fn value(&self, at: Geometry) -> f64 {
        let (flatter, steeper) = (at.incident.min(at.reflected), at.incident.max(at.reflected));
        let sine = |cosine: f64| (1.0 - cosine * cosine).max(0.0).sqrt();
        let lobe = at.azimuth_cosine().max(0.0) * sine(flatter) * sine(steeper) / steeper;
        self.albedo / PI * (self.flat + self.rough * lobe)
    }

    fn width(&self) -> f64 {
        0.5
    }
}
