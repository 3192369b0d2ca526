//! The bases of the settings, each computed once.

use super::materials::Scope;
use super::setting::{Cut, Recipe};
use eigenshade_generator::basis;
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::reduce::cut;
use eigenshade_table::reduce::with_components;
use eigenshade_table::scene::{self, Criterion, LightRotation, Normalize, Store};
use eigenshade_table::{Scene, Table};
use std::collections::BTreeMap;

/// A selection of modes: how many of the highest variance, 0 for all, and the bits of the effects.
type Modes = (usize, u16);

fn modes(recipe: &Recipe) -> Modes {
    (recipe.modes.unwrap_or(0), recipe.effects.bits())
}

/// A table for each selection of modes, with as many components as a recipe asks for.
pub struct Bases(BTreeMap<Modes, Table>);

impl Bases {
    /// Makes the bases that these recipes of one scope start from.
    pub fn new(scope: &Scope, recipes: impl IntoIterator<Item = Recipe>) -> Result<Self> {
        let mut most: BTreeMap<Modes, usize> = BTreeMap::new();
        for recipe in recipes {
            let count = most.entry(modes(&recipe)).or_default();
            *count = (*count).max(recipe.components.unwrap_or(usize::MAX));
        }
        let table = |(modes, components)| {
            let scene = scene(scope, modes, components);
            Ok((modes, basis::build(&scene, &scope.lights, &scope.seen)?))
        };
        Ok(Self(most.into_iter().map(table).collect::<Result<_>>()?))
    }

    /// The table of a recipe.
    ///
    /// # Errors
    ///
    /// If the recipe is not one of those given at first.
    pub fn table(&self, recipe: &Recipe) -> Result<Table> {
        let whole = self.0.get(&modes(recipe));
        let whole = whole.ok_or_else(|| Error::new("a basis is missing", "report it"))?;
        let count = recipe.components.unwrap_or(usize::MAX);
        let mut table = with_components(whole, |number, _| number < count);
        let (terms, trim) = match recipe.cut {
            Cut::Whole => (None, None),
            Cut::Terms(count) => (Some(count), None),
            Cut::Trimmed(share) => (None, Some(share)),
        };
        cut(&mut table, scene::Cut { azimuths: recipe.azimuths, terms, trim });
        Ok(table)
    }
}

fn scene(scope: &Scope, (modes, effects): Modes, components: usize) -> Scene {
    let wanted = Effects::from_bits(effects).unwrap_or(Effects::ALL);
    Scene {
        geometry: scene::Geometry { normals: "sphere".into(), mask: None, density: None },
        light: scene::Light {
            degree: scope.degree,
            database: "inputs/lights.csv".into(),
            rotation: LightRotation::Any,
            normalize: Normalize::UnitAmbient,
            weights: BTreeMap::new(),
        },
        material: scene::Material {
            order: scope.order,
            database: "inputs/materials.csv".into(),
            names: Vec::new(),
            weights: BTreeMap::new(),
        },
        basis: scene::Basis {
            criterion: Criterion::ImageCentered,
            components: Some(components),
            tolerance: None,
            modes,
            store: Store::Projection,
            rank_cutoff: 1e-10,
            profile_tolerance: 1e-7,
            knots: None,
            cut: None,
        },
        effects: scene::Effects {
            wanted: Effect::ALL.into_iter().filter(|&effect| wanted.has(effect)).collect(),
            ..scene::Effects::default()
        },
    }
}
