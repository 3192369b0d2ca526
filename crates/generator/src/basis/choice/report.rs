//! The report of a choice, as numbers and as text, and the energies of the database's images behind
//! it: those that a degree and an order leave out, those that remain after the first components,
//! and what is left for components and polynomials.

use crate::basis::moments::Deviation;
use crate::basis::pca;
use crate::basis::profile::ProfileSpace;
use eigenshade_model::selection::Kept;
use eigenshade_table::{GramFactor, material, mode};
use faer::Mat;
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
    /// Number of polynomial terms in a collapsed scene, with both signs of m included.
    pub terms: Share,
    /// Upper bound of the error.
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
        writeln!(f, "polynomial terms {}", self.terms)?;
        write!(f, "in all at most {:.1e} of the peak, {:.1e} asked for", self.total, self.tolerance)
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
    pub(crate) fn new(spectrum: &[(i32, Option<f64>)], dropped: f64) -> Self {
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

/// The smallest fraction that the polynomials get of the energy that components and polynomials may
/// omit.
pub(super) const POLYNOMIALS: f64 = 0.1;

/// The energy R + P that is allowed after degrees and orders are left out.
pub(super) fn budget(allowed: f64, [degrees, orders]: [f64; 2]) -> f64 {
    ((allowed - degrees).max(0.0).sqrt() - orders.sqrt()).max(0.0).powi(2)
}

/// The matrix A of one azimuth, which gives the database's images.
pub(super) struct Images<'a> {
    gram: &'a GramFactor,
    azimuth: usize,
    pub(super) space: ProfileSpace,
    factor: Mat<f64>,
}

impl<'a> Images<'a> {
    /// Uses the modes of the kept effects.
    pub(super) fn new(gram: &'a GramFactor, kept: &Kept, azimuth: usize) -> Self {
        let keeps = |l, o, p, q| kept.keeps(gram, azimuth, (l, o, p, q));
        let (space, factor) = pca::factor(gram, azimuth, &keeps);
        Self { gram, azimuth, space, factor }
    }

    /// Coordinates of the images of the deviations of degree l, one column each. Entry k of the
    /// result includes the orders 0..=k.
    pub(super) fn by_order(&self, deviations: &[Deviation], l: usize) -> Vec<Mat<f64>> {
        let (degree, order) = (self.gram.degree, self.gram.order);
        let of_degree: Vec<&Deviation> = deviations.iter().filter(|one| one.degree == l).collect();
        let modes = || mode::indices(degree, order, self.azimuth).enumerate();
        let mut sum = Mat::zeros(self.space.dimension(), of_degree.len());
        let mut by_order = Vec::new();
        for highest in 0..=order {
            let places: Vec<(usize, usize)> = modes()
                .filter(|(_, (of, o, _, _))| (*of, *o) == (l, highest))
                .map(|(s, (_, o, p, q))| (s, material::position(o, p, q)))
                .collect();
            if let Some(&(first, _)) = places.first() {
                // The modes of one degree and order are adjacent.
                let materials = Mat::from_fn(places.len(), of_degree.len(), |s, t| {
                    of_degree[t].material[places[s].1]
                });
                sum += self.factor.get(.., first..first + places.len()) * materials;
            }
            by_order.push(sum.clone());
        }
        by_order
    }
}

/// Mean energies of the database's images that are left out at a lower degree and order of light
/// and material, with both signs of m included.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Energies {
    /// For each degree, the energy of all orders, of orders from 1 up, and so on, down to no
    /// orders.
    left: Vec<Vec<f64>>,
}

impl Energies {
    /// Computes the energies from second moments; `deviations` gives those of each azimuth.
    pub(super) fn new(
        gram: &GramFactor,
        kept: &Kept,
        deviations: impl Fn(usize) -> Vec<Deviation>,
    ) -> Self {
        let mut left = vec![vec![0.0; gram.order + 2]; gram.degree + 1];
        for azimuth in 0..=gram.degree {
            let images = Images::new(gram, kept, azimuth);
            let deviations = deviations(azimuth);
            let signs = if azimuth == 0 { 1.0 } else { 2.0 };
            for l in azimuth..=gram.degree {
                let by_order = images.by_order(&deviations, l);
                let Some(whole) = by_order.last() else { continue };
                left[l][0] += signs * whole.squared_norm_l2();
                for (left, part) in left[l][1..].iter_mut().zip(&by_order) {
                    *left += signs * (whole - part).squared_norm_l2();
                }
            }
        }
        Self { left }
    }

    /// The energy in degrees above `degree`, at all orders.
    pub(super) fn of_degrees_above(&self, degree: usize) -> f64 {
        self.left[degree + 1..].iter().rev().map(|by_order| by_order[0]).sum()
    }

    /// The energy in orders from `first` up, at degrees up to `degree`.
    pub(super) fn of_orders_from(&self, first: usize, degree: usize) -> f64 {
        self.left[..=degree].iter().rev().map(|by_order| by_order[first]).sum()
    }
}
