//! The eigenbasis of one scene, from its databases to its table.

use crate::canonical::{self, Ranked};
use crate::database::{Lights, Materials};
use crate::error::Result;
use crate::moments::{self, LightMoments};
use crate::pca::{Block, Principal, principal};
use crate::{gram, peak, profile, selection};
use eigenshade_index::{material, pair};
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Component, GramFactor, MeanImage, Profile, Scene, Summary, Table};
use faer::Mat;

/// Components whose orthonormality is reported.
const REPORTED: usize = 100;

/// Everything known of one azimuth.
struct Azimuth {
    block: Block,
    principal: Principal,
}

/// Makes the table of a scene from its lights and materials, which hold at least
/// the scene's degree and order.
///
/// # Errors
///
/// Empty databases, lights that cannot be normalised, numbers that are not
/// finite.
pub fn build(scene: &Scene, lights: &Lights, materials: &Materials) -> Result<Table> {
    let (degree, order) = (scene.light.degree, scene.material.order);
    let (lights, materials) = (lights.truncated(degree), materials.truncated(order));
    let criterion = scene.basis.criterion;
    let moments = LightMoments::new(&lights, scene.light.normalise)?;
    let gram = gram::of_sphere(degree, order);
    let kept = selection::highest(&gram, scene.basis.modes);
    let azimuths: Vec<Azimuth> = (0..=degree)
        .map(|azimuth| analyse(&gram, &kept, &moments, &materials, criterion, azimuth))
        .collect::<Result<_>>()?;

    let largest_of = |values: fn(&Azimuth) -> &[f64]| {
        azimuths.iter().flat_map(|azimuth| values(azimuth)).copied().fold(0.0, f64::max)
    };
    let largest = largest_of(|azimuth| &azimuth.block.singular_values);
    let cutoff = scene.basis.rank_cutoff;
    let threshold = cutoff * largest;
    let weakest = cutoff * largest_of(|azimuth| &azimuth.principal.singular_values);
    let ranked = ranked(&azimuths, criterion, weakest);
    let spectrum: Vec<(i32, Option<f64>)> = ranked
        .iter()
        .flat_map(|profile| {
            let orders = canonical::orders(profile.azimuth).iter();
            orders.map(|sign| (sign * profile.azimuth as i32, profile.eigenvalue))
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
        selection: kept,
        components: Vec::new(),
        profiles: Vec::new(),
        mean: None,
        spectrum,
    };
    let count = match (scene.basis.components, scene.basis.tolerance) {
        (Some(components), _) => components,
        (None, None) => table.spectrum.len(),
        (None, Some(tolerance)) => {
            // The peaks are those of whole images, so they ask for all components.
            let all = Selected::new(&azimuths, &ranked, usize::MAX);
            all.write(&mut table, &azimuths, threshold);
            peak::components_for(&table, &lights, &materials, tolerance)?
        }
    };
    Selected::new(&azimuths, &ranked, count).write(&mut table, &azimuths, threshold);
    if criterion == Criterion::Standard {
        table.mean = Some(mean_image(&table, &azimuths[0], &moments, &materials));
    }
    summarise(&mut table, &azimuths);
    Ok(table)
}

fn analyse(
    gram: &GramFactor,
    kept: &[bool],
    light: &LightMoments,
    materials: &Materials,
    criterion: Criterion,
    azimuth: usize,
) -> Result<Azimuth> {
    let modes = material::count(gram.order);
    let block = Block::new(gram, azimuth, |l, o, p, q| {
        let row = azimuth * modes + material::position(o, p, q);
        kept.is_empty() || kept[row * (gram.degree + 1) + l]
    })?;
    let deviations = moments::deviations(light, materials, criterion, azimuth);
    let images = block.images(gram, &deviations);
    let constant = (criterion == Criterion::ImageCentered && azimuth == 0)
        .then(|| constant_coordinates(gram, &block));
    let principal = principal(&images, constant.as_deref(), azimuth)?;
    Ok(Azimuth { block, principal })
}

/// Coordinates of the image that is 1 everywhere, a unit vector.
fn constant_coordinates(gram: &GramFactor, block: &Block) -> Vec<f64> {
    let ones = Mat::from_fn(gram.nodes.len(), 1, |k, _| gram.root_weights[k]);
    block.space.coordinates(&ones).col(0).iter().copied().collect()
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

/// The components that a table takes, and the profiles that they need.
struct Selected {
    components: Vec<Component>,
    profiles: Vec<Ranked>,
}

impl Selected {
    fn new(azimuths: &[Azimuth], ranked: &[Ranked], count: usize) -> Self {
        let mut profiles = Vec::new();
        let mut taken: Vec<(Ranked, i32)> = Vec::new();
        for profile in ranked {
            if taken.len() >= count {
                break;
            }
            profiles.push(*profile);
            let orders = canonical::orders(profile.azimuth).iter();
            taken.extend(
                orders
                    .take(count - taken.len())
                    .map(|sign| (*profile, sign * profile.azimuth as i32)),
            );
        }
        // Stable: within an azimuth the canonical order stays.
        profiles.sort_by_key(|profile| profile.azimuth);
        debug_assert!(profiles.iter().all(|profile| profile.azimuth < azimuths.len()));
        let place = |wanted: &Ranked| {
            profiles.iter().position(|profile| profile == wanted).expect("it was pushed above")
        };
        let components = taken
            .iter()
            .map(|(profile, order)| Component {
                order: *order,
                profile: place(profile),
                eigenvalue: profile.eigenvalue,
            })
            .collect();
        Self { components, profiles }
    }

    /// Writes components and profiles into the table.
    fn write(self, table: &mut Table, azimuths: &[Azimuth], threshold: f64) {
        let tolerance = table.scene.basis.profile_tolerance;
        table.components = self.components;
        table.profiles = self
            .profiles
            .iter()
            .map(|ranked| {
                let azimuth = &azimuths[ranked.azimuth];
                let coordinates = coordinates(&table.gram, azimuth, ranked);
                profile(&table.gram, &azimuth.block, &coordinates, tolerance, threshold)
            })
            .collect();
    }
}

/// The coordinates of one ranked profile, a column, with canonical sign.
fn coordinates(gram: &GramFactor, azimuth: &Azimuth, ranked: &Ranked) -> Mat<f64> {
    let vector: Vec<f64> = match ranked.eigenvalue {
        None => constant_coordinates(gram, &azimuth.block),
        Some(_) => azimuth.principal.coordinates.col(ranked.number).iter().copied().collect(),
    };
    let column = Mat::from_fn(vector.len(), 1, |i, _| vector[i]);
    let series = azimuth.block.space.chebyshev(&column);
    let sign = canonical::sign(&series.col(0).iter().copied().collect::<Vec<_>>());
    Mat::from_fn(vector.len(), 1, |i, _| sign * vector[i])
}

fn profile(
    gram: &GramFactor,
    block: &Block,
    coordinates: &Mat<f64>,
    tolerance: f64,
    threshold: f64,
) -> Profile {
    let first = |matrix: Mat<f64>| matrix.col(0).iter().copied().collect::<Vec<f64>>();
    let mut chebyshev = first(block.space.chebyshev(coordinates));
    chebyshev.truncate(profile::trimmed_length(&chebyshev, block.azimuth, tolerance));
    let node_values = first(block.space.node_values(coordinates));
    Profile {
        azimuth: block.azimuth,
        factors: factors(gram, block.azimuth, &node_values),
        modes: first(block.mode_coefficients(coordinates, threshold)),
        chebyshev,
        node_values,
    }
}

/// UᵀM of one profile, factored: see [`Profile::factors`].
fn factors(gram: &GramFactor, azimuth: usize, node_values: &[f64]) -> Vec<f64> {
    let nodes = node_values.len();
    let weighted: Vec<f64> =
        node_values.iter().zip(&gram.root_weights).map(|(value, root)| value * root).collect();
    let mut factors = Vec::new();
    for l in azimuth..=gram.degree {
        for (pair, (p, q)) in pair::indices(gram.order).enumerate() {
            if q > l {
                factors.push(0.0);
                continue;
            }
            let radials = &gram.radials[pair * nodes..(pair + 1) * nodes];
            let rotation = gram.rotation(azimuth, l, q);
            let sum: f64 =
                weighted.iter().zip(radials).zip(rotation).map(|((w, r), d)| w * r * d).sum();
            let sign = if q % 2 == 0 { 1.0 } else { -1.0 };
            factors.push(sign * ((p + 1) as f64).sqrt() * sum);
        }
    }
    factors
}

/// The mean image, E{L_0^0} times the ambient image of the mean material.
fn mean_image(
    table: &Table,
    azimuth: &Azimuth,
    light: &LightMoments,
    materials: &Materials,
) -> MeanImage {
    let mut material = moments::material_mean(materials);
    material.iter_mut().for_each(|b| *b *= light.ambient_mean);
    let deviation = moments::Deviation { degree: 0, material };
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
        table.summary.energy_kept = 1.0 - table.energy_left(table.components.len()) / energy;
    }
    table.summary.orthonormality = orthonormality(table, REPORTED);
}

/// Largest |UᵀMU - I| over the first `count` components, through AU: M itself is
/// never formed.
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
