//! T of a material: d = T L, the light's coefficients to the components.

use eigenshade_index::{light, material, mode};
use eigenshade_table::{Profile, Table};
use faer::Mat;

/// Transfers of any material into the first components of one table.
#[derive(Clone, Debug)]
pub struct Transfers {
    degree: usize,
    order: usize,
    /// Order m of each component, and which of `rows` is its; of each function
    /// of the span where components are sums of such.
    components: Vec<(i32, usize)>,
    /// d from these components, where they are but a span.
    projection: Option<Mat<f64>>,
    /// Of each profile its row of UᵀM: l, the place of (o, p, q), and the number.
    rows: Vec<Vec<(usize, usize, f64)>>,
}

impl Transfers {
    /// The first `components` of the table.
    #[must_use]
    pub fn new(table: &Table, components: usize) -> Self {
        let span = table.components.len();
        let count = components.min(table.count());
        let projection = table
            .general
            .as_ref()
            .map(|general| Mat::from_fn(count, span, |i, k| general.projection[i * span + k]));
        let taken = &table.components[..if projection.is_some() { span } else { count }];
        Self {
            degree: table.gram.degree,
            order: table.gram.order,
            projection,
            components: taken.iter().map(|one| (one.order, one.profile)).collect(),
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
        self.projection.as_ref().map_or(self.components.len(), Mat::nrows)
    }

    /// T_i,lm = Σ_opq (UᵀM)_i,lmopq b_op^q: a row a component, a column a
    /// coefficient of the light. Coefficients b that are missing count as zero,
    /// those beyond the table's order are left out.
    #[must_use]
    pub fn of(&self, coefficients: &[f64]) -> Mat<f64> {
        let folded: Vec<Vec<f64>> = self
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
                transfer[(i, light::position(l, m as isize))] = sign(m) * folded[profile][l];
            }
        }
        match &self.projection {
            Some(projection) => projection * transfer,
            None => transfer,
        }
    }
}

/// A profile's row of UᵀM, with the places of its modes' coefficients.
fn placed(table: &Table, profile: &Profile) -> Vec<(usize, usize, f64)> {
    mode::indices(table.gram.degree, table.gram.order, profile.azimuth)
        .zip(table.gram_row(profile))
        .map(|((l, o, p, q), value)| (l, material::position(o, p, q), value))
        .collect()
}

/// (-1)^m for m < 0, 1 else: mode coefficients of -m are (-1)^m times those of m.
pub(super) fn sign(order: i32) -> f64 {
    if order < 0 && order % 2 != 0 { -1.0 } else { 1.0 }
}
