//! What of a table is left out beside the components after the last.

use crate::components::with_components;
use crate::scene::Cut;
use crate::table::{Component, Table};
use crate::trim::trim;

/// Cuts a table: components of higher azimuths go, then terms, then what is within the share.
///
/// Domain: a sphere's table that [projects](Table::has_projection).
pub fn cut(table: &mut Table, cut: Cut) {
    if let Some(largest) = cut.azimuths {
        let within = |component: &Component| component.order.unsigned_abs() as usize <= largest;
        *table = with_components(table, |_, component| within(component));
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
