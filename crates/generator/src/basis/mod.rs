//! Computes the eigenbasis of a scene, from its databases to its table.

pub(crate) mod analysis;
pub mod canonical;
pub mod choice;
pub(crate) mod eigenimages;
pub mod estimate;
pub mod general;
pub mod gram;
pub mod moments;
pub mod node_image;
pub(crate) mod observed;
pub mod partial_sum;
pub mod pca;
pub mod peak;
pub mod profile;
pub mod representation;
pub(crate) mod settle;
pub mod span;
pub(crate) mod span_table;

use crate::basis::analysis::Analysis;
use crate::basis::choice::Choice;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::reduce::cut;
use eigenshade_table::{Scene, Table};

/// Number of components whose orthonormality is reported.
pub(crate) const REPORTED: usize = 100;

/// Range of image sizes whose squares fit in f64.
const RANGE: std::ops::Range<f64> = 1e-120..1e140;

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
            if let Some(wanted) = basis.cut {
                cut(&mut table, wanted);
            }
            (table, None)
        }
    };
    let mut materials = materials.truncated(table.gram.order);
    if !scene.effects.color {
        materials.entries.iter_mut().for_each(Named::lose_color);
    }
    table.keep(materials.entries.iter().map(named_channels));
    Ok((table, choice))
}

/// Truncates the databases to a scene's degree and order.
///
/// # Errors
///
/// If there are no materials, or if the materials or lights do not reach the degree and order.
pub(crate) fn fitted(
    scene: &Scene,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Lights, Materials)> {
    let (degree, order) = (scene.degree(), scene.order());
    if materials.entries.is_empty() {
        return Err(Error::new("no materials", "give a material database with at least one"));
    }
    if lights.degree < degree || materials.order < order {
        let (found, of) = (lights.degree, materials.order);
        let what = format!("lights of degree {found} and materials of order {of}");
        return Err(Error::new(what, format!("ask for no more than that: not {degree}, {order}")));
    }
    Ok((lights.truncated(degree), materials.truncated(order)))
}

/// Checks that images of this size have eigenvalues in range, from the square of `size` down to the
/// square of its rounding.
pub(crate) fn in_range(size: f64) -> Result<()> {
    if size == 0.0 || RANGE.contains(&size) {
        return Ok(());
    }
    Err(Error::new(
        format!("images of size {size:e}, whose squares are out of range"),
        "scale the lights or the materials, towards 1",
    ))
}

fn named_channels(one: &Named) -> (&str, [&[f64]; 3]) {
    (&one.name, one.rgb.each_ref().map(Vec::as_slice))
}

/// Largest |UᵀMU - I| over the first `count` components, computed from AU without forming M.
/// Domain: a table that stores U over modes.
#[must_use]
pub fn orthonormality(table: &Table, count: usize) -> f64 {
    let mut worst: f64 = 0.0;
    for azimuth in 0..=table.gram.degree {
        let wanted: Vec<usize> = (0..table.profiles.len())
            .filter(|&k| {
                let first = table.components.iter().position(|component| component.profile == k);
                table.profiles[k].azimuth == azimuth && first.is_some_and(|first| first < count)
            })
            .collect();
        let columns = table.gram.columns(azimuth);
        let images: Vec<Vec<f64>> =
            wanted.iter().map(|&k| image(&columns, &table.profiles[k].modes)).collect();
        for (i, a) in images.iter().enumerate() {
            for (j, b) in images.iter().enumerate().take(i + 1) {
                let product: f64 = a.iter().zip(b).map(|(a, b)| a * b).sum();
                worst = worst.max((product - f64::from(u8::from(i == j))).abs());
            }
        }
    }
    worst
}

/// A times mode coefficients, which gives weighted node values.
fn image(columns: &[Vec<f64>], modes: &[f64]) -> Vec<f64> {
    let mut image = vec![0.0; columns.first().map_or(0, Vec::len)];
    for (column, coefficient) in columns.iter().zip(modes) {
        for (pixel, value) in image.iter_mut().zip(column) {
            *pixel += coefficient * value;
        }
    }
    image
}
