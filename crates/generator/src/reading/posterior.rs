//! The database's prior of d and of the light, and the posterior mean of d, given that prior and
//! the noise.
//!
//! By (28) and (33) the components of U are uncorrelated over the database, with the eigenvalues as
//! variances. The constant of image-centered PCA is an exception: its coefficient, the mean of an
//! image, has E{d_0²} = eᵀ V_c e. It is correlated with the other components of m = 0, because
//! bright images have stronger shading. So the full second moments V_d = Uᵀ M V_c M U are used (Σ_c
//! for the standard criterion), stored as a factor like the others: V_d = F Fᵀ.
//!
//! The image is s (m + E δ) + noise, where s is its exposure and δ has the second moment V_d. Let
//! δ = F a, where a has unit second moment. The posterior mean of a is Σ_k v_k g σ_k z_k /
//! (g² σ_k² + noise²) over the singular values σ_k of √W E F, with g = s. This needs no inverse of
//! V_d, which is singular beyond the rank.

use super::linear::{Reduction, decompose};
use super::observation::Observation;
use super::transfer::Transfers;
use crate::basis::moments::{LightMoments, MaterialMoments};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, light};
use faer::linalg::solvers::Svd;
use faer::{Col, ColRef, Mat};

/// Columns of F shorter than this fraction of the longest are rounding.
const PRIOR_ROUNDING: f64 = 1e-13;

/// The statistics of d at exposure 1, which is that of the database's own light.
#[derive(Clone, Debug)]
pub struct Prior {
    /// F, with one row for each component and columns of falling length.
    pub factor: Mat<f64>,
    /// d of the table's mean image; zeros if it has none.
    pub mean: Vec<f64>,
    /// Mean energy of the database's images outside the components.
    pub left: f64,
    /// Whether deviations are from zero or from the mean.
    pub criterion: Criterion,
    /// The moments of the light.
    pub light: LightPrior,
    /// The materials' luminance coefficients and their weights.
    pub materials: MaterialMoments,
}

impl Prior {
    /// The prior for these materials under light with these moments.
    ///
    /// # Errors
    ///
    /// If there are no materials or a number is not finite.
    pub fn new(
        table: &Table,
        transfers: &Transfers,
        light: &LightMoments,
        materials: MaterialMoments,
    ) -> Result<Self> {
        if materials.vectors.is_empty() {
            return Err(Error::new("no materials", "give a material database with at least one"));
        }
        let (components, criterion) = (transfers.components(), table.scene.basis.criterion);
        let light = LightPrior::new(light, transfers.degree());
        let mean_transfer = transfers.of(&materials.mean);
        let mut reduction = Reduction::new(components);
        let mut push = |d: ColRef<'_, f64>, share: f64| {
            let row: Vec<f64> = d.iter().map(|d| share * d).collect();
            reduction.push(&row);
        };
        for (vector, share) in materials.rooted() {
            let transfer = transfers.of(vector);
            (&transfer * light.vectors(criterion)).col_iter().for_each(|d| push(d, share));
            if criterion == Criterion::Standard {
                push(((transfer - &mean_transfer) * &light.mean).as_ref(), share);
            }
        }
        let svd = decompose(&reduction.finish())?;
        let singular = svd.S().column_vector();
        let factor =
            Mat::from_fn(components, singular.nrows(), |i, j| svd.V()[(i, j)] * singular[j]);
        let mean = table.mean.as_ref();
        let mut mean = mean.map_or_else(Vec::new, |mean| mean.coefficients.clone());
        mean.resize(components, 0.0);
        let left = table.energy_left(components);
        Ok(Self { factor, mean, left, criterion, light, materials })
    }

    /// Whether all images are black. Then none resembles an image that contains light, and no
    /// exposure can change that.
    #[must_use]
    pub fn is_black(&self) -> bool {
        let is_zero = |values: &Vec<f64>| values.iter().all(|value| *value == 0.0);
        let no_images = self.factor.norm_max() == 0.0 && is_zero(&self.mean);
        no_images || self.materials.vectors.iter().all(is_zero)
    }

    /// x with V_d x = F a: F divided by its squared column lengths, times a, with columns below
    /// rounding left out.
    #[must_use]
    pub fn dual(&self, coordinates: &[f64]) -> Col<f64> {
        let squares: Vec<f64> = self.factor.col_iter().map(|f| f.squared_norm_l2()).collect();
        let largest = squares.first().copied().unwrap_or(0.0);
        let scaled = Col::from_fn(squares.len(), |k| {
            if squares[k] > PRIOR_ROUNDING * PRIOR_ROUNDING * largest {
                coordinates[k] / squares[k]
            } else {
                0.0
            }
        });
        &self.factor * scaled
    }

    /// V_d.
    #[must_use]
    pub fn second_moment(&self) -> Mat<f64> {
        &self.factor * self.factor.transpose()
    }
}

/// The moments of the light, with one row for each coefficient L_l^m, in the order of
/// [`eigenshade_table::light`].
#[derive(Clone, Debug)]
pub struct LightPrior {
    /// E{L}.
    pub mean: Col<f64>,
    /// V with E{LLᵀ} = V Vᵀ.
    pub second: Mat<f64>,
    /// V such that V Vᵀ is the covariance of L.
    pub centered: Mat<f64>,
}

impl LightPrior {
    /// The prior of light that turns freely, (37)-(39), to `degree`; beyond that of the moments, the
    /// coefficients are zero.
    #[must_use]
    pub fn new(moments: &LightMoments, degree: usize) -> Self {
        let root = |(l, _): (usize, isize)| moments.power.get(l).map_or(0.0, |power| power.sqrt());
        let roots: Vec<f64> = light::indices(degree).map(root).collect();
        let count = roots.len();
        let diagonal = |ambient: f64| {
            Mat::from_fn(count, count, |place, t| match (place, t) {
                (0, 0) => ambient,
                _ if place == t => roots[place],
                _ => 0.0,
            })
        };
        Self {
            mean: Col::from_fn(count, |place| if place == 0 { moments.ambient_mean } else { 0.0 }),
            second: diagonal(roots[0]),
            centered: diagonal(moments.ambient_variance.sqrt()),
        }
    }

    /// The factor that a criterion uses: of E{LLᵀ}, or of the covariance.
    #[must_use]
    pub fn vectors(&self, criterion: Criterion) -> &Mat<f64> {
        match criterion {
            Criterion::ImageCentered => &self.second,
            Criterion::Standard => &self.centered,
        }
    }
}

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
    /// The coordinates a with respect to F: d = s F a + (s - 1) d_m.
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
