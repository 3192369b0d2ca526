//! Lights on materials as arrays: their coefficients in a table's eigenimages, and their pictures.

use super::array::Array;
use super::shown::Shown;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::Result;
use eigenshade_shading::overflow;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader, fault};
use eigenshade_table::Table;

/// The numbers in the arrays of this many pairs of a light and a material at this many normals.
#[must_use]
pub fn size(table: &Table, pairs: usize, normals: usize) -> usize {
    3 * pairs * (table.count() + normals)
}

/// d of each light on each material, channel by channel; and, for normals, the irradiances. Fails
/// if the table cannot project a material, or a result is not finite.
pub fn arrays(
    table: &Table,
    (lights, materials): (&Lights, &Materials),
    shown: Option<&Shown>,
) -> Result<Vec<Array>> {
    let basis = OwnedBasis::<f64>::new(table);
    let mut shader =
        Shader::new(basis.any().map_err(fault)?, table.count()).with_transfers(basis.transfers());
    let normals = shown.map(|shown| OwnedNormals::new(&shown.normals));
    let (mut coefficients, mut images) = (Vec::<f64>::new(), Vec::<f64>::new());
    for light in &lights.entries {
        for material in &materials.entries {
            let named =
                |error: eigenshade_model::error::Error| error.of(overflow::pair(light, material));
            for channel in 0..3 {
                let (of_light, of_material) = (&light.rgb[channel], &material.rgb[channel]);
                coefficients.extend(shader.project(of_light, of_material).map_err(named)?);
                if let Some(normals) = &normals {
                    let image = shader.polynomial(of_light, of_material, normals);
                    images.extend(image.map_err(named)?);
                }
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
