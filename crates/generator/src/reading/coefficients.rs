//! Estimates d of an image, by scalar product or by weighted least squares, and measures how well
//! the components explain the image.

use super::linear::{column, decompose};
use super::observation::Observation;
use eigenshade_model::error::Result;
use faer::ColRef;
use faer::linalg::solvers::Svd;

/// Default cut-off: singular values of √W E below this fraction of the largest count as zero. It is
/// ten times the error of the profiles in the shipped table; below it, values are as much profile
/// rounding as image.
pub const CUTOFF: f64 = 1e-6;

/// Energies below this fraction of the image's energy are rounding.
const ROUNDING: f64 = 1e-14;

/// d_i = I • U_i, the paper's estimate: the weighted mean of (I - m) U_i over the pixels, for one
/// channel.
///
/// Correct if the weighted pixels have the same distribution as the normals of the table's scene:
/// for a sphere table, the whole disc of a sphere with equal weights. Otherwise it is biased,
/// because the eigenimages are not orthogonal over the pixels.
#[must_use]
pub fn scalar_product(observation: &Observation, channel: usize) -> Vec<f64> {
    let sums = observation.design.transpose() * observation.centered(channel);
    sums.iter().map(|sum| sum / observation.weight).collect()
}

/// Weighted least squares for the components of an observation.
#[derive(Debug)]
pub struct LeastSquares {
    svd: Svd<f64>,
    rank: usize,
    condition: f64,
}

impl LeastSquares {
    /// Decomposes √W E. Singular values up to `cutoff` times the largest count as zero: directions
    /// that the pixels do not determine stay at zero (the solution of least norm).
    ///
    /// # Errors
    ///
    /// If the singular values do not converge, which means that a number is not finite.
    pub fn new(observation: &Observation, cutoff: f64) -> Result<Self> {
        let svd = decompose(&observation.design)?;
        let values: Vec<f64> = svd.S().column_vector().iter().copied().collect();
        let largest = values.first().copied().unwrap_or(0.0);
        let rank = values.iter().filter(|value| **value > cutoff * largest).count();
        let condition = values.last().map_or(1.0, |smallest| largest / smallest);
        Ok(Self { svd, rank, condition })
    }

    /// Number of directions that the pixels determine.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Ratio of the largest to the smallest singular value, before the cut-off: how much errors in
    /// the pixels may grow in d.
    #[must_use]
    pub fn condition(&self) -> f64 {
        self.condition
    }

    /// The d of least norm that minimizes |√W (target - E d)|.
    #[must_use]
    pub fn solve(&self, target: ColRef<'_, f64>) -> Vec<f64> {
        let rank = self.rank;
        let mut along = self.svd.U().get(.., ..rank).transpose() * target;
        for (value, singular) in along.iter_mut().zip(self.svd.S().column_vector().iter()) {
            *value /= singular;
        }
        (self.svd.V().get(.., ..rank) * along).iter().copied().collect()
    }
}

/// The goodness of fit of one channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fit {
    /// Weighted root mean square of I - m - E d, in units of the image.
    pub residual_rms: f64,
    /// Σ w (I - m - E d)² over Σ w (I - Ī)²: the unexplained share of the image's variance, as in
    /// the paper's 4.4. For an image of constant value it is 0, or infinite if even that value is
    /// not explained.
    pub relative_residual: f64,
    /// The noise that the residual suggests, as the standard deviation of a pixel of weight 1: √(Σ
    /// w (I - m - E d)² / (pixels - rank)). 0 if there are no more pixels than the rank.
    pub noise: f64,
}

/// Evaluates the fit of d to one channel, where `rank` parameters were estimated from that channel.
#[must_use]
pub fn fit(observation: &Observation, channel: usize, d: &[f64], rank: usize) -> Fit {
    let left = observation.centered(channel) - &observation.design * column(d);
    let residual = left.squared_norm_l2();
    let spread = variance(observation, channel) * observation.weight;
    let energy = observation.channel(channel).squared_norm_l2();
    let freedom = observation.pixels.saturating_sub(rank);
    Fit {
        residual_rms: (residual / observation.weight).sqrt(),
        relative_residual: match (spread > 0.0, residual > ROUNDING * energy) {
            (true, _) => residual / spread,
            (false, true) => f64::INFINITY,
            (false, false) => 0.0,
        },
        noise: if freedom > 0 { (residual / freedom as f64).sqrt() } else { 0.0 },
    }
}

/// The weighted variance of one channel over its pixels.
fn variance(observation: &Observation, channel: usize) -> f64 {
    let mean = observation.sums[channel] / observation.weight;
    let square = observation.channel(channel).squared_norm_l2() / observation.weight;
    // A difference of two sums; below their rounding it counts as zero.
    let variance = square - mean * mean;
    if variance > ROUNDING * square { variance } else { 0.0 }
}
