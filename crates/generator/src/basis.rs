//! The eigenbasis of one scene, from its databases to its table.

use crate::canonical::{self, Ranked};
use crate::database::{Lights, Materials, Named};
use crate::eigenimages::{Azimuth, Selected, constant_coordinates};
use crate::error::{Error, Result};
use crate::moments::{self, LightMoments, MaterialMoments};
use crate::pca::{Block, principal};
use crate::selection::{self, Kept};
use crate::{database, gram, peak, profile};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{GramFactor, MeanImage, Scene, Summary, Table};
use rayon::iter::{IntoParallelIterator, ParallelIterator};

/// Components whose orthonormality is reported.
const REPORTED: usize = 100;

/// Singular values below this are rounding, relative to the root of the database's
/// energy, the constant counted: forty columns of sums.
const ROUNDING: f64 = 1e-14;

/// Sizes of images whose squares f64 holds.
const RANGE: std::ops::Range<f64> = 1e-120..1e140;

/// Makes the table of a scene from its lights and materials, which hold at least
/// the scene's degree and order.
///
/// # Errors
///
/// Empty databases or ones that do not reach the scene's degree and order, lights
/// that cannot be normalised, numbers that are not finite, images below 1e-120 or
/// above 1e140.
pub fn build(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<Table> {
    let (lights, materials) = fitted(scene, lights, materials)?;
    let criterion = scene.basis.criterion;
    let weights = database::weights(&lights.entries, &scene.light.weights)?;
    let moments = LightMoments::weighted(&lights, scene.light.normalise, &weights)?;
    let weights = database::weights(&materials.entries, &scene.material.weights)?;
    let of_materials = MaterialMoments::weighted(&materials, weights);
    let gram = gram::of_sphere(scene.degree(), scene.order());
    let effects = scene.effects.set();
    let kept = Kept { effects, selection: selection::highest(&gram, effects, scene.basis.modes) };
    let azimuths: Vec<Result<Azimuth>> = (0..=gram.degree)
        .into_par_iter()
        .map(|azimuth| analyse(&gram, &kept, &moments, &of_materials, criterion, azimuth))
        .collect();
    // Of several faults the first, whichever was found first.
    let azimuths = azimuths.into_iter().collect::<Result<Vec<_>>>()?;

    let largest_of = |values: fn(&Azimuth) -> &[f64]| {
        azimuths.iter().flat_map(values).copied().fold(0.0, f64::max)
    };
    let largest = largest_of(|azimuth| &azimuth.block.singular_values);
    let cutoff = scene.basis.rank_cutoff;
    let threshold = cutoff * largest;
    let whole = moments::deviations(&moments, &of_materials, effects, Criterion::ImageCentered, 0);
    let size = azimuths[0].block.images(&gram, &whole).norm_l2();
    in_range(size)?;
    let rounding = ROUNDING * size;
    let strongest = largest_of(|azimuth| &azimuth.principal.singular_values);
    let weakest = rounding.max(cutoff * strongest);
    let ranked = ranked(&azimuths, criterion, weakest);
    let spectrum: Vec<(Option<i32>, Option<f64>)> = ranked
        .iter()
        .flat_map(|profile| {
            let orders = canonical::orders(profile.azimuth).iter();
            orders.map(|sign| (Some(sign * profile.azimuth as i32), profile.eigenvalue))
        })
        .collect();

    let mut table = Table {
        summary: Summary {
            ranks: azimuths.iter().map(|azimuth| azimuth.block.rank(threshold)).collect(),
            largest_singular_value: largest,
            lights: lights.entries.len(),
            materials: materials.entries.len(),
            energy: 0.0,
            energy_kept: 1.0,
            orthonormality: 0.0,
        },
        scene: scene.clone(),
        gram,
        selection: kept.selection,
        components: Vec::new(),
        profiles: Vec::new(),
        mean: None,
        spectrum,
        general: None,
        transfers: Vec::new(),
    };
    let count = match (scene.basis.components, scene.basis.tolerance) {
        (Some(components), _) => components,
        (None, None) => table.spectrum.len(),
        (None, Some(tolerance)) => peak::components_for(&table, &lights, &materials, tolerance)?,
    };
    Selected::new(&azimuths, &ranked, count).write(&mut table, &azimuths, threshold);
    if criterion == Criterion::Standard {
        table.mean = Some(mean_image(&table, &azimuths[0], &moments, &of_materials));
    }
    summarise(&mut table, &azimuths);
    table.keep(materials.entries.iter().map(named_channels));
    Ok(table)
}

/// The databases up to a scene's degree and order.
///
/// # Errors
///
/// If there are no materials, or they or the lights do not reach that far.
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

/// Whether eigenvalues, squares of `size` down to those of its rounding, are numbers.
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

fn analyse(
    gram: &GramFactor,
    kept: &Kept,
    light: &LightMoments,
    materials: &MaterialMoments,
    criterion: Criterion,
    azimuth: usize,
) -> Result<Azimuth> {
    let block = Block::new(gram, azimuth, |l, o, p, q| kept.keeps(gram, azimuth, (l, o, p, q)))?;
    let deviations = moments::deviations(light, materials, kept.effects, criterion, azimuth);
    let images = block.images(gram, &deviations);
    let constant = (criterion == Criterion::ImageCentered && azimuth == 0)
        .then(|| constant_coordinates(gram, &block));
    let principal = principal(&images, constant.as_deref(), azimuth)?;
    Ok(Azimuth { block, principal })
}

/// All profiles whose singular value exceeds `weakest`, in canonical order.
fn ranked(azimuths: &[Azimuth], criterion: Criterion, weakest: f64) -> Vec<Ranked> {
    let mut ranked = Vec::new();
    if criterion == Criterion::ImageCentered {
        ranked.push(Ranked { azimuth: 0, number: usize::MAX, eigenvalue: None });
    }
    for azimuth in azimuths {
        for (number, value) in azimuth.principal.singular_values.iter().enumerate() {
            if *value > weakest {
                let eigenvalue = Some(value * value);
                ranked.push(Ranked { azimuth: azimuth.block.azimuth, number, eigenvalue });
            }
        }
    }
    canonical::sort(&mut ranked);
    ranked
}

/// The mean image, E{L_0^0} times the ambient image of the mean material.
fn mean_image(
    table: &Table,
    azimuth: &Azimuth,
    light: &LightMoments,
    materials: &MaterialMoments,
) -> MeanImage {
    let mut material = materials.mean.clone();
    material.iter_mut().for_each(|b| *b *= light.ambient_mean);
    let mut deviation = moments::Deviation { degree: 0, material };
    deviation.leave(table.effects());
    let coordinates = azimuth.block.images(&table.gram, &[deviation]);
    let series: Vec<f64> =
        azimuth.block.space.chebyshev(&coordinates).col(0).iter().copied().collect();
    let node_values = azimuth.block.space.node_values(&coordinates);
    let coefficients = table
        .components
        .iter()
        .map(|component| match component.order {
            0 => table.profiles[component.profile]
                .node_values
                .iter()
                .zip(node_values.col(0).iter())
                .map(|(a, b)| a * b)
                .sum(),
            _ => 0.0,
        })
        .collect();
    let length = profile::trimmed_length(&series, 0, table.scene.basis.profile_tolerance);
    MeanImage { chebyshev: series[..length].to_vec(), coefficients }
}

/// Energies and orthonormality, once the table is complete.
fn summarise(table: &mut Table, azimuths: &[Azimuth]) {
    let squares = |azimuth: &Azimuth| {
        let signs = if azimuth.block.azimuth == 0 { 1.0 } else { 2.0 };
        let sum: f64 = azimuth.principal.singular_values.iter().rev().map(|x| x * x).sum();
        signs * sum
    };
    let energy: f64 = azimuths.iter().map(squares).sum();
    table.summary.energy = energy;
    if energy > 0.0 {
        let left = table.energy_left(table.components.len());
        table.summary.energy_kept = (1.0 - left / energy).max(0.0);
    }
    table.summary.orthonormality = orthonormality(table, REPORTED);
}

/// Largest |UᵀMU - I| over the first `count` components, through AU: M itself is
/// never formed. Domain: a table that has U over modes.
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

/// A times mode coefficients: weighted node values.
fn image(columns: &[Vec<f64>], modes: &[f64]) -> Vec<f64> {
    let mut image = vec![0.0; columns.first().map_or(0, Vec::len)];
    for (column, coefficient) in columns.iter().zip(modes) {
        for (pixel, value) in image.iter_mut().zip(column) {
            *pixel += coefficient * value;
        }
    }
    image
}
