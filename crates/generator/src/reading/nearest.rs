//! Identifies the database material that an image shows.
//!
//! Each material is fitted with its best light. A material that shapes light in many ways can
//! imitate one that does so in few, so the residual alone would favor glossy materials. Materials
//! are therefore ranked by evidence: the probability of the image given the material, integrated
//! over the prior of the light, which penalizes that freedom. Each material uses its likeliest
//! exposure.

use super::light_estimate::{Explained, LightEstimate};
use super::observation::Observation;
use super::prior::Prior;
use super::transfer::Transfers;
use eigenshade_model::database::Materials;
use eigenshade_model::error::Result;

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
        let estimate = |coefficients: &[f64]| {
            LightEstimate::new(observation, prior, &transfers.of(coefficients))
        };
        let each = noise.iter().enumerate();
        let channels: Vec<Explained> = if noise.len() == 3 && !material.is_grey() {
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
