//! The posterior mean of d, given the database's statistics and the noise.
//!
//! The image is s (m + E δ) + noise, where s is its exposure and δ has the second moment V_d = F
//! Fᵀ. Let δ = F a, where a has unit second moment. The posterior mean of a is Σ_k v_k g σ_k z_k /
//! (g² σ_k² + noise²) over the singular values σ_k of √W E F, with g = s. This needs no inverse of
//! V_d, which is singular beyond the rank.

use super::linear::decompose;
use super::observation::Observation;
use super::prior::Prior;
use eigenshade_model::error::Result;
use faer::linalg::solvers::Svd;
use faer::{Col, Mat};

/// The smallest noise of a pixel, relative to the image's root mean square.
const ROUNDING: f64 = 1e-16;

/// Computes posteriors of an observation's channels under one prior.
#[derive(Debug)]
pub struct Posterior<'a> {
    observation: &'a Observation,
    prior: &'a Prior,
    svd: Svd<f64>,
}

/// The posterior of one channel.
#[derive(Clone, Debug, PartialEq)]
pub struct Estimate {
    /// The posterior mean of d.
    pub d: Vec<f64>,
    /// The posterior standard deviation of each component of d.
    pub deviations: Vec<f64>,
    /// The exposure s that was used.
    pub exposure: f64,
    /// The coordinates a with respect to F, times s: d = s F a + (s - 1) d_m.
    pub coordinates: Vec<f64>,
}

impl<'a> Posterior<'a> {
    /// Decomposes √W E F.
    ///
    /// # Errors
    ///
    /// If the singular values do not converge.
    pub fn new(observation: &'a Observation, prior: &'a Prior) -> Result<Self> {
        let svd = decompose(&(&observation.design * &prior.factor))?;
        Ok(Self { observation, prior, svd })
    }

    /// The noise of everything outside the components, as the standard deviation of a pixel of
    /// weight 1. If a noise is stated, it is combined with the part of the database's images that
    /// the components omit, at this image's exposure. Otherwise the noise is that of the residual,
    /// or the omitted part if that is larger. It is at least 1e-16 of the image's root mean square,
    /// since no pixel is more accurate than its rounding.
    #[must_use]
    pub fn noise(&self, channel: usize, stated: Option<f64>, of_residual: f64) -> f64 {
        let floor = self.exposure(channel, stated.unwrap_or(of_residual)) * self.prior.left.sqrt();
        let noise = stated.map_or(of_residual.max(floor), |stated| stated.hypot(floor));
        let energy = self.observation.channel(channel).squared_norm_l2();
        noise.max(ROUNDING * (energy / self.observation.weight).sqrt())
    }

    /// The exposure of a channel: s² scales the database's mean energy at these pixels to the
    /// energy of the image minus that of the noise.
    ///
    /// 0 if the image is no more than noise, or if the database's images are black at all of these
    /// pixels.
    #[must_use]
    pub fn exposure(&self, channel: usize, noise: f64) -> f64 {
        let observation = self.observation;
        let found = observation.channel(channel).squared_norm_l2();
        let of_noise = observation.pixels as f64 * noise * noise;
        let spread: f64 = self.svd.S().column_vector().iter().rev().map(|s| s * s).sum();
        let expected = spread + observation.mean.squared_norm_l2();
        if expected > 0.0 { ((found - of_noise).max(0.0) / expected).sqrt() } else { 0.0 }
    }

    /// The posterior of a channel whose pixels of weight 1 have noise of this standard deviation,
    /// in units of the image.
    #[must_use]
    pub fn estimate(&self, channel: usize, noise: f64) -> Estimate {
        let exposure = self.exposure(channel, noise);
        let prior = self.prior;
        let target = self.observation.channel(channel) - exposure * &self.observation.mean;
        let along = self.svd.U().transpose() * target;
        let singular = self.svd.S().column_vector();
        let shrunk = Col::from_fn(along.nrows(), |k| {
            let spread = exposure * singular[k];
            match spread * spread + noise * noise {
                total if total > 0.0 => spread * along[k] / total,
                _ => 0.0,
            }
        });
        let coordinates = self.svd.V() * shrunk;
        let of_prior = &prior.factor * &coordinates;
        let d = of_prior
            .iter()
            .zip(&prior.mean)
            .map(|(value, mean)| exposure * value + (exposure - 1.0) * mean)
            .collect();
        Estimate {
            d,
            deviations: self.deviations(exposure, noise),
            exposure,
            coordinates: coordinates.iter().copied().collect(),
        }
    }

    /// Square roots of the diagonal of s² F (1 + s² (√W E F)ᵀ(√W E F) / noise²)⁻¹ Fᵀ. It is s²
    /// times Σ_k (F v_k)² noise² / (s² σ_k² + noise²), plus the squares of the rows of F orthogonal
    /// to all v_k, which exist if there are fewer pixels than columns of F. These are sums of
    /// squares, so values that the pixels fix to many digits are not computed as differences from
    /// the prior.
    fn deviations(&self, exposure: f64, noise: f64) -> Vec<f64> {
        let factor = &self.prior.factor;
        let singular = self.svd.S().column_vector();
        let seen: Mat<f64> = factor * self.svd.V();
        let is_whole = self.svd.V().ncols() == self.svd.V().nrows();
        let unseen = (!is_whole).then(|| factor - &seen * self.svd.V().transpose());
        let shares: Vec<f64> = singular
            .iter()
            .map(|value| match (exposure * value).hypot(noise) {
                total if total > 0.0 => noise / total,
                _ => 1.0,
            })
            .collect();
        (0..factor.nrows())
            .map(|i| {
                let along = seen.row(i).iter().zip(&shares).map(|(value, share)| value * share);
                let rest = unseen.as_ref().map_or(0.0, |unseen| unseen.row(i).squared_norm_l2());
                exposure * (along.map(|value| value * value).sum::<f64>() + rest).sqrt()
            })
            .collect()
    }
}
