//! The bases of the settings, each computed once.

use super::materials::Scope;
use super::setting::Recipe;
use eigenshade_generator::basis;
use eigenshade_index::effect::Effects;
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::shipped;
use eigenshade_table::reduce::{cut, with_components};
use eigenshade_table::scene::Store;
use eigenshade_table::{Scene, Table, decode};
use std::collections::HashMap;

/// A selection of modes: how many of the highest variance, and the effects.
type Modes = (Option<usize>, Effects);

/// A table for each selection of modes, with as many components as a recipe asks for.
pub struct Bases(HashMap<Modes, Table>);

impl Bases {
    /// Makes the bases that these recipes of one scope start from.
    pub fn new(scope: &Scope, recipes: impl IntoIterator<Item = Recipe>) -> Result<Self> {
        let mut most: HashMap<Modes, usize> = HashMap::new();
        for recipe in recipes {
            let count = most.entry((recipe.modes, recipe.effects)).or_default();
            *count = (*count).max(recipe.components.unwrap_or(usize::MAX));
        }
        let table = |((modes, effects), components): (Modes, usize)| {
            let mut scene = scene(scope.degree, scope.order, components)?;
            scene.basis.modes = modes.unwrap_or(0);
            scene.effects.wanted.retain(|&effect| effects.has(effect));
            Ok(((modes, effects), basis::build(&scene, &scope.lights, &scope.seen)?))
        };
        Ok(Self(most.into_iter().map(table).collect::<Result<_>>()?))
    }

    /// The table of a recipe, which must be one of those given at first.
    pub fn table(&self, recipe: &Recipe) -> Result<Table> {
        let whole = self.0.get(&(recipe.modes, recipe.effects));
        let whole = whole.ok_or_else(|| Error::new("a basis is missing", "report it"))?;
        let count = recipe.components.unwrap_or(usize::MAX);
        let mut table = with_components(whole, |number, _| number < count);
        cut(&mut table, recipe.cut);
        Ok(table)
    }
}

/// The shipped scene at another degree and order, with at most this many components.
pub fn scene(degree: usize, order: usize, components: usize) -> Result<Scene> {
    let table = decode(shipped::TABLE).map_err(|error| Error::new(error.to_string(), "report it"));
    let mut scene = table?.scene;
    scene.light.degree = degree;
    scene.material.order = order;
    scene.basis.components = Some(components);
    scene.basis.store = Store::Projection;
    Ok(scene)
}
