//! Lights on materials as arrays: their coefficients in a table's eigenimages, and their pictures.

use super::array::Array;
use super::shown::Shown;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_model::overflow;
use eigenshade_table::Table;

/// The numbers in the arrays of this many pairs of a light and a material at this many normals, and
/// in the eigenimages that they are computed from.
#[must_use]
pub fn size(table: &Table, pairs: usize, normals: usize) -> usize {
    3 * pairs * (table.count() + normals) + table.count() * normals
}

/// d of each light on each material, channel by channel; and, for normals, the irradiances. Fails
/// if the table cannot project a material, or a result is not finite.
pub fn arrays(
    table: &Table,
    (lights, materials): (&Lights, &Materials),
    shown: Option<&Shown>,
) -> Result<Vec<Array>> {
    let evaluator = Evaluator::new(table);
    let eigenimages = shown.map(|shown| evaluator.eigenimages(&shown.normals));
    let (mut coefficients, mut images) = (Vec::<f64>::new(), Vec::<f64>::new());
    for light in &lights.entries {
        for material in &materials.entries {
            let named =
                |error: eigenshade_model::error::Error| error.of(overflow::pair(light, material));
            for channel in 0..3 {
                let (of_light, of_material) = (&light.rgb[channel], &material.rgb[channel]);
                let checked = |numbers| overflow::checked(numbers, of_light, of_material);
                let d = evaluator.project(of_light, of_material).and_then(checked);
                let d = d.map_err(named)?;
                if let Some(eigenimages) = &eigenimages {
                    images.extend(checked(eigenimages.reconstruct(&d)).map_err(named)?);
                }
                coefficients.extend(d);
            }
        }
    }
    let (light, material) = (lights.entries.len(), materials.entries.len());
    let mut arrays =
        vec![Array::new("coefficients", [light, material, 3, table.count()], coefficients)];
    if let Some(shown) = shown {
        arrays.push(Array::new("images", [light, material, 3, shown.normals.len()], images));
        arrays.extend(shown.arrays());
    }
    Ok(arrays)
}
