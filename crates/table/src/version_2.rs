//! Tables of version 2, whose scenes know no `knots`.

use crate::general::General;
use crate::gram::GramFactor;
use crate::scene::{self, Criterion, Effects, Geometry, Light, Material, Store};
use crate::table::{self, Component, MeanImage, Profile, Summary};
use crate::transfer::MaterialTransfer;
use serde::Deserialize;

/// [`table::Table`] as it was.
#[derive(Deserialize)]
pub(crate) struct Table {
    scene: Scene,
    summary: Summary,
    gram: GramFactor,
    selection: Vec<bool>,
    components: Vec<Component>,
    profiles: Vec<Profile>,
    mean: Option<MeanImage>,
    spectrum: Vec<(Option<i32>, Option<f64>)>,
    general: Option<General>,
    transfers: Vec<MaterialTransfer>,
}

#[derive(Deserialize)]
struct Scene {
    geometry: Geometry,
    light: Light,
    material: Material,
    basis: Basis,
    effects: Effects,
}

#[derive(Deserialize)]
struct Basis {
    criterion: Criterion,
    components: Option<usize>,
    tolerance: Option<f64>,
    modes: usize,
    rank_cutoff: f64,
    profile_tolerance: f64,
    store: Store,
}

impl From<Table> for table::Table {
    fn from(old: Table) -> Self {
        let Table { scene, summary, gram, selection, components, profiles, .. } = old;
        let Table { mean, spectrum, general, transfers, .. } = old;
        let Scene { geometry, light, material, basis, effects } = scene;
        let Basis { criterion, components: count, tolerance, modes, .. } = basis;
        let Basis { rank_cutoff, profile_tolerance, store, .. } = basis;
        let basis = scene::Basis {
            criterion,
            components: count,
            tolerance,
            modes,
            rank_cutoff,
            profile_tolerance,
            store,
            knots: None,
        };
        Self {
            scene: scene::Scene { geometry, light, material, basis, effects },
            summary,
            gram,
            selection,
            components,
            profiles,
            mean,
            spectrum,
            general,
            transfers,
        }
    }
}
