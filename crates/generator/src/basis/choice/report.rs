//! The report of a choice, as numbers and as text, and the energies that remain after the first
//! components.

use std::fmt;

/// What was chosen for a tolerance, and the cost of choosing less. Errors are relative to the
/// database's peak.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The tolerance.
    pub tolerance: f64,
    /// The database's peak, see [`crate::basis::database::peak`].
    pub peak: f64,
    /// Degree of the light and order of the material.
    pub reach: Reach,
    /// The number of components.
    pub components: Share,
    /// Number of polynomial terms in a collapsed scene, with both signs of m included; `None` if
    /// each polynomial is within the scene's `profile_tolerance` instead.
    pub terms: Option<Share>,
    /// Upper bound of the error. It excludes the polynomials if their terms were not chosen.
    pub total: f64,
}

/// The degree of the light and the order of the material that are used.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Reach {
    /// Chosen to meet the tolerance.
    Chosen {
        /// The light's degree.
        degree: Share,
        /// The material's order.
        order: Share,
    },
    /// As given by the scene, with the reason.
    AsAsked(&'static str),
}

/// How much of something is kept, and the error that this causes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The degree, order or number that is kept.
    pub kept: usize,
    /// The degree, order or number that is available.
    pub of: usize,
    /// Root mean square of the omitted part.
    pub leaves: f64,
    /// The same if one less is kept; `None` if that is impossible.
    pub one_less: Option<f64>,
}

impl Choice {
    /// A choice of components alone, from the energies that remain after each number of components.
    pub(crate) fn of_components(tolerance: f64, peak: f64, remaining: &Remaining) -> Self {
        let count = remaining.least((tolerance * peak).powi(2));
        let components = remaining.share(count, |energy| of_peak(energy, peak));
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

/// The root of an energy relative to the peak; 0 if the images are black.
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
    /// Writes one line for each choice.
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

/// Energies that remain after the first components.
pub(crate) struct Remaining {
    /// Remaining energy by number of components, starting at the smallest possible number.
    left: Vec<f64>,
    /// The smallest possible number of components: the constant is always kept.
    first: usize,
}

impl Remaining {
    /// Computes the remaining energies of a spectrum and of the energy that a cut-off drops.
    pub(crate) fn new(spectrum: &[(Option<i32>, Option<f64>)], dropped: f64) -> Self {
        let first = usize::from(spectrum.first().is_some_and(|(_, value)| value.is_none()));
        let values: Vec<f64> = spectrum.iter().filter_map(|(_, value)| *value).collect();
        // Sum from the smallest value, so that small values are not lost.
        let mut left = vec![dropped];
        for value in values.iter().rev() {
            left.push(left.last().copied().unwrap_or(0.0) + value);
        }
        left.reverse();
        Self { left, first }
    }

    /// The smallest number of components that leaves at most `allowed`, or all of them.
    pub(crate) fn least(&self, allowed: f64) -> usize {
        let last = self.left.len() - 1;
        self.first + self.left.iter().position(|left| *left <= allowed).unwrap_or(last)
    }

    /// The energy that remains after `count` components. Domain: a possible number of components.
    pub(crate) fn left(&self, count: usize) -> f64 {
        self.left[count - self.first]
    }

    /// The share of `count` components in all; `share` converts energies.
    pub(super) fn share(&self, count: usize, share: impl Fn(f64) -> f64) -> Share {
        Share {
            kept: count,
            of: self.first + self.left.len() - 1,
            leaves: share(self.left(count)),
            one_less: (count > self.first).then(|| share(self.left(count - 1))),
        }
    }
}
