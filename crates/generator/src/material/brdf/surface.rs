//! A named material with BRDF functions.

use crate::material::brdf::Brdf;
use crate::material::brdf::projection::{Measure, Projection, project};
use eigenshade_model::database::Named;

/// One BRDF for all three channels, or one for each.
pub struct Surface {
    /// Name of the material.
    pub name: String,
    channels: Vec<Box<dyn Brdf>>,
}

/// A surface's coefficients, and the part that their order leaves out.
#[derive(Clone, Debug, PartialEq)]
pub struct Projected {
    /// The name and the coefficients b_op^q in 1/sr.
    pub material: Named,
    /// [`Projection::left_out`] of the channel where it is largest.
    pub left_out: f64,
}

impl Surface {
    /// A surface with the same BRDF in all channels.
    #[must_use]
    pub fn grey(name: String, brdf: Box<dyn Brdf>) -> Self {
        Self { name, channels: vec![brdf] }
    }

    /// A surface with separate BRDFs for r, g and b.
    #[must_use]
    pub fn colored(name: String, rgb: [Box<dyn Brdf>; 3]) -> Self {
        Self { name, channels: Vec::from(rgb) }
    }

    /// The BRDF of a channel, 0 to 2.
    #[must_use]
    pub fn channel(&self, channel: usize) -> &dyn Brdf {
        &*self.channels[channel.min(self.channels.len() - 1)]
    }

    /// Number of distinct BRDFs: one or three.
    #[must_use]
    pub fn channels(&self) -> usize {
        self.channels.len()
    }

    /// Projects every channel; a BRDF shared by all channels is projected once.
    #[must_use]
    pub fn project(&self, order: usize, measure: Measure) -> Projected {
        let channels: Vec<Projection> =
            self.channels.iter().map(|brdf| project(&**brdf, order, measure)).collect();
        let rgb = [0, 1, 2]
            .map(|channel: usize| channels[channel.min(channels.len() - 1)].coefficients.clone());
        let left_out = channels.iter().map(|channel| channel.left_out).fold(0.0, f64::max);
        Projected { material: Named { name: self.name.clone(), rgb }, left_out }
    }
}
