//! A table with fewer components.

use crate::table::{Component, Table};

/// The table restricted to the components for which `keep` returns true, and to their profiles.
///
/// `keep` receives the number of a component, counted from 0, and the component. If it keeps the
/// first K components, the result is the table of the same scene with K components.
///
/// Domain: a sphere's table that [projects](Table::has_projection). Stored transfers are dropped.
#[must_use]
pub fn with_components(whole: &Table, keep: impl Fn(usize, &Component) -> bool) -> Table {
    let chosen = whole.components.iter().enumerate().filter(|(k, one)| keep(*k, one));
    let mut components: Vec<Component> = chosen.map(|(_, one)| *one).collect();
    let mut used: Vec<usize> = components.iter().map(|one| one.profile).collect();
    used.sort_unstable();
    used.dedup();
    for component in &mut components {
        component.profile = used.partition_point(|&profile| profile < component.profile);
    }
    let profiles = used.iter().map(|&profile| whole.profiles[profile].clone()).collect();
    Table {
        components,
        profiles,
        summary: whole.summary.clone(),
        scene: whole.scene.clone(),
        gram: whole.gram.clone(),
        selection: whole.selection.clone(),
        mean: whole.mean.clone(),
        spectrum: whole.spectrum.clone(),
        general: None,
        transfers: Vec::new(),
    }
}
