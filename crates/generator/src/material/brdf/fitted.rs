//! Two models that were made to be fitted to measured BRDFs. Both have a matte part and a lobe
//! whose tail is wider than that of GGX.

use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::error::{Error, Result};
use std::f64::consts::PI;

/// Lobes are integrated as if they were at least this wide, in radians. Sharper ones are far beyond
/// any order.
const SHARPEST: f64 = 1e-3;

/// exp(-x) of anything larger is zero, exp(x) too large.
const DARK: f64 = 700.0;

/// The ABC model, for fits to measured BRDFs, in its microfacet form: J. Low, J. Kronander, A.
/// Ynnerman and J. Unger, "BRDF Models for Accurate and Efficient Rendering of Glossy Surfaces",
/// ACM Transactions on Graphics 31, 2012.
///
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
                format!(
                    "k = {matte}, a = {a}, b = {b}, c = {c}, n = {index} are no valid ABC material"
                ),
                "give k, a, b and c of 0 or more, and an index of 1 or more",
            ));
        }
        Ok(Self { matte, a, b, c, index })
    }

    /// What three channels have in common if they differ in k and a only: a BRDF f, and k / π and a
    /// of each, which is k / π + a f.
    #[must_use]
    pub fn lobe(channels: &[Self; 3]) -> Option<(Self, [[f64; 2]; 3])> {
        let lobe = Self { matte: 0.0, a: 1.0, ..channels[0] };
        let is_same = |channel: &Self| Self { matte: 0.0, a: 1.0, ..*channel } == lobe;
        let shares = channels.map(|channel| [channel.matte / PI, channel.a]);
        channels.iter().all(is_same).then_some((lobe, shares))
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
        // 1 - cos θ_h without cancellation; exp(-c ln x) takes half the time of a power.
        let lobe = self.a * (-self.c * (1.0 + self.b * sine / (1.0 + half)).ln()).exp();
        let product = at.incident * at.reflected;
        // G divided by the product of the cosines.
        let grazing = 2.0 * half / (difference * at.incident.max(at.reflected));
        let shadowed = product.recip().min(grazing);
        (self.matte + self.fresnel(difference) * lobe * shadowed) / PI
    }

    /// The angle at which the lobe has fallen to about 1/e: √(2 / (b c)).
    fn width(&self) -> f64 {
        (2.0 / (self.b * self.c)).sqrt().clamp(SHARPEST, 1.0)
    }
}

/// The shifted gamma distribution: M. Bagher, C. Soler and N. Holzschuch, "Accurate fitting of
/// measured reflectances using a Shifted Gamma micro-facet distribution", Computer Graphics Forum
/// 31 (EGSR 2012).
///
/// f = (ρ_d + ρ_s F(cos θ_d) D G(θ_i) G(θ_r) / (cos θ_i cos θ_r)) / π for one channel, with
///
/// * D = κ exp(-u) / (π u^p cos⁴ θ_h), u = α + tan² θ_h / α;
/// * F(x) = f0 - f1 x + (1 - f0)(1 - x)^5;
/// * G(θ) = 1 + λ(1 - exp(c max(0, θ - θ_0)^k)), limited to \[0, 1\].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sgd {
    /// ρ_d.
    pub matte: f64,
    /// ρ_s.
    pub glossy: f64,
    /// α, the width of the lobe.
    pub alpha: f64,
    /// p, the decay of its tail.
    pub power: f64,
    /// f0 and f1.
    pub fresnel: [f64; 2],
    /// κ, the scale of D.
    pub scale: f64,
    /// λ, c, k and θ_0 in radians.
    pub shadowing: [f64; 4],
}

impl Sgd {
    /// Checks the parameters.
    ///
    /// # Errors
    ///
    /// If a number is not finite, ρ_d, ρ_s, κ, λ or c is below 0, or α or k is not above 0.
    pub fn checked(self) -> Result<Self> {
        let Self { matte, glossy, alpha, power, fresnel: [f0, f1], scale, shadowing } = self;
        let [lambda, c, k, theta] = shadowing;
        let is_finite = [power, f0, f1, theta].into_iter().all(f64::is_finite);
        let is_share = |value: f64| (0.0..f64::INFINITY).contains(&value);
        let are_shares = [matte, glossy, scale, lambda, c, alpha, k].into_iter().all(is_share);
        if is_finite && are_shares && alpha > 0.0 && k > 0.0 {
            return Ok(self);
        }
        Err(Error::new(
            format!("{self:?} is no valid SGD material"),
            "give finite numbers, with rho, kappa, lambda and c of 0 or more, alpha and k above 0",
        ))
    }

    fn shadowed(&self, cosine: f64) -> f64 {
        let [lambda, c, k, theta] = self.shadowing;
        let beyond = (cosine.acos() - theta).max(0.0);
        // At most 1, since λ and c are not negative.
        (1.0 - lambda * (c * beyond.powf(k)).min(DARK).exp_m1()).max(0.0)
    }
}

impl Brdf for Sgd {
    fn value(&self, at: Geometry) -> f64 {
        let [f0, f1] = self.fresnel;
        let (square, sine) = at.half_squared();
        let u = self.alpha + sine / (square * self.alpha);
        let fourth = square * square;
        let is_lit = u < DARK && fourth > 0.0;
        let lobe = (-u).exp() / (PI * u.powf(self.power) * fourth);
        let lobe = if is_lit { self.scale * lobe } else { 0.0 };
        let x = at.difference_cosine();
        let fresnel = f0 - f1 * x + (1.0 - f0) * (1.0 - x).powi(5);
        let shadow = self.shadowed(at.incident) * self.shadowed(at.reflected);
        let product = at.incident * at.reflected;
        (self.matte + self.glossy * fresnel * lobe * shadow / product) / PI
    }

    fn width(&self) -> f64 {
        self.alpha.clamp(SHARPEST, 1.0)
    }
}
