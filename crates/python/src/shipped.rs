//! The lights and materials that come with the package.

use crate::arrays::{raised, refused};
use crate::light::Light;
use crate::material::Material;
use eigenshade_model::database::{Materials, name_remedy};
use eigenshade_model::error::Error;
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

/// The shipped materials, projected to order 7 or 12.
#[pyfunction]
pub fn materials(order: usize) -> PyResult<Vec<Material>> {
    let Materials { order: found, entries } = shipped::named_materials(order).map_err(raised)?;
    if found != order {
        let what = format!("the shipped materials do not have order {order}");
        return Err(refused(what, "ask for 7, or for 12, which `Table(\"pbr\")` has"));
    }
    let glosses = shipped::glosses().map_err(raised)?;
    let material = |entry: eigenshade_model::database::Named| {
        let gloss = glosses.iter().find(|one| one.name == entry.name).map(|one| one.gloss);
        Material { entry, order, gloss }
    };
    Ok(entries.into_iter().map(material).collect())
}

/// The message that no shipped light or material has a name.
#[pyfunction]
pub fn missing(kind: &str, name: &str, names: Vec<String>) -> String {
    let otherwise = format!("a name of `{kind}s.keys()`");
    let remedy = name_remedy(name, names.iter().map(String::as_str), &otherwise);
    Error::new(format!("no shipped {kind} `{name}`"), remedy).to_string()
}
