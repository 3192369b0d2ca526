//! How much of light, material and basis a tolerance asks for: the degree L of the light, the
//! order O of the material, the components and the polynomials' terms.
//!
//! The tolerance is of the root mean square error of the database's images, light turned by all
//! rotations, over its [`peak`]; the truth is the image of the degree and order that the scene
//! gives. With D the mean energy of the images of degrees above L, O' that of orders above O at
//! degrees up to L, R that of the components left out and P that of what the polynomials lack,
//!
//! error² <= D + (√O' + √(R + P))²:
//!
//! degrees are uncorrelated over all rotations, (38), and so are the coefficients of components;
//! orders are not, and take the triangle inequality. Every energy is a sum of squares of the
//! database's images in the coordinates of their profile spaces: no pixel is shaded.

mod candidates;
mod energies;
mod polynomials;

use crate::analysis::Analysis;
use crate::basis;
use crate::database::{Lights, Materials};
use crate::error::{Error, Result};
use crate::peak;
use eigenshade_table::trim::trim;
use eigenshade_table::{Scene, Table};
use std::fmt;

/// Of the energy that components and polynomials may lack, the polynomials' share at least.
const POLYNOMIALS: f64 = 0.1;

/// The polynomials that are then shortened are within this of the tolerance.
const WHOLE: f64 = 0.01;

/// And no nearer than this: rounding.
const NEAREST: f64 = 1e-13;

/// What the total may exceed the tolerance by, relative: rounding of sums.
const ROUNDING: f64 = 1e-9;

/// What was chosen for a tolerance, and why no less; errors are of the database's peak.
#[derive(Clone, Debug, PartialEq)]
pub struct Choice {
    /// The tolerance.
    pub tolerance: f64,
    /// The database's peak: see [`peak`].
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

/// The least table within a tolerance, of databases of exactly the scene's degree and order,
/// whole; and what was chosen.
///
/// # Errors
///
/// As [`basis::build`].
pub(crate) fn within(
    tolerance: f64,
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Table, Choice)> {
    let peak = peak::of(scene, lights, materials)?;
    basis::in_range(peak)?;
    let allowed = (tolerance * peak).powi(2);
    let mut picked = scene.clone();
    let mut left = [0.0; 2];
    let reach = if scene.basis.modes > 0 {
        Reach::AsAsked("basis.modes chooses among the modes of all")
    } else if allowed == 0.0 {
        Reach::AsAsked("all images are black")
    } else {
        let found = candidates::least(scene, lights, materials, allowed)?;
        (picked.light.degree, picked.material.order) = (found.degree, found.order);
        left = [found.degrees_left, found.orders_left];
        found.reach(scene, peak)
    };
    let lights = lights.truncated(picked.light.degree);
    let analysis = Analysis::new(&picked, &lights, &materials.truncated(picked.material.order))?;
    let spectrum = analysis.spectrum();
    let below = Below::new(&spectrum, analysis.dropped());
    let budget = budget(allowed, left);
    let (count, leaves) = below.least((1.0 - POLYNOMIALS) * budget);

    let start = scene.basis.profile_tolerance.min((WHOLE * tolerance).max(NEAREST));
    let mut table = analysis.table(count, start);
    let mean = analysis.mean_values();
    let of_terms = polynomials::terms(&table);
    let lost = polynomials::left_out(&table, mean.as_deref());
    let spare = ((budget - leaves).max(0.0).sqrt() - lost.sqrt()).max(0.0);
    let size = table.summary.energy.sqrt();
    if size > 0.0 {
        trim(&mut table, spare / size);
    }
    let lost = polynomials::left_out(&table, mean.as_deref());
    let share = |energy: f64| if peak > 0.0 { energy.sqrt() / peak } else { 0.0 };
    let choice = Choice {
        tolerance,
        peak,
        reach,
        components: Share {
            kept: count,
            of: spectrum.len(),
            leaves: share(leaves),
            one_less: count.checked_sub(1).map(|less| share(below.left(less))),
        },
        terms: Some(Share {
            kept: polynomials::terms(&table),
            of: of_terms,
            leaves: share(lost),
            one_less: None,
        }),
        total: share(left[0] + (left[1].sqrt() + (leaves + lost).sqrt()).powi(2)),
    };
    if choice.total > tolerance * (1.0 + ROUNDING) {
        return Err(Error::new(
            format!("basis.tolerance = {tolerance} is not met: {:.1e} is", choice.total),
            "take a smaller rank_cutoff, or a larger tolerance",
        ));
    }
    Ok((table, choice))
}

impl Choice {
    /// Components alone, of energies that adding others leaves.
    pub(crate) fn of_components(tolerance: f64, peak: f64, below: &Below) -> Self {
        let (count, leaves) = below.least((tolerance * peak).powi(2));
        let share = |energy: f64| if peak > 0.0 { energy.sqrt() / peak } else { 0.0 };
        Self {
            tolerance,
            peak,
            reach: Reach::AsAsked("they are chosen for spheres under light that turns freely"),
            components: Share {
                kept: count,
                of: below.count(),
                leaves: share(leaves),
                one_less: count.checked_sub(1).map(|less| share(below.left(less))),
            },
            terms: None,
            total: share(leaves),
        }
    }
}

/// R + P that a tolerance leaves of this energy, where degrees and orders leave those.
fn budget(allowed: f64, [degrees, orders]: [f64; 2]) -> f64 {
    ((allowed - degrees).max(0.0).sqrt() - orders.sqrt()).max(0.0).powi(2)
}

/// Energies that the first components leave.
pub(crate) struct Below {
    /// By their number, from the least that there can be: the constant is always kept.
    left: Vec<f64>,
    first: usize,
}

impl Below {
    /// Of a spectrum, and of the energy that a cut-off drops.
    pub(crate) fn new(spectrum: &[(Option<i32>, Option<f64>)], dropped: f64) -> Self {
        let first = usize::from(spectrum.first().is_some_and(|(_, value)| value.is_none()));
        let values: Vec<f64> = spectrum.iter().filter_map(|(_, value)| *value).collect();
        // From the small end, so that nothing small is lost.
        let mut left = vec![dropped];
        for value in values.iter().rev() {
            left.push(left.last().copied().unwrap_or(0.0) + value);
        }
        left.reverse();
        Self { left, first }
    }

    /// The least number that leaves at most `allowed`, or all; and what it leaves.
    pub(crate) fn least(&self, allowed: f64) -> (usize, f64) {
        let last = self.left.len() - 1;
        let place = self.left.iter().position(|left| *left <= allowed).unwrap_or(last);
        (self.first + place, self.left[place])
    }

    /// Number of all components.
    fn count(&self) -> usize {
        self.first + self.left.len() - 1
    }

    /// What `count` components leave; of fewer than there can be, what the least leave.
    fn left(&self, count: usize) -> f64 {
        self.left[count.saturating_sub(self.first)]
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} of {}", self.kept, self.of)?;
        if self.kept < self.of {
            write!(f, ", leaves {:.1e} of the peak", self.leaves)?;
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
        if let Some(terms) = self.terms {
            writeln!(f, "polynomial terms {terms}")?;
        }
        write!(f, "in all at most {:.1e} of the peak, {:.1e} asked for", self.total, self.tolerance)
    }
}
