//! The eigenbasis for arbitrary normals and arbitrary light statistics, where neither M nor V_c is
//! block diagonal in the azimuth.
//!
//! Images use the coordinates a of the sphere's [`Span`]. Energies over the object's normals use
//! the coordinates y of `observed`. The eigenimages W are the left singular vectors of the
//! database's images in y, and U = A⁺W.

use crate::basis::canonical::{Functions, settle};
use crate::basis::choice::{Choice, Remaining};
use crate::basis::database::{fitted, in_range, material_weights, peak};
use crate::basis::eigenimages::REPORTED;
use crate::basis::gram;
use crate::basis::moments::LightStatistics;
use crate::basis::moments::MaterialMoments;
use crate::basis::observed::Observed;
use crate::basis::pca::principal;
use crate::basis::span::{Function, Span};
use crate::object::geometry::Geometry;
use eigenshade_model::database;
use eigenshade_model::database::{Lights, Materials};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::selection::{self, Kept};
use eigenshade_table::scene::{Criterion, Store};
use eigenshade_table::{General, GramFactor, Scene, Summary, Table};
use faer::Mat;

/// Singular values below this fraction of the root of the database's energy are rounding.
const ROUNDING: f64 = 1e-14;

/// Allowed deviation from 1 of the root mean square of the constant image; the cut-offs cause it.
const CONSTANT: f64 = 1e-8;

/// Makes the table of a scene whose normals or light lack the symmetry of a sphere under any
/// rotation.
///
/// # Errors
///
/// The errors of [`crate::basis::build`]; also a scene whose `store` is "materials" or that has a
/// `trim`.
pub fn build(
    scene: &Scene,
    geometry: &Geometry,
    lights: &Lights,
    materials: &Materials,
) -> Result<Table> {
    chosen(scene, geometry, lights, materials).map(|(table, _)| table)
}

/// Like [`build`], and also reports how many components were chosen if the scene gives a tolerance.
///
/// # Errors
///
/// The errors of [`build`].
pub fn chosen(
    scene: &Scene,
    geometry: &Geometry,
    lights: &Lights,
    materials: &Materials,
) -> Result<(Table, Option<Choice>)> {
    if scene.basis.store == Store::Materials {
        return Err(Error::new(
            format!(
                "basis.store = \"{}\" is not supported for this object or light",
                scene.basis.store.name()
            ),
            "leave it out, or set store = \"projection\"",
        ));
    }
    if scene.basis.trim.is_some() {
        return Err(Error::new(
            "basis.trim is not supported for this object or light",
            "leave it out",
        ));
    }
    let (lights, materials) = fitted(scene, lights, materials)?;
    let light = {
        let weights = database::weights(&lights.entries, &scene.light.weights)?;
        let (normalize, rotation) = (scene.light.normalize, scene.light.rotation);
        LightStatistics::new(&lights, normalize, rotation, &weights)?
    };
    let material = {
        let weights = material_weights(scene, &lights, &materials)?;
        MaterialMoments::weighted(&materials, weights)
    };
    let gram = gram::of_sphere(scene.degree(), scene.order());
    let kept = Kept { selection: selection::highest(&gram, scene.basis.modes) };
    let span = Span::new(&gram, &kept)?;
    let cutoff = scene.basis.rank_cutoff;
    let observed = Observed::new(&span, geometry, cutoff)?;

    let criterion = scene.basis.criterion;
    let images = observed.shown(&deviations(&span, &gram, &light, &material, criterion));
    in_range(images.norm_l2())?;
    let centered = criterion == Criterion::ImageCentered;
    let constant = if centered { constant(&span, &observed, &gram)? } else { Vec::new() };
    let found = principal(&images, centered.then_some(constant.as_slice()), 0)?;
    let strongest = found.singular_values.first().copied().unwrap_or(0.0);
    let weakest = (ROUNDING * images.norm_l2()).max(cutoff * strongest);
    let count = found.singular_values.iter().filter(|value| **value > weakest).count();

    let mut eigenvalues: Vec<Option<f64>> = vec![None; usize::from(centered)];
    eigenvalues.extend(found.singular_values[..count].iter().map(|value| Some(value * value)));
    let mut shown = Mat::zeros(images.nrows(), eigenvalues.len());
    for (column, _) in eigenvalues.iter().enumerate() {
        let number = column.checked_sub(usize::from(centered));
        for row in 0..shown.nrows() {
            shown[(row, column)] = match number {
                Some(number) => found.coordinates[(row, number)],
                None => constant[row],
            };
        }
    }
    let shown = settled(&span, &observed, shown, &eigenvalues);

    let ranks = span.azimuths.iter().map(|of| of.block.rank(cutoff * span.largest()));
    let energy: f64 = found.singular_values.iter().rev().map(|value| value * value).sum();
    let mut table = Table {
        summary: Summary {
            ranks: ranks.collect(),
            largest_singular_value: span.largest(),
            lights: lights.entries.len(),
            materials: materials.entries.len(),
            energy,
            energy_kept: 1.0,
            orthonormality: 0.0,
            roundings: Vec::new(),
        },
        scene: scene.clone(),
        selection: kept.selection,
        components: span.components(),
        profiles: Vec::new(),
        mean: None,
        spectrum: eigenvalues.iter().map(|value| (None, *value)).collect(),
        general: None,
        transfers: Vec::new(),
        gram,
    };
    let choice = match (scene.basis.components, scene.basis.tolerance) {
        (None, Some(tolerance)) => {
            let peak = peak(scene, &lights, &materials)?;
            Some(Choice::of_components(tolerance, peak, &Remaining::new(&table.spectrum, 0.0)))
        }
        _ => None,
    };
    let wanted = match &choice {
        Some(choice) => choice.components.kept,
        None => scene.basis.components.unwrap_or(usize::MAX),
    };
    let kept = wanted.min(eigenvalues.len());
    let shown = shown.get(.., ..kept).to_owned();
    eigenvalues.truncate(kept);
    let rank = observed.rank(cutoff);
    let projection = observed.projection(&shown);
    let (mean, mean_coefficients) = match criterion {
        Criterion::ImageCentered => (Vec::new(), Vec::new()),
        Criterion::Standard => {
            let mean = span.image(&span.transfer(&table.gram, &material.mean), &light.mean);
            let coefficients = &projection * column(&mean);
            (mean, coefficients.col(0).iter().copied().collect())
        }
    };
    let images = observed.images(&shown);
    table.profiles =
        span.table_profiles(&table.gram, scene.basis.profile_tolerance, &images, &mean);
    table.summary.orthonormality = observed.orthonormality(&shown, rank, REPORTED);
    if energy > 0.0 {
        table.summary.energy_kept = (1.0 - table.energy_left(kept) / energy).max(0.0);
    }
    table.general = Some(General {
        normals: match geometry {
            Geometry::Sphere => 0,
            Geometry::Listed(listed) => listed.normals().len(),
        },
        rank,
        eigenvalues,
        projection: rows(&projection),
        synthesis: columns(&images),
        modes: columns(&observed.modes(&shown, rank)),
        mean,
        mean_coefficients,
    });
    // No transfers are kept, so no materials are needed.
    table.keep(std::iter::empty());
    Ok((table, choice))
}

/// Puts the eigenimages into canonical order and sign.
fn settled(
    span: &Span,
    observed: &Observed,
    mut shown: Mat<f64>,
    eigenvalues: &[Option<f64>],
) -> Mat<f64> {
    let mut coordinates = observed.images(&shown);
    let pole = |function: Function| -> f64 {
        let of = &span.azimuths[function.order.unsigned_abs() as usize];
        of.chebyshev.col(function.profile).iter().sum()
    };
    let functions = Functions {
        orders: span.functions().map(|function| function.order).collect(),
        poles: span.functions().map(pole).collect(),
    };
    settle(&mut shown, &mut coordinates, eigenvalues, &functions);
    shown
}

/// The constant image in y, as a unit vector.
///
/// # Errors
///
/// If the modes cannot represent it.
fn constant(span: &Span, observed: &Observed, gram: &GramFactor) -> Result<Vec<f64>> {
    let coordinates = span.constant(gram);
    let shown = observed.shown(&column(&coordinates));
    let norm = shown.norm_l2();
    if (norm - 1.0).abs() > CONSTANT {
        return Err(Error::new(
            "the constant image is not a sum of the kept modes",
            "keep more modes, or use a lower rank_cutoff or criterion = \"standard\"",
        ));
    }
    Ok(shown.col(0).iter().map(|value| value / norm).collect())
}

fn column(values: &[f64]) -> Mat<f64> {
    Mat::from_fn(values.len(), 1, |k, _| values[k])
}

/// Coordinates in the span of the images of the factor of V_c ([`Criterion::ImageCentered`]) or of
/// Σ_c ([`Criterion::Standard`]). Light and material are independent, so Σ_c = Cov(L) (x) E{bbᵀ} +
/// E{L}E{L}ᵀ (x) Cov(b).
fn deviations(
    span: &Span,
    gram: &GramFactor,
    light: &LightStatistics,
    materials: &MaterialMoments,
    criterion: Criterion,
) -> Mat<f64> {
    let mut columns = Vec::new();
    for (material, root) in materials.rooted() {
        let scaled: Vec<f64> = material.iter().map(|b| root * b).collect();
        let transfer = span.transfer(gram, &scaled);
        let vectors = match criterion {
            Criterion::ImageCentered => &light.second,
            Criterion::Standard => &light.centered,
        };
        columns.extend(vectors.iter().map(|vector| span.image(&transfer, vector)));
        if criterion == Criterion::Standard {
            let deviations = material.iter().zip(&materials.mean);
            let deviation: Vec<f64> = deviations.map(|(b, mean)| root * (b - mean)).collect();
            columns.push(span.image(&span.transfer(gram, &deviation), &light.mean));
        }
    }
    Mat::from_fn(span.dimension(), columns.len(), |k, t| columns[t][k])
}

/// The entries in row-major order.
fn rows(matrix: &Mat<f64>) -> Vec<f64> {
    (0..matrix.nrows()).flat_map(|i| (0..matrix.ncols()).map(move |j| matrix[(i, j)])).collect()
}

/// The entries in column-major order.
fn columns(matrix: &Mat<f64>) -> Vec<f64> {
    (0..matrix.ncols()).flat_map(|j| (0..matrix.nrows()).map(move |i| matrix[(i, j)])).collect()
}
