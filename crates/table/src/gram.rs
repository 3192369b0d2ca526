//! The Gram matrix M of (23) as a factor: M = AᵀA.
//!
//! M is singular to working precision, so it is never computed. With quadrature nodes α_k and
//! weights w_k that include the density of the normals, A\[k, s\] = √w_k f_s(α_k), where E_s =
//! f_s(α) Φ_m(β) and the azimuth functions are orthonormal. A itself is a product of small tables,
//! which are stored instead.

use crate::{material, mode, pair};
use serde::{Deserialize, Serialize};

/// The small tables whose product is A.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct GramFactor {
    /// Largest degree l of the light.
    pub degree: usize,
    /// Largest order o of the BRDF.
    pub order: usize,
    /// cos α_k, ascending in (0, 1).
    pub nodes: Vec<f64>,
    /// √w_k; the weights w_k sum to 1.
    pub root_weights: Vec<f64>,
    /// K_lop^q / N_l^q of (13) for each (o, p, q).
    pub gains: Vec<f64>,
    /// N_l^q C_lo^q of (11): for each pair (o, q), for each l = 0..=degree.
    pub polar_integrals: Vec<f64>,
    /// R_p^q(√2 sin(α_k/2)): for each pair (p, q), for each node.
    pub radials: Vec<f64>,
    /// D_l^mq / Φ_m at the nodes: for each |m|, each l >= |m|, each q <= min(l, order), each node.
    pub rotations: Vec<f64>,
}

impl GramFactor {
    /// Length of a selection of modes.
    #[must_use]
    pub fn places(&self) -> usize {
        (self.degree + 1) * material::count(self.order) * (self.degree + 1)
    }

    /// The index of the modes ±m, (l, o, p, q) in a selection of modes, which is ordered by |m|,
    /// then (o, p, q), then l = 0..=degree.
    #[must_use]
    pub fn place(&self, azimuth: usize, l: usize, o: usize, p: usize, q: usize) -> usize {
        let row = azimuth * material::count(self.order) + material::position(o, p, q);
        row * (self.degree + 1) + l
    }

    /// N_l^q C_lo^q of (11).
    fn polar_integral(&self, l: usize, o: usize, q: usize) -> f64 {
        self.polar_integrals[pair::position(o, q) * (self.degree + 1) + l]
    }

    /// R_p^q at all nodes.
    fn radial(&self, p: usize, q: usize) -> &[f64] {
        let count = self.nodes.len();
        let start = pair::position(p, q) * count;
        &self.radials[start..start + count]
    }

    /// D_l^mq / Φ_m at all nodes.
    #[must_use]
    pub fn rotation(&self, azimuth: usize, l: usize, q: usize) -> &[f64] {
        // The frequencies of all degrees below this one.
        let below = |degree: usize| {
            let (rising, level) = (degree.min(self.order), degree.saturating_sub(self.order));
            rising * (rising + 1) / 2 + level * (self.order + 1)
        };
        let of_azimuths = azimuth * below(self.degree + 1);
        let earlier =
            of_azimuths - (0..azimuth).map(below).sum::<usize>() + below(l) - below(azimuth);
        let count = self.nodes.len();
        &self.rotations[(earlier + q) * count..(earlier + q + 1) * count]
    }

    /// The columns of A of one azimuth |m|, in the order of [`mode`], each with one value per node.
    /// The columns of -m are (-1)^m times these.
    #[must_use]
    pub fn columns(&self, azimuth: usize) -> Vec<Vec<f64>> {
        mode::indices(self.degree, self.order, azimuth)
            .map(|(l, o, p, q)| self.column(azimuth, l, o, p, q).collect())
            .collect()
    }

    /// One column of A, √w_k f_s(α_k), one value per node.
    pub fn column(
        &self,
        azimuth: usize,
        l: usize,
        o: usize,
        p: usize,
        q: usize,
    ) -> impl Iterator<Item = f64> {
        let gain = self.gains[material::position(o, p, q)];
        let (of_o, of_p) = (self.polar_integral(l, o, q), self.polar_integral(l, p, q));
        self.root_weights
            .iter()
            .zip(self.rotation(azimuth, l, q))
            .zip(self.radial(p, q).iter().zip(self.radial(o, q)))
            .map(move |((root, rotation), (radial_p, radial_o))| {
                root * gain * rotation * (of_o * radial_p + of_p * radial_o)
            })
    }

    /// e of (30): the mean of each mode over the normals. Only the modes of m = 0 have nonzero
    /// means; the result lists these in the order of [`mode`].
    #[must_use]
    pub fn mode_means(&self) -> Vec<f64> {
        self.columns(0)
            .iter()
            .map(|column| column.iter().zip(&self.root_weights).map(|(a, root)| a * root).sum())
            .collect()
    }
}
