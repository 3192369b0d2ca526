//! Evaluates the eigenimages of a table at given normals.

use crate::basis::profile;
use eigenshade_table::Table;
use std::f64::consts::SQRT_2;

/// The first components of a table and its mean image, evaluated one normal at a time.
#[derive(Clone, Copy, Debug)]
pub struct EigenimageValues<'a> {
    table: &'a Table,
    components: usize,
}

impl<'a> EigenimageValues<'a> {
    /// Uses the first `components` components of the table, or all if it has fewer.
    #[must_use]
    pub fn new(table: &'a Table, components: usize) -> Self {
        Self { table, components: components.min(table.count()) }
    }

    /// Number of components.
    #[must_use]
    pub fn components(&self) -> usize {
        self.components
    }

    /// Writes U_i of every component, then the mean image (0 if the table has none), at a unit
    /// normal with z >= 0. `values` must have room for the components and the mean.
    ///
    /// U_i = u_i(α) Φ_m(β), or a sum of such products if the table's components form a span; this
    /// costs K more multiplications for each function of the span.
    ///
    /// Error: the scene's `profile_tolerance` relative to the largest value of each profile, times
    /// the sizes of the terms in the sum.
    pub fn at(&self, normal: [f64; 3], values: &mut [f64]) {
        let table = self.table;
        let (values, mean) = values.split_at_mut(self.components.min(values.len()));
        let of_mean = if let Some(general) = &table.general {
            let mut span = vec![0.0; table.components.len()];
            self.products(normal, &mut span);
            let sum = |row: &[f64]| row.iter().zip(&span).map(|(a, value)| a * value).sum::<f64>();
            let rows = general.synthesis.chunks_exact(span.len());
            values.iter_mut().zip(rows).for_each(|(value, row)| *value = sum(row));
            sum(&general.mean)
        } else {
            self.products(normal, values);
            table.mean.as_ref().map_or(0.0, |mean| profile::evaluate(&mean.chebyshev, normal[2]))
        };
        mean.iter_mut().take(1).for_each(|mean| *mean = of_mean);
    }

    /// u(α) Φ_m(β) of the table's first products.
    fn products(&self, [x, y, z]: [f64; 3], values: &mut [f64]) {
        let table = self.table;
        let mut previous = None;
        for (value, component) in values.iter_mut().zip(&table.components) {
            // +m and -m are adjacent and share h.
            let h = match previous {
                Some((profile, h)) if profile == component.profile => h,
                _ => profile::evaluate(&table.profiles[component.profile].chebyshev, z),
            };
            previous = Some((component.profile, h));
            *value = h * azimuth(component.order, x, y);
        }
    }
}

/// sin^|m|(α) Φ_m(β) of the normal (x, y, ..): Re or -Im of (x + i y)^|m|, times √2
/// where m is not 0.
fn azimuth(order: i32, x: f64, y: f64) -> f64 {
    let (mut re, mut im) = (1.0, 0.0);
    for _ in 0..order.unsigned_abs() {
        (re, im) = (re * x - im * y, re * y + im * x);
    }
    match order {
        0 => 1.0,
        1.. => SQRT_2 * re,
        _ => -SQRT_2 * im,
    }
}
