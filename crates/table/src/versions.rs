//! Tables as their files have them: a version says which of the scene's last two fields are
//! there.

use crate::general::General;
use crate::gram::GramFactor;
use crate::scene::{self, Criterion, Cut, Effects, Geometry, Light, Material, Store};
use crate::table::{self, Component, MeanImage, Profile, Summary};
use crate::transfer::MaterialTransfer;
use serde::Deserialize;

/// The version of a scene's table.
pub(crate) fn of(basis: &scene::Basis) -> u32 {
    match (basis.knots, basis.cut) {
        (None, None) => 2,
        (Some(_), None) => 3,
        (None, Some(_)) => 4,
        (Some(_), Some(_)) => 5,
    }
}

/// The last fields of a scene's basis.
pub(crate) trait Tail {
    /// Knots and cut.
    fn fields(self) -> (Option<usize>, Option<Cut>);
}

/// Of version 2.
#[derive(Deserialize)]
pub(crate) struct Neither;

/// Of version 3.
#[derive(Deserialize)]
pub(crate) struct Knots(Option<usize>);

/// Of version 4.
#[derive(Deserialize)]
pub(crate) struct Cuts(Option<Cut>);

/// Of version 5.
#[derive(Deserialize)]
pub(crate) struct Both(Option<usize>, Option<Cut>);

impl Tail for Neither {
    fn fields(self) -> (Option<usize>, Option<Cut>) {
        (None, None)
    }
}

impl Tail for Knots {
    fn fields(self) -> (Option<usize>, Option<Cut>) {
        (self.0, None)
    }
}

impl Tail for Cuts {
    fn fields(self) -> (Option<usize>, Option<Cut>) {
        (None, self.0)
    }
}

impl Tail for Both {
    fn fields(self) -> (Option<usize>, Option<Cut>) {
        (self.0, self.1)
    }
}

/// [`table::Table`] with these last fields.
#[derive(Deserialize)]
pub(crate) struct Table<T> {
    scene: Scene<T>,
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
struct Scene<T> {
    geometry: Geometry,
    light: Light,
    material: Material,
    basis: Basis<T>,
    effects: Effects,
}

#[derive(Deserialize)]
struct Basis<T> {
    criterion: Criterion,
    components: Option<usize>,
    tolerance: Option<f64>,
    modes: usize,
    rank_cutoff: f64,
    profile_tolerance: f64,
    store: Store,
    tail: T,
}

impl<T: Tail> From<Table<T>> for table::Table {
    fn from(old: Table<T>) -> Self {
        let Table { scene, summary, gram, selection, components, profiles, .. } = old;
        let Table { mean, spectrum, general, transfers, .. } = old;
        let Scene { geometry, light, material, basis, effects } = scene;
        let Basis { criterion, components: count, tolerance, modes, .. } = basis;
        let Basis { rank_cutoff, profile_tolerance, store, .. } = basis;
        let (knots, cut) = basis.tail.fields();
        let basis = scene::Basis {
            criterion,
            components: count,
            tolerance,
            modes,
            rank_cutoff,
            profile_tolerance,
            store,
            knots,
            cut,
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
