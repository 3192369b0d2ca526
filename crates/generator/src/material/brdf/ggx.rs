//! The glTF metallic-roughness material: a GGX lobe over a matte base.

use crate::material::brdf::lambertian::share;
use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::PI;

/// f = (1 - F) albedo / π + F D V, with α = roughness² and h the half-way direction:
///
/// * F = f0 + (1 - f0)(1 - cos θ_d)^5, Schlick's Fresnel term;
/// * D = α² / π(sin² θ_h + α² cos² θ_h)², the distribution of Trowbridge and Reitz;
/// * V = 1/2 / (cos θ_i √(α² + (1 - α²) cos² θ_r) + the same with i and r exchanged), Smith's
///   height-correlated masking and shadowing divided by 4 cos θ_i cos θ_r.
///
/// This is the BRDF of Appendix B of the glTF 2.0 specification, with V in the height-correlated
/// form of its sample renderer. A dielectric has f0 = 0.04 and the base color as albedo; a metal
/// has the base color as f0 and no albedo. f grows without bound where both directions graze the
/// surface, as 1 / (cos θ_i + cos θ_r).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ggx {
    alpha: f64,
    f0: f64,
    albedo: f64,
}

/// The smallest roughness that is accepted: its lobe is 1e-3 rad wide.
const SMOOTHEST: f64 = 0.03;

impl Ggx {
    /// From the roughness, the reflectance `f0` at normal incidence, and the albedo of the matte
    /// base.
    ///
    /// # Errors
    ///
    /// If the roughness is outside \[0.03, 1\], or `f0` or the albedo is outside \[0, 1\].
    pub fn new(roughness: f64, f0: f64, albedo: f64) -> Result<Self> {
        if !(SMOOTHEST..=1.0).contains(&roughness) {
            return Err(Error::new(
                format!("roughness = {roughness} is outside [{SMOOTHEST}, 1]"),
                "give the perceptual roughness, of which alpha is the square; a mirror is none",
            ));
        }
        Ok(Self {
            alpha: roughness * roughness,
            f0: share("f0", f0)?,
            albedo: share("albedo", albedo)?,
        })
    }
}

impl Brdf for Ggx {
    fn value(&self, at: Geometry) -> f64 {
        let square = self.alpha * self.alpha;
        let fresnel = self.f0 + (1.0 - self.f0) * (1.0 - at.difference_cosine()).powi(5);
        let (cosine, sine) = at.half_squared();
        let spread = sine + square * cosine;
        let distribution = square / (PI * spread * spread);
        let masked = |one: f64, other: f64| one * (square + (1.0 - square) * other * other).sqrt();
        let visibility =
            0.5 / (masked(at.incident, at.reflected) + masked(at.reflected, at.incident));
        (1.0 - fresnel) * self.albedo / PI + fresnel * distribution * visibility
    }

    fn width(&self) -> f64 {
        self.alpha
    }
}
