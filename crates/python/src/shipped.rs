//! The lights and materials that come with the package.

use crate::arrays::raised;
use crate::light::Light;
use crate::material::Material;
use eigenshade_model::database::Materials;
use eigenshade_model::shipped;
use pyo3::prelude::*;

/// The shipped lights.
#[pyfunction]
pub fn lights() -> PyResult<Vec<Light>> {
    let lights = shipped::lights().map_err(raised)?;
    let sources = shipped::sources().map_err(raised)?;
    let light = |entry: eigenshade_model::database::Named| {
        let of_it = sources.iter().find(|one| one.name == entry.name);
        let sources = of_it.map(|one| one.sources.clone()).unwrap_or_default();
        Light { entry, degree: lights.degree, sources }
    };
    Ok(lights.entries.iter().cloned().map(light).collect())
}

/// The shipped materials, projected to order 7 or, from 12 on, to 12.
#[pyfunction]
pub fn materials(order: usize) -> PyResult<Vec<Material>> {
    let Materials { order, entries } = shipped::named_materials(order).map_err(raised)?;
    let glosses = shipped::glosses().map_err(raised)?;
    let material = |entry: eigenshade_model::database::Named| {
        let gloss = glosses.iter().find(|one| one.name == entry.name).map(|one| one.gloss);
        Material { entry, order, gloss }
    };
    Ok(entries.into_iter().map(material).collect())
}
