//! Measures how well components explain an image.

use super::coefficients::column;
use super::observation::Observation;

/// Energies below this fraction of the image's energy are rounding.
const ROUNDING: f64 = 1e-14;

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
    let left = observation.centred(channel) - &observation.design * column(d);
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
