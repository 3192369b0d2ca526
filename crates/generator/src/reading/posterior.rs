//! The posterior mean of d under the database's statistics and a stated noise.
//!
//! The image is s (m + E δ) + noise: s its exposure, δ of second moment V_d = F Fᵀ.
//! With δ = F a and a of unit second moment, a has the posterior mean
//! Σ_k v_k g σ_k z_k / (g² σ_k² + noise²) over the singular values σ_k of √W E F,
//! g = s: no inverse of V_d, which is singular where the rank ends.

use super::coefficients::decompose;
use super::observation::Observation;
use super::prior::Prior;
use eigenshade_model::error::Result;
use faer::linalg::solvers::Svd;
use faer::{Col, Mat};

/// The least noise of a pixel, of the image's rms.
const ROUNDING: f64 = 1e-16;

/// The posterior of one image or more under one prior.
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
    /// The posterior standard deviation of each.
    pub deviations: Vec<f64>,
    /// The exposure s that was taken.
    pub exposure: f64,
    /// F⁺-coordinates a, times s: d = s F a + (s - 1) d_m.
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

    /// The noise that stands for all that is not in the components, the standard
    /// deviation of a pixel of weight 1: the stated noise and what the components
    /// leave of the database's images at this image's exposure; or, where none is
    /// stated, the residual's own if that is larger than what they leave. At least
    /// 1e-16 of the image's rms: no pixel is better than its rounding.
    #[must_use]
    pub fn noise(&self, channel: usize, stated: Option<f64>, of_residual: f64) -> f64 {
        let floor = self.exposure(channel, stated.unwrap_or(of_residual)) * self.prior.left.sqrt();
        let noise = stated.map_or(of_residual.max(floor), |stated| stated.hypot(floor));
        let energy = self.observation.channel(channel).squared_norm_l2();
        noise.max(ROUNDING * (energy / self.observation.weight).sqrt())
    }

    /// The exposure of a channel: s² is what brings the database's mean energy at
    /// these pixels to that of the image, less the noise's.
    ///
    /// 0 for an image that is no more than noise, and where the database's images are
    /// black at all of these pixels.
    #[must_use]
    pub fn exposure(&self, channel: usize, noise: f64) -> f64 {
        let observation = self.observation;
        let found = observation.channel(channel).squared_norm_l2();
        let of_noise = observation.pixels as f64 * noise * noise;
        let spread: f64 = self.svd.S().column_vector().iter().rev().map(|s| s * s).sum();
        let expected = spread + observation.mean.squared_norm_l2();
        if expected > 0.0 { ((found - of_noise).max(0.0) / expected).sqrt() } else { 0.0 }
    }

    /// The posterior of a channel whose pixels of weight 1 have noise of this
    /// standard deviation, in units of the image.
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

    /// Roots of the diagonal of s² F (1 + s² (√W E F)ᵀ(√W E F) / noise²)⁻¹ Fᵀ: s² times
    /// Σ_k (F v_k)² noise² / (s² σ_k² + noise²), and the squares of the rows of F beside
    /// all v_k, which exist where there are fewer pixels than columns of F. Sums of
    /// squares: what the pixels fix to many digits is no difference from the prior.
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
