//! The ABC model, for fits to measured BRDFs, in its microfacet form: J. Low, J. Kronander, A.
//! Ynnerman and J. Unger, "BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces",
//! ACM Transactions on Graphics 31, 2012.

use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::PI;

/// f = k / π + F(cos θ_d) D G / (π cos θ_i cos θ_r) for one channel, with
///
/// * D = a / (1 + b (1 - cos θ_h))^c;
/// * F, the unpolarized Fresnel reflectance of a dielectric of index n;
/// * G = min(1, 2 cos θ_h cos θ_i / cos θ_d, 2 cos θ_h cos θ_r / cos θ_d).
///
/// f grows without bound where both directions graze the surface, as
/// 1 / max(cos θ_i, cos θ_r).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Abc {
    matte: f64,
    a: f64,
    b: f64,
    c: f64,
    index: f64,
}

impl Abc {
    /// From the matte part k, the lobe parameters a, b and c, and the index of refraction n.
    ///
    /// # Errors
    ///
    /// If a number is not finite, k, a, b or c is below 0, or n is below 1.
    pub fn new(matte: f64, [a, b, c]: [f64; 3], index: f64) -> Result<Self> {
        let is_share = |value: &f64| (0.0..f64::INFINITY).contains(value);
        if ![matte, a, b, c].iter().all(is_share) || !(1.0..f64::INFINITY).contains(&index) {
            return Err(Error::new(
                format!("k = {matte}, a = {a}, b = {b}, c = {c}, n = {index} are no ABC material"),
                "give k, a, b and c of 0 or more, and an index of 1 or more",
            ));
        }
        Ok(Self { matte, a, b, c, index })
    }

    fn fresnel(&self, cosine: f64) -> f64 {
        let g = (self.index * self.index - 1.0 + cosine * cosine).sqrt();
        let (across, along) = ((g - cosine) / (g + cosine), cosine * (g + cosine) - 1.0);
        let along = along / (cosine * (g - cosine) + 1.0);
        0.5 * across * across * (1.0 + along * along)
    }
}

impl Brdf for Abc {
    fn value(&self, at: Geometry) -> f64 {
        let (square, sine) = at.half_squared();
        let (half, difference) = (square.sqrt(), at.difference_cosine());
        // 1 - cos θ_h without cancellation.
        let lobe = self.a / (1.0 + self.b * sine / (1.0 + half)).powf(self.c);
        let product = at.incident * at.reflected;
        // G divided by the product of the cosines.
        let grazing = 2.0 * half / (difference * at.incident.max(at.reflected));
        let shadowed = product.recip().min(grazing);
        (self.matte + self.fresnel(difference) * lobe * shadowed) / PI
    }

    /// The angle at which the lobe has fallen to about 1/e: √(2 / (b c)).
    fn width(&self) -> f64 {
        (2.0 / (self.b * self.c)).sqrt().clamp(1e-3, 1.0)
    }
}
