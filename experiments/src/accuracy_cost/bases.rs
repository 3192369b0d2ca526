//! The bases of the settings, each computed once.

use super::materials::Scope;
use super::setting::Recipe;
use eigenshade_generator::basis;
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_model::error::Result;
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

/// A basis with all components of a scope, and bases of selected modes.
pub struct Bases {
    tables: BTreeMap<Modes, Table>,
}

impl Bases {
    /// Makes the bases that these recipes of one scope start from.
    ///
    /// # Errors
    ///
    /// Never in practice: the databases reach the scope's degree and order.
    pub fn new(scope: &Scope, recipes: impl IntoIterator<Item = Recipe>) -> Result<Self> {
        let mut tables = BTreeMap::new();
        let mut most: BTreeMap<Modes, Option<usize>> = BTreeMap::new();
        for recipe in recipes {
            let known = most.entry(modes(&recipe)).or_insert(Some(0));
            *known = (*known).zip(recipe.components).map(|(a, b)| a.max(b));
        }
        for (modes, components) in most {
            let scene = scene(scope, modes, components);
            tables.insert(modes, basis::build(&scene, &scope.lights, &scope.seen)?);
        }
        Ok(Self { tables })
    }

    /// The table of a recipe.
    #[must_use]
    pub fn table(&self, recipe: &Recipe) -> Option<Table> {
        let whole = self.tables.get(&modes(recipe))?;
        let count = recipe.components.unwrap_or(usize::MAX);
        let mut table = with_components(whole, |number, _| number < count);
        cut(&mut table, recipe.cuts());
        Some(table)
    }
}

fn scene(scope: &Scope, (modes, effects): Modes, components: Option<usize>) -> Scene {
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
            components: Some(components.unwrap_or(usize::MAX)),
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
