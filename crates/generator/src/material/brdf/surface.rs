//! Surfaces in color: one BRDF for all channels, one for each, or shares of a lobe.

use crate::material::brdf::projection::{Measure, Projection, Sums, integrated, nodes};
use crate::material::brdf::{Brdf, Geometry};
use eigenshade_model::database::Named;
use eigenshade_model::source::Gloss;

/// One BRDF for all three channels, or one for each.
pub struct Surface {
    /// Name of the material.
    pub name: String,
    channels: Vec<Box<dyn Brdf>>,
    lobe: Option<Lobe>,
    gloss: Option<Gloss>,
}

/// The BRDF f that all channels share: each is k + a f.
struct Lobe {
    brdf: Box<dyn Brdf>,
    shares: [[f64; 2]; 3],
}

/// A part of a surface: see [`Surface::parts`].
#[derive(Clone, Copy)]
pub struct Part<'a> {
    /// The part's BRDF.
    pub brdf: &'a dyn Brdf,
    /// Its share of each channel.
    pub shares: [f64; 3],
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
    pub fn gray(name: String, brdf: Box<dyn Brdf>) -> Self {
        Self { name, channels: vec![brdf], lobe: None, gloss: None }
    }

    /// A surface with separate BRDFs for r, g and b.
    #[must_use]
    pub fn colored(name: String, rgb: [Box<dyn Brdf>; 3]) -> Self {
        Self { name, channels: Vec::from(rgb), lobe: None, gloss: None }
    }

    /// The same surface, whose channels are k + a f for this f and a share [k, a] for each. It is
    /// then integrated once for all channels.
    #[must_use]
    pub fn of_lobe(self, brdf: Box<dyn Brdf>, shares: [[f64; 2]; 3]) -> Self {
        Self { lobe: Some(Lobe { brdf, shares }), ..self }
    }

    /// The same surface, which is exactly this lobe over a matte base.
    #[must_use]
    pub fn with_gloss(self, gloss: Gloss) -> Self {
        Self { gloss: Some(gloss), ..self }
    }

    /// The lobe over a matte base that this surface exactly is, if it is one.
    #[must_use]
    pub fn gloss(&self) -> Option<Gloss> {
        self.gloss
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

    /// The parts of this surface: in each channel f is the sum of those of the parts, each times
    /// its share there.
    #[must_use]
    pub fn parts(&self) -> Vec<Part<'_>> {
        if let Some(Lobe { brdf, shares }) = &self.lobe {
            let [of_one, of_lobe] = [0, 1].map(|part: usize| shares.map(|share| share[part]));
            return vec![
                Part { brdf: &One, shares: of_one },
                Part { brdf: &**brdf, shares: of_lobe },
            ];
        }
        if let [gray] = &self.channels[..] {
            return vec![Part { brdf: &**gray, shares: [1.0; 3] }];
        }
        let channels = self.channels.iter().enumerate();
        let shares = |channel: usize| [0, 1, 2].map(|c| if c == channel { 1.0 } else { 0.0 });
        channels.map(|(c, brdf)| Part { brdf: &**brdf, shares: shares(c) }).collect()
    }

    /// Projects every channel; a BRDF shared by all channels is projected once.
    #[must_use]
    pub fn project(&self, order: usize, measure: Measure) -> Projected {
        self.projected(&self.integrated(order), order, measure)
    }

    /// Projects every channel up to each of these orders: see
    /// [`project_orders`](super::projection::project_orders).
    #[must_use]
    pub fn project_orders(&self, orders: &[usize], measure: Measure) -> Vec<Projected> {
        let sums = self.integrated(orders.iter().copied().max().unwrap_or(0));
        orders.iter().map(|&order| self.projected(&sums, order, measure)).collect()
    }

    /// The integrals of each distinct BRDF.
    fn integrated(&self, order: usize) -> Vec<Sums> {
        let integrated = |brdf: &dyn Brdf| integrated(brdf, order, nodes(brdf, order));
        let Some(Lobe { brdf, shares }) = &self.lobe else {
            return self.channels.iter().map(|brdf| integrated(&**brdf)).collect();
        };
        let (of_one, sums) = (integrated(&One), integrated(&**brdf));
        shares.iter().map(|&share| sums.of_share(&of_one, share)).collect()
    }

    fn projected(&self, sums: &[Sums], order: usize, measure: Measure) -> Projected {
        let channels: Vec<Projection> =
            sums.iter().map(|sums| sums.projection(order, measure)).collect();
        let rgb = [0, 1, 2]
            .map(|channel: usize| channels[channel.min(channels.len() - 1)].coefficients.clone());
        let left_out = channels.iter().map(|channel| channel.left_out).fold(0.0, f64::max);
        Projected { material: Named { name: self.name.clone(), rgb }, left_out }
    }
}

/// f = 1/sr.
struct One;

impl Brdf for One {
    fn value(&self, _: Geometry) -> f64 {
        1.0
    }

    fn width(&self) -> f64 {
        1.0
    }
}
