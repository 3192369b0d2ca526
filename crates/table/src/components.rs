//! A table with fewer components.

use crate::table::{Component, Table};

/// A table with the components for which `keep` says so, of their numbers from 0 on, and
/// with the profiles that these have. Where that is the first K of them, it is the table that
/// the same scene with K components has.
///
/// Domain: a sphere's table that [projects](Table::has_projection); its stored transfers are
/// left out.
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
