//! The range in which a fitted BRDF is kept, and the grid of directions on which it is checked.

use std::f64::consts::{FRAC_PI_2, PI};

use eigenshade_model::scattering::polar_parts;
use eigenshade_table::material;

/// The lowest value a fit may take, as a multiple of the measured maximum.
pub const LOWEST: f64 = -0.05;
/// The highest value a fit may take, as a multiple of the measured maximum.
pub const HIGHEST: f64 = 2.0;

/// Pairs of directions over both hemispheres, including pole and rim: θ_r <= θ_i in equal steps
/// over \[0, π/2\] (the rest follows from (6)) and Δφ over \[0, π\].
pub struct DirectionGrid {
    order: usize,
    /// θ_i and θ_r of each pair in steps, and I_op^q(θ_i, θ_r, 0).
    pairs: Vec<([usize; 2], Vec<f64>)>,
    /// cos qΔφ for q = 0..=order, for each Δφ.
    cosines: Vec<Vec<f64>>,
    /// q of each mode.
    azimuths: Vec<usize>,
}

/// A grid point where a BRDF is out of range.
pub(super) struct Excess {
    pair: usize,
    azimuth: usize,
    /// 1 above the range, -1 below.
    pub(super) sign: f64,
    amount: f64,
}

impl DirectionGrid {
    /// The grid on which fits of `order` are kept in range: steps of 1 degree up to order 15 (91 x
    /// 91 polar angles, 181 azimuths), finer steps above.
    #[must_use]
    pub fn for_order(order: usize) -> Self {
        let steps = (6 * order).max(90);
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

    /// The lowest and the highest value of the BRDF (7) on the grid.
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

    /// f at every Δφ for one pair of polar angles.
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

    /// The points where the BRDF leaves \[lowest, highest\]: the worst above and the worst below
    /// for each pair of polar angles, except those within two steps of a worse point on the same
    /// side.
    pub(super) fn excesses(&self, coefficients: &[f64], lowest: f64, highest: f64) -> Vec<Excess> {
        let (mut above, mut below) = (Vec::new(), Vec::new());
        for pair in 0..self.pairs.len() {
            let (mut most, mut least) = ((highest, None), (lowest, None));
            for (azimuth, value) in self.along_azimuth(coefficients, pair).enumerate() {
                if value > most.0 {
                    most = (value, Some(azimuth));
                }
                if value < least.0 {
                    least = (value, Some(azimuth));
                }
            }
            let excess = |(value, azimuth): (f64, Option<usize>), sign, bound: f64| {
                azimuth.map(|azimuth| Excess { pair, azimuth, sign, amount: (value - bound).abs() })
            };
            above.extend(excess(most, 1.0, highest));
            below.extend(excess(least, -1.0, lowest));
        }
        let mut points = self.thinned(above);
        points.extend(self.thinned(below));
        points
    }

    /// The worst points, except those within two polar steps of a worse one.
    fn thinned(&self, mut points: Vec<Excess>) -> Vec<Excess> {
        points.sort_by(|a, b| b.amount.total_cmp(&a.amount).then(a.pair.cmp(&b.pair)));
        let mut kept: Vec<Excess> = Vec::new();
        for point in points {
            let [i, r] = self.pairs[point.pair].0;
            let near = |other: &Excess| {
                let [other_i, other_r] = self.pairs[other.pair].0;
                i.abs_diff(other_i) <= 2 && r.abs_diff(other_r) <= 2
            };
            if !kept.iter().any(near) {
                kept.push(point);
            }
        }
        kept
    }

    /// I_op^q at a grid point.
    pub(super) fn modes(&self, point: &Excess) -> Vec<f64> {
        let cosines = &self.cosines[point.azimuth];
        self.pairs[point.pair]
            .1
            .iter()
            .zip(&self.azimuths)
            .map(|(part, &q)| part * cosines[q])
            .collect()
    }
}
