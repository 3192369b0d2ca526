//! Reductions of a table beyond leaving out the last components.

use crate::components::with_components;
use crate::scene::Cut;
use crate::table::{Component, Table};
use crate::trim::trim;

/// Cuts a table: first removes components of higher azimuths, then truncates polynomials, then
/// trims them to the tolerance. Updates the table's scene and the energy that the table keeps.
///
/// Domain: a sphere's table that [projects](Table::has_projection).
pub fn cut(table: &mut Table, cut: Cut) {
    table.scene.basis.cut = Some(cut);
    if let Some(largest) = cut.azimuths {
        let within = |component: &Component| component.order.unsigned_abs() as usize <= largest;
        *table = with_components(table, |_, component| within(component));
        let energy = table.summary.energy;
        if energy > 0.0 {
            let left = table.energy_left(table.components.len());
            table.summary.energy_kept = (1.0 - left / energy).max(0.0);
        }
    }
    if let Some(terms) = cut.terms {
        let profiles = table.profiles.iter_mut().map(|profile| &mut profile.chebyshev);
        let mean = table.mean.iter_mut().map(|mean| &mut mean.chebyshev);
        profiles.chain(mean).for_each(|series| series.truncate(terms));
    }
    if let Some(tolerance) = cut.trim {
        trim(table, tolerance);
    }
}
