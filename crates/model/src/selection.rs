//! The variance of each irradiance mode (2.4), and the selection of the modes with the highest
//! variance (2.5).

use eigenshade_table::{GramFactor, mode};

/// The modes of a scene that a selection kept.
#[derive(Clone, Debug, PartialEq)]
pub struct Kept {
    /// A selection in the layout of `Table::selection`; empty if all modes are kept.
    pub selection: Vec<bool>,
}

impl Kept {
    /// Whether the mode (l, o, p, q) of this |m| is kept.
    #[must_use]
    pub fn keeps(
        &self,
        gram: &GramFactor,
        azimuth: usize,
        mode: (usize, usize, usize, usize),
    ) -> bool {
        let (l, o, p, q) = mode;
        self.selection.is_empty() || self.selection[gram.place(azimuth, l, o, p, q)]
    }
}

/// The variance of every mode of one azimuth |m|, in the order of [`mode`]: the integral of E²
/// under the density of the normals, which is a diagonal element of M. +m and -m have the same
/// variance.
#[must_use]
pub fn variances(gram: &GramFactor, azimuth: usize) -> Vec<f64> {
    gram.columns(azimuth).iter().map(|column| column.iter().map(|a| a * a).sum()).collect()
}

/// Keeps the `count` modes with the highest variance, counting both signs of m. Ties are kept
/// together, so slightly more modes may be kept.
///
/// The result has the layout of `Table::selection`; it is empty if `count` is 0 or all modes are
/// kept.
#[must_use]
pub fn highest(gram: &GramFactor, count: usize) -> Vec<bool> {
    let (degree, order) = (gram.degree, gram.order);
    if count == 0 || count >= mode::total(degree, order) {
        return Vec::new();
    }
    let mut ranked: Vec<(f64, usize)> = Vec::new();
    let by_azimuth: Vec<Vec<f64>> = (0..=degree).map(|azimuth| variances(gram, azimuth)).collect();
    for (azimuth, variances) in by_azimuth.iter().enumerate() {
        let signs = if azimuth == 0 { 1 } else { 2 };
        ranked.extend(variances.iter().map(|&variance| (variance, signs)));
    }
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut kept = 0;
    let last = ranked.iter().find(|(_, signs)| {
        kept += signs;
        kept >= count
    });
    // Ties are equal only up to rounding.
    let threshold = last.map_or(0.0, |(variance, _)| variance * (1.0 - 1e-9));
    if ranked.last().is_some_and(|(variance, _)| *variance >= threshold) {
        return Vec::new();
    }
    let mut selection = vec![false; gram.places()];
    for (azimuth, variances) in by_azimuth.iter().enumerate() {
        for ((l, o, p, q), variance) in mode::indices(degree, order, azimuth).zip(variances) {
            selection[gram.place(azimuth, l, o, p, q)] = *variance >= threshold;
        }
    }
    selection
}
