//! Lights and materials as arrays.

use super::array::Array;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_table::{light, material};

/// Names, coefficients and indices of lights.
#[must_use]
pub fn of_lights(lights: &Lights) -> Vec<Array> {
    let (count, length) = (lights.entries.len(), light::count(lights.degree));
    let indices = light::indices(lights.degree).flat_map(|(l, m)| [l as i64, m as i64]);
    vec![
        Array::new("light_names", [count], names(&lights.entries)),
        Array::new("lights", [count, 3, length], channels(&lights.entries)),
        Array::new("light_indices", [length, 2], indices.collect::<Vec<_>>()),
    ]
}

/// Names, coefficients and indices of materials.
#[must_use]
pub fn of_materials(materials: &Materials) -> Vec<Array> {
    let (count, length) = (materials.entries.len(), material::count(materials.order));
    let indices = material::indices(materials.order);
    let indices = indices.flat_map(|(o, p, q)| [o as i64, p as i64, q as i64]);
    vec![
        Array::new("material_names", [count], names(&materials.entries)),
        Array::new("materials", [count, 3, length], channels(&materials.entries)),
        Array::new("material_indices", [length, 3], indices.collect::<Vec<_>>()),
    ]
}

fn names(entries: &[Named]) -> Vec<String> {
    entries.iter().map(|entry| entry.name.clone()).collect()
}

fn channels(entries: &[Named]) -> Vec<f64> {
    entries.iter().flat_map(|entry| entry.rgb.iter().flatten().copied()).collect()
}
