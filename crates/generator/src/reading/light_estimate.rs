//! Estimates the light of an image of a known material. The problem is linear: d = T L.
//!
//! The prior of L is s times a light with the database's statistics, where s is the exposure: mean
//! zero and variance (38) for l > 0, and for L_0^0 the mean (39) and its variance. Degrees that the
//! material damps below the noise come out near zero rather than as noise.
//!
//! [`rank`] identifies the database material that an image shows. Each material is fitted with its
//! best light. A material that shapes light in many ways can imitate one that does so in few, so
//! the residual alone would favor glossy materials. Materials are therefore ranked by evidence: the
//! probability of the image given the material, integrated over the prior of the light, which
//! penalizes that freedom. Each material uses its likeliest exposure.

use super::linear::{column, decompose};
use super::observation::Observation;
use super::posterior::Prior;
use super::transfer::Transfers;
use eigenshade_model::database::Materials;
use eigenshade_model::error::Result;
use eigenshade_model::task::checkpoint;
use faer::linalg::solvers::Svd;
use faer::{Col, Mat};

/// Number of exposure steps around the exposure of the image's energy, from 1/100 to 100 times.
const TRIED: i32 = 80;

/// Number of halvings of a step of that grid: to 1e-13 of the exposure, which determines the whole
/// light if the database fixes its mean.
const HALVINGS: i32 = 40;

/// One material, prepared for estimating the light.
#[derive(Debug)]
pub struct LightEstimate<'a> {
    observation: &'a Observation,
    prior: &'a Prior,
    /// √W E T.
    images: Mat<f64>,
    /// √W E T times the mean light.
    mean_image: Col<f64>,
    /// Singular values of √W E T V, where V is the factor of the light's covariance.
    svd: Svd<f64>,
}

/// How well a material explains one channel, and the light that does so best.
#[derive(Clone, Debug, PartialEq)]
pub struct Explained {
    /// The posterior mean of the light, in the order of [`eigenshade_table::light`], as radiance at
    /// the exposure of the image.
    pub light: Vec<f64>,
    /// The exposure s of the light with the largest evidence.
    pub exposure: f64,
    /// Logarithm of the image's probability density given the material, up to a constant that
    /// depends on the noise.
    pub evidence: f64,
    /// Weighted root mean square of the image minus the image of this light.
    pub residual_rms: f64,
}

impl<'a> LightEstimate<'a> {
    /// Prepares the material with this transfer.
    ///
    /// # Errors
    ///
    /// If the singular values do not converge.
    pub fn new(
        observation: &'a Observation,
        prior: &'a Prior,
        transfer: &Mat<f64>,
    ) -> Result<Self> {
        let images = &observation.design * transfer;
        let mean_image = &images * &prior.light.mean;
        let svd = decompose(&(&images * &prior.light.centered))?;
        Ok(Self { observation, prior, images, mean_image, svd })
    }

    /// The target for the light: √W (I - m + E d_m), where d_m are the mean image's components,
    /// which `project` subtracts.
    fn target(&self, channel: usize) -> Col<f64> {
        self.observation.centered(channel) + &self.observation.design * column(&self.prior.mean)
    }

    /// The best light for one channel, given the noise as the standard deviation of a pixel of
    /// weight 1.
    #[must_use]
    pub fn explain(&self, channel: usize, noise: f64) -> Explained {
        let target = self.target(channel);
        let split = Split::new(&self.svd, &self.mean_image, &target);
        let (exposure, evidence) = self.likeliest(&split, noise);
        let singular = self.svd.S().column_vector();
        let shrunk = Col::from_fn(singular.nrows(), |k| {
            let spread = exposure * singular[k];
            let along = split.target[k] - exposure * split.mean[k];
            match spread * spread + noise * noise {
                total if total > 0.0 => exposure * spread * along / total,
                _ => 0.0,
            }
        });
        let prior = &self.prior.light;
        let light = exposure * &prior.mean + &prior.centered * (self.svd.V() * shrunk);
        let left = target - &self.images * &light;
        let light = light.iter().copied().collect();
        let residual_rms = (left.squared_norm_l2() / self.observation.weight).sqrt();
        Explained { light, exposure, evidence, residual_rms }
    }

    /// The exposure of largest evidence, and that evidence: by a grid in steps of a twentieth of a
    /// decade around the exposure of the image's energy, then by halving.
    fn likeliest(&self, split: &Split, noise: f64) -> (f64, f64) {
        let spread: f64 = self.svd.S().column_vector().iter().rev().map(|s| s * s).sum();
        let middle = (split.energy / (spread + self.mean_image.squared_norm_l2())).sqrt();
        if !(middle > 0.0 && middle.is_finite()) {
            // A black material or a black image: no light is better than any other.
            return (0.0, self.evidence(split, 0.0, noise));
        }
        let at = |step: f64| {
            let exposure = middle * 10f64.powf(step / f64::from(TRIED / 4));
            (step, exposure, self.evidence(split, exposure, noise))
        };
        let grid = (-TRIED / 2..=TRIED / 2).map(|step| at(f64::from(step)));
        let later = |a: (f64, f64, f64), b: (f64, f64, f64)| if b.2 > a.2 { b } else { a };
        let mut best = grid.reduce(later).unwrap_or((0.0, middle, 0.0));
        for halving in 1..=HALVINGS {
            let width = 0.5f64.powi(halving);
            let step = best.0;
            best = later(later(best, at(step - width)), at(step + width));
        }
        (best.1, best.2)
    }

    /// log p(I | material, s, noise) without the white noise factor (√2π noise)^-pixels. It is a
    /// sum of squares throughout, because a difference of energies would lose half of the digits of
    /// s.
    fn evidence(&self, split: &Split, exposure: f64, noise: f64) -> f64 {
        let floor = noise * noise;
        if floor <= 0.0 {
            return 0.0;
        }
        let misfit_beside = split.beside[0] - exposure * split.beside[1];
        let (mut misfit, mut freedom) = (misfit_beside * misfit_beside, 0.0);
        for (k, singular) in self.svd.S().column_vector().iter().enumerate() {
            let spread = (exposure * singular).powi(2);
            let along = split.target[k] - exposure * split.mean[k];
            misfit += along * along * floor / (floor + spread);
            freedom += (spread / floor).ln_1p();
        }
        -0.5 * ((split.rest + misfit) / floor + freedom)
    }
}

/// A channel and the mean light's image, decomposed into the parts along the images of the light's
/// deviations and the parts orthogonal to them.
struct Split {
    /// Coordinates along the left singular vectors: of the channel, then of the mean light's image.
    target: Col<f64>,
    mean: Col<f64>,
    /// Orthogonal to them, along the rest of the mean light's image: coordinates of both.
    beside: [f64; 2],
    /// Energy of the part of the channel that is orthogonal to all of these.
    rest: f64,
    /// Energy of the channel.
    energy: f64,
}

impl Split {
    fn new(svd: &Svd<f64>, mean_image: &Col<f64>, channel: &Col<f64>) -> Self {
        let left = svd.U();
        let (target, mean) = (left.transpose() * channel, left.transpose() * mean_image);
        let beside = channel - left * &target;
        let mean_beside = mean_image - left * &mean;
        let length = mean_beside.norm_l2();
        let direction = if length > 0.0 { mean_beside / length } else { mean_beside };
        let along = direction.transpose() * &beside;
        let rest = (beside - along * direction).squared_norm_l2();
        Self { target, mean, beside: [along, length], rest, energy: channel.squared_norm_l2() }
    }
}

/// A database material as an explanation of an image.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Index in the database.
    pub index: usize,
    /// The light and the fit of each channel.
    pub channels: Vec<Explained>,
    /// Sum of the channels' evidence.
    pub evidence: f64,
}

/// All materials, likeliest first. Ties keep the database order.
///
/// `noise` gives the standard deviation of a pixel of weight 1 in each channel. Three channels are
/// r, g and b; with any other number, each channel counts as luminance.
///
/// # Errors
///
/// If the singular values do not converge.
pub fn rank(
    observation: &Observation,
    prior: &Prior,
    transfers: &Transfers,
    materials: &Materials,
    noise: &[f64],
) -> Result<Vec<Candidate>> {
    let mut candidates = Vec::new();
    for (index, material) in materials.entries.iter().enumerate() {
        checkpoint();
        let estimate = |coefficients: &[f64]| {
            LightEstimate::new(observation, prior, &transfers.of(coefficients))
        };
        let each = noise.iter().enumerate();
        let channels: Vec<Explained> = if noise.len() == 3 && !material.is_gray() {
            each.map(|(c, noise)| Ok(estimate(&material.rgb[c])?.explain(c, *noise)))
                .collect::<Result<_>>()?
        } else {
            let estimate = estimate(&material.luminance())?;
            each.map(|(c, noise)| estimate.explain(c, *noise)).collect()
        };
        let evidence = channels.iter().map(|one| one.evidence).sum();
        candidates.push(Candidate { index, channels, evidence });
    }
    candidates.sort_by(|a, b| b.evidence.total_cmp(&a.evidence).then(a.index.cmp(&b.index)));
    Ok(candidates)
}
