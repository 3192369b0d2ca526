//! BRDFs given by formulas, from matte to glossy.

use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::{FRAC_PI_2, PI};

/// The perfectly matte material: f = albedo / π. Its only coefficient is b_00^0 = 2 albedo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lambertian {
    albedo: f64,
}

impl Lambertian {
    /// From the albedo, the fraction of light that is reflected.
    ///
    /// # Errors
    ///
    /// If the albedo is outside \[0, 1\].
    pub fn new(albedo: f64) -> Result<Self> {
        Ok(Self { albedo: share("albedo", albedo)? })
    }
}

impl Brdf for Lambertian {
    fn value(&self, _: Geometry) -> f64 {
        self.albedo / PI
    }

    fn width(&self) -> f64 {
        1.0
    }
}

/// Rough matte surfaces: M. Oren and S. K. Nayar, "Generalization of Lambert's Reflectance Model",
/// SIGGRAPH 1994. This is the qualitative model at the end of the paper, which leaves out the
/// interreflection between facets. Renderers use the name for this model.
///
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

/// The glTF metallic-roughness material: a GGX lobe over a matte base.
///
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
                "give the perceptual roughness, alpha is its square; mirrors are not supported",
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
        // sin² θ_h and cos² θ_h times |i + r|², so that D V takes one division.
        let (sum, up) = (at.sum_squared(), at.incident + at.reflected);
        let spread = (sum - up * up).max(0.0) + square * up * up;
        let masked = |one: f64, other: f64| one * (square + (1.0 - square) * other * other).sqrt();
        let masking = masked(at.incident, at.reflected) + masked(at.reflected, at.incident);
        let lobe = 0.5 * square * sum * sum / (PI * spread * spread * masking);
        (1.0 - fresnel) * self.albedo / PI + fresnel * lobe
    }

    fn width(&self) -> f64 {
        self.alpha
    }

    fn is_smooth(&self) -> bool {
        true
    }
}

/// Checks that a number is in \[0, 1\].
fn share(what: &str, value: f64) -> Result<f64> {
    if (0.0..=1.0).contains(&value) {
        return Ok(value);
    }
    Err(Error::new(format!("{what} = {value} is outside [0, 1]"), "give a number from 0 to 1"))
}
