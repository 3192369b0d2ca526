//! The energies of the database's images that a degree and an order leave out, and what is left for
//! components and polynomials.

use crate::basis::moments::Deviation;
use crate::basis::pca;
use crate::basis::profile::ProfileSpace;
use eigenshade_index::{material, mode};
use eigenshade_model::selection::Kept;
use eigenshade_table::GramFactor;
use faer::Mat;

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
        let (space, factor) = pca::factor(gram, azimuth, keeps);
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
