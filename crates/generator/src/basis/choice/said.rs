//! What was chosen, in numbers and in words.

use crate::basis::choice::Below;
use std::fmt;

/// What was chosen for a tolerance, and why no less; errors are of the database's peak.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The tolerance.
    pub tolerance: f64,
    /// The database's peak: see [`crate::basis::peak`].
    pub peak: f64,
    /// Degree and order.
    pub reach: Reach,
    /// The components.
    pub components: Share,
    /// The polynomials' terms in a collapsed scene, both signs of m counted; none where each
    /// polynomial is within the scene's `profile_tolerance`.
    pub terms: Option<Share>,
    /// What the error is at most: without the polynomials where these were not chosen.
    pub total: f64,
}

/// How far light and material are taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// As far as the tolerance asks for.
    Chosen {
        /// The light's degree.
        degree: Share,
        /// The material's order.
        order: Share,
    },
    /// As far as the scene says, and why.
    AsAsked(&'static str),
}

/// What is kept of something, and what that costs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The degree, order or number that is kept.
    pub kept: usize,
    /// The one that there is.
    pub of: usize,
    /// Root mean square of what is left out.
    pub leaves: f64,
    /// The same with one less, where there is less.
    pub one_less: Option<f64>,
}

impl Choice {
    /// Components alone, of energies that adding others leaves.
    pub(crate) fn of_components(tolerance: f64, peak: f64, below: &Below) -> Self {
        let count = below.least((tolerance * peak).powi(2));
        let components = below.share(count, |energy| of_peak(energy, peak));
        Self {
            tolerance,
            peak,
            reach: Reach::AsAsked("they are chosen for spheres under light that turns freely"),
            components,
            terms: None,
            total: components.leaves,
        }
    }
}

/// The root of an energy, of the peak; of black images nothing.
pub(super) fn of_peak(energy: f64, peak: f64) -> f64 {
    if peak > 0.0 { energy.sqrt() / peak } else { 0.0 }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.kept, self.of)?;
        match self.leaves {
            _ if self.kept == self.of => {}
            0.0 => write!(f, ", leaves nothing")?,
            leaves => write!(f, ", leaves {leaves:.1e} of the peak")?,
        }
        match self.one_less {
            Some(one_less) => write!(f, "; {} would leave {one_less:.1e}", self.kept - 1),
            None => Ok(()),
        }
    }
}

impl fmt::Display for Choice {
    /// A line for each choice.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.reach {
            Reach::Chosen { degree, order } => writeln!(f, "degree {degree}\norder {order}")?,
            Reach::AsAsked(why) => writeln!(f, "degree and order as asked: {why}")?,
        }
        writeln!(f, "components {}", self.components)?;
        match self.terms {
            Some(terms) => write!(f, "polynomial terms {terms}\nin all")?,
            None => write!(f, "polynomials within profile_tolerance; but for these")?,
        }
        write!(f, " at most {:.1e} of the peak, {:.1e} asked for", self.total, self.tolerance)
    }
}
