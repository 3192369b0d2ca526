//! The grid of directions on which a fitted BRDF is held in range.

use std::f64::consts::{FRAC_PI_2, PI};

use crate::scattering::polar_parts;
use eigenshade_index::material;

/// Pairs of directions over both hemispheres, pole and rim included: θ_r <= θ_i
/// in equal steps over \[0, π/2\] (by (6) the rest is the same), Δφ over \[0, π\].
pub struct DirectionGrid {
    order: usize,
    /// θ_i and θ_r of each pair as steps, with I_op^q(θ_i, θ_r, 0).
    pairs: Vec<([usize; 2], Vec<f64>)>,
    /// cos qΔφ, q = 0..=order, of each Δφ.
    cosines: Vec<Vec<f64>>,
    /// q of each mode.
    azimuths: Vec<usize>,
}

/// A point of the grid where a BRDF is lowest or highest among its neighbours.
pub(super) struct Extreme {
    pair: usize,
    azimuth: usize,
    value: f64,
}

impl DirectionGrid {
    /// The grid that fits of `order` are checked on: steps of 2 degrees up to
    /// order 11 (46 x 46 polar angles, 91 azimuths), finer for more.
    #[must_use]
    pub fn for_order(order: usize) -> Self {
        let steps = (4 * order).max(90);
        Self::new(order, steps, 2 * steps)
    }

    /// A grid of `polar` steps in θ and `azimuthal` steps in Δφ, at least one
    /// of each, for coefficients up to `order`.
    #[must_use]
    pub fn new(order: usize, polar: usize, azimuthal: usize) -> Self {
        let theta = |step: usize| FRAC_PI_2 * step as f64 / polar.max(1) as f64;
        let pairs = (0..=polar)
            .flat_map(|i| (0..=i).map(move |r| [i, r]))
            .map(|[i, r]| ([i, r], polar_parts(order, theta(i), theta(r))))
            .collect();
        let cosines = (0..=azimuthal)
            .map(|step| {
                let delta_phi = PI * step as f64 / azimuthal.max(1) as f64;
                (0..=order).map(|q| (q as f64 * delta_phi).cos()).collect()
            })
            .collect();
        Self {
            order,
            pairs,
            cosines,
            azimuths: material::indices(order).map(|(_, _, q)| q).collect(),
        }
    }

    /// The lowest and the highest value on the grid of the BRDF (7).
    #[must_use]
    pub fn range(&self, coefficients: &[f64]) -> (f64, f64) {
        let mut range = (f64::INFINITY, f64::NEG_INFINITY);
        for pair in 0..self.pairs.len() {
            for value in self.along_azimuth(coefficients, pair) {
                range = (range.0.min(value), range.1.max(value));
            }
        }
        range
    }

    /// f at every Δφ of one pair of polar angles.
    fn along_azimuth<'a>(
        &'a self,
        coefficients: &'a [f64],
        pair: usize,
    ) -> impl Iterator<Item = f64> + 'a {
        let mut series = vec![0.0; self.order + 1];
        let parts = &self.pairs[pair].1;
        for ((part, coefficient), &q) in parts.iter().zip(coefficients).zip(&self.azimuths) {
            series[q] += part * coefficient;
        }
        self.cosines
            .iter()
            .map(move |cosines| cosines.iter().zip(&series).map(|(c, s)| c * s).sum())
    }

    /// The points where `sign` f exceeds `bound`, the worst first, and none
    /// within two steps of polar angle of a worse one.
    pub(super) fn excesses(&self, coefficients: &[f64], sign: f64, bound: f64) -> Vec<Extreme> {
        let mut extremes: Vec<Extreme> = (0..self.pairs.len())
            .filter_map(|pair| {
                self.along_azimuth(coefficients, pair)
                    .map(|value| sign * value)
                    .enumerate()
                    .max_by(|(_, a), (_, b)| a.total_cmp(b))
                    .filter(|&(_, value)| value > bound)
                    .map(|(azimuth, value)| Extreme {
                        pair,
                        azimuth,
                        value,
                    })
            })
            .collect();
        extremes.sort_by(|a, b| b.value.total_cmp(&a.value).then(a.pair.cmp(&b.pair)));
        let mut kept: Vec<Extreme> = Vec::new();
        for extreme in extremes {
            let [i, r] = self.pairs[extreme.pair].0;
            let near = |other: &Extreme| {
                let [oi, or] = self.pairs[other.pair].0;
                i.abs_diff(oi) <= 2 && r.abs_diff(or) <= 2
            };
            if !kept.iter().any(near) {
                kept.push(extreme);
            }
        }
        kept
    }

    /// I_op^q at a point of the grid.
    pub(super) fn modes(&self, extreme: &Extreme) -> Vec<f64> {
        let cosines = &self.cosines[extreme.azimuth];
        self.pairs[extreme.pair]
            .1
            .iter()
            .zip(&self.azimuths)
            .map(|(part, &q)| part * cosines[q])
            .collect()
    }
}
