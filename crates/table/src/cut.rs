//! What of a table is left out beside the components after the last.

use crate::components::with_components;
use crate::scene::Cut;
use crate::table::{Component, Table};
use crate::trim::trim;

/// Cuts a table: components of higher azimuths go, then terms, then what is within the share.
/// Its scene says so, and so does the energy that it keeps.
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
