//! Computes the eigenbasis of a scene, from its databases to its table.

pub(crate) mod analysis;
pub mod canonical;
pub mod choice;
pub mod database;
pub(crate) mod eigenimages;
pub mod estimate;
pub mod gram;
pub mod moments;
pub mod pca;
pub mod profile;

pub use crate::basis::eigenimages::orthonormality;

use crate::basis::analysis::Analysis;
use crate::basis::choice::Choice;
use crate::basis::database::fitted;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_table::trim::trim;
use eigenshade_table::{Scene, Table};

/// Makes the table of a scene from lights and materials that reach at least the scene's degree and
/// order.
///
/// # Errors
///
/// If a database is empty or does not reach the scene's degree and order, a light cannot be
/// normalized, a number is not finite, an image is below 1e-120 or above 1e140, or the scene's
/// cut-offs prevent meeting the tolerance.
pub fn build(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<Table> {
    chosen(scene, lights, materials).map(|(table, _)| table)
}

/// Like [`build`], and also reports what was chosen if the scene gives a tolerance. The scene in
/// the table then has the chosen degree and order.
///
/// # Errors
///
/// The errors of [`build`].
pub fn chosen(
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Table, Option<Choice>)> {
    let (lights, materials) = fitted(scene, lights, materials)?;
    let basis = &scene.basis;
    let (mut table, choice) = match (basis.components, basis.tolerance) {
        (None, Some(tolerance)) => {
            let (table, choice) = choice::within(tolerance, scene, &lights, &materials)?;
            (table, Some(choice))
        }
        (components, _) => {
            let analysis = Analysis::new(scene, &lights, &materials)?;
            let count = components.unwrap_or(usize::MAX);
            let mut table = analysis.table(count, basis.profile_tolerance);
            if let Some(share) = basis.trim {
                trim(&mut table, share);
            }
            (table, None)
        }
    };
    let mut materials = materials.truncated(table.gram.order);
    if !scene.effects.color {
        materials.entries.iter_mut().for_each(Named::remove_color);
    }
    table.keep(materials.entries.iter().map(named_channels));
    Ok((table, choice))
}

fn named_channels(one: &Named) -> (&str, [&[f64]; 3]) {
    (&one.name, one.rgb.each_ref().map(Vec::as_slice))
}
