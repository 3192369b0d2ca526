//! Which of the database's materials an image shows.
//!
//! Each material is asked for its best light. A material that shapes light in many
//! ways can imitate one that does so in few, so the residual alone would prefer the
//! glossy: materials are ranked by their evidence, the probability of the image
//! given the material with the light integrated over its prior, which pays for the
//! freedom. The exposure is the likeliest one of each material.

use super::light_estimate::{Explained, LightEstimate};
use super::observation::Observation;
use super::prior::Prior;
use super::transfer::Transfers;
use eigenshade_model::database::Materials;
use eigenshade_model::error::Result;

/// One material of the database as an explanation of an image.
#[derive(Clone, Debug)]
pub struct Candidate {
    /// Its place in the database.
    pub index: usize,
    /// Channel by channel.
    pub channels: Vec<Explained>,
    /// Sum of the channels' evidence.
    pub evidence: f64,
}

/// All materials, the likeliest first; of equals the earlier of the database.
///
/// `noise` is that of each channel, the standard deviation of a pixel of weight 1.
/// Three channels are r, g and b; of any other number each is taken for luminance.
///
/// # Errors
///
/// If singular values do not converge.
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
