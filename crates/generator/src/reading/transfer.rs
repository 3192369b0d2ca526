//! The transfer matrix T of a material: d = T L maps the light's coefficients to the components.

use eigenshade_table::{Profile, Table, light, material, mode};
use faer::Mat;

/// Computes transfers of any material into the first components of one table.
#[derive(Clone, Debug)]
pub struct Transfers {
    degree: usize,
    order: usize,
    /// Order m of each component and the index of its row in `rows`.
    components: Vec<(i32, usize)>,
    /// For each profile its row of UᵀM: l, the position of (o, p, q), and the value.
    rows: Vec<Vec<(usize, usize, f64)>>,
}

impl Transfers {
    /// Uses the first `components` components of the table, or all if it has fewer.
    #[must_use]
    pub fn new(table: &Table, components: usize) -> Self {
        let taken = table.components.iter().take(components);
        Self {
            degree: table.gram.degree,
            order: table.gram.order,
            components: taken.map(|one| (one.order, one.profile)).collect(),
            rows: table.profiles.iter().map(|profile| placed(table, profile)).collect(),
        }
    }

    /// Largest degree l of the light.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Largest order o of the material.
    #[must_use]
    pub fn order(&self) -> usize {
        self.order
    }

    /// Number of components.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components.len()
    }

    /// T_i,lm = Σ_opq (UᵀM)_i,lmopq b_op^q, with one row for each component and one column for each
    /// coefficient of the light. Missing coefficients b count as zero, and those beyond the table's
    /// order are ignored.
    #[must_use]
    pub fn of(&self, coefficients: &[f64]) -> Mat<f64> {
        let by_profile: Vec<Vec<f64>> = self
            .rows
            .iter()
            .map(|row| {
                let mut sums = vec![0.0; self.degree + 1];
                for &(l, place, value) in row {
                    sums[l] += value * coefficients.get(place).copied().unwrap_or(0.0);
                }
                sums
            })
            .collect();
        let mut transfer = Mat::zeros(self.components.len(), light::count(self.degree));
        for (i, &(m, profile)) in self.components.iter().enumerate() {
            for l in m.unsigned_abs() as usize..=self.degree {
                transfer[(i, light::position(l, m as isize))] = sign(m) * by_profile[profile][l];
            }
        }
        transfer
    }
}

/// A profile's row of UᵀM, with the positions of the material coefficients of its modes.
fn placed(table: &Table, profile: &Profile) -> Vec<(usize, usize, f64)> {
    mode::indices(table.gram.degree, table.gram.order, profile.azimuth)
        .zip(table.gram_row(profile))
        .map(|((l, o, p, q), value)| (l, material::position(o, p, q), value))
        .collect()
}

/// (-1)^m for m < 0, otherwise 1: mode coefficients of -m are (-1)^m times those of m.
pub(super) fn sign(order: i32) -> f64 {
    if order < 0 && order % 2 != 0 { -1.0 } else { 1.0 }
}
