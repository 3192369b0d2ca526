//! Errors of the settings on an image, and of the model: the direct sum of a degree and an order,
//! compared with the BRDF itself integrated under captured maps without any truncation.

use super::images::{Image, Images, Shaded};
use super::numbers::numbers;
use super::scope::modelled;
use super::settings::{Setting, sizes};
use crate::light_tree::LightTree;
use crate::numbers::median;
use crate::reference::{Reference, named};
use crate::sheet::Record;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Measure, Projected};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::{parallel, shipped};
use eigenshade_table::Table;
use eigenshade_testing::largest;
use indicatif::ProgressBar;
use std::path::Path;

/// Of many errors relative to the peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spread {
    pub median: f64,
    /// The 95th percentile: the least of these errors that 95 of 100 do not exceed.
    pub most: f64,
    pub worst: f64,
}

impl Spread {
    pub fn of(values: &[f64]) -> Self {
        let mut sorted = values.to_vec();
        sorted.sort_by(f64::total_cmp);
        let rank = (0.95 * sorted.len() as f64).ceil() as usize;
        let most = sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0);
        // NaN comes last.
        let worst = sorted.last().copied().unwrap_or(0.0);
        Self { median: median(values), most, worst }
    }
}

/// Errors over a sphere, relative to each image's peak.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Errors {
    /// Root mean squares over the normals.
    pub rms: Spread,
    pub largest: Spread,
}

/// The measured errors of a setting.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Over the materials from which the basis was made.
    pub seen: Errors,
    /// Over other materials.
    pub unseen: Errors,
    /// The number of terms of a pixel; the median if it depends on the image.
    pub terms: usize,
    /// The index of an image with that number of terms.
    pub typical: usize,
    /// Bytes in RAM: [`Shaded::bytes`].
    pub bytes: usize,
}

pub fn compare(setting: &Setting, table: &Table, images: &Images) -> Result<Found> {
    let numbers = numbers(setting, table, &images.sphere.normals)?;
    let all = parallel::map(images.images.len(), &(), |k| {
        let image = &images.images[k];
        let Shaded { irradiances, terms, bytes, .. } = numbers.image(&image.pair)?;
        let errors = errors(&irradiances, image, &images.sphere.weights);
        Ok((image.seen, errors, [terms, k, bytes]))
    });
    let all = all.into_iter().collect::<Result<Vec<(bool, [f64; 2], [usize; 3])>>>()?;
    let chosen = |seen| all.iter().filter(move |one| one.0 == seen);
    let of = |seen| {
        let of = |kind: usize| chosen(seen).map(|(_, errors, _)| errors[kind]).collect::<Vec<_>>();
        Errors { rms: Spread::of(&of(0)), largest: Spread::of(&of(1)) }
    };
    let mut by_terms: Vec<[usize; 3]> = chosen(true).map(|(.., costs)| *costs).collect();
    by_terms.sort_unstable();
    let [terms, typical, bytes] = by_terms[by_terms.len() / 2];
    Ok(Found { seen: of(true), unseen: of(false), terms, typical, bytes })
}

/// The rms over the normals and the largest error, relative to the peak.
fn errors(values: &[f64], image: &Image, weights: &[f64]) -> [f64; 2] {
    let off = values.iter().zip(&image.reference).map(|(value, reference)| value - reference);
    let square: f64 = off.clone().zip(weights).map(|(off, weight)| weight * off * off).sum();
    [square.sqrt() / image.peak, largest(off) / image.peak]
}

/// The maps: some are soft, others have a small strong light.
pub const MAPS: [&str; 6] = ["esplanade", "hall", "park", "sky", "studio", "venice"];
const QUICK: [&str; 2] = ["ggx-0.9-0.7", "teflon"];

/// The errors of each surface, or with `quick` of two, at each degree and order, under [`MAPS`].
pub fn rows(folder: &Path, quick: bool, progress: &ProgressBar) -> Result<Vec<Record>> {
    let map = |name: &&str| {
        let path = folder.join(format!("{name}.exr"));
        if !path.is_file() {
            let remedy = "give the folder of the project's maps, tables/inputs/maps, with --maps";
            return Err(Error::new("there is no such map", remedy).in_file(path));
        }
        EnvironmentMap::from_path(path)
    };
    let maps = LightTree::new(&MAPS.iter().map(map).collect::<Result<Vec<_>>>()?)?;
    let lights = named(&shipped::lights()?, MAPS.into_iter())
        .map_err(|error| error.with_remedy("build the program again"))?;
    let mut surfaces = modelled()?;
    surfaces.retain(|surface| !quick || QUICK.contains(&surface.name.as_str()));
    let sizes: Vec<(usize, usize)> = sizes().collect();
    let orders: Vec<usize> = sizes.iter().map(|&(_, order)| order).collect();
    let project = |k: usize| surfaces[k].project_orders(&orders, Measure::Projected);
    let projected = parallel::map(surfaces.len(), &(), project);
    let mut rows = Vec::new();
    for (surface, projected) in surfaces.iter().zip(&projected) {
        let reference = Reference::new(surface, &maps, progress);
        for (&size, Projected { material, .. }) in sizes.iter().zip(projected) {
            // The rms over the sphere and the channels relative to the peak, by map.
            let errors = reference.of_sum(&lights, size, material);
            let mut record = Record::default();
            record.put("surface", &surface.name);
            record.put("degree", size.0);
            record.put("order", size.1);
            let Spread { median, worst, .. } = Spread::of(&errors);
            record.measure("median", median);
            record.measure("worst", worst);
            MAPS.into_iter().zip(&errors).for_each(|(map, &error)| record.measure(map, error));
            rows.push(record);
        }
    }
    Ok(rows)
}

/// The errors of a degree and an order over all surfaces and maps.
pub fn spread(rows: &[Record], size: (usize, usize)) -> Spread {
    let errors = of_size(rows, size).flat_map(|row| MAPS.iter().filter_map(|map| row.number(map)));
    Spread::of(&errors.collect::<Vec<f64>>())
}

pub fn of_size(rows: &[Record], (degree, order): (usize, usize)) -> impl Iterator<Item = &Record> {
    let size = [degree, order].map(|one| one.to_string());
    rows.iter().filter(move |row| ["degree", "order"].map(|column| row.text(column)) == size)
}

#[cfg(test)]
mod tests {
    use super::Spread;

    #[test]
    fn ninety_five_of_a_hundred_do_not_exceed_the_percentile() {
        let values: Vec<f64> = (1..=100).rev().map(f64::from).collect();
        assert_eq!(Spread::of(&values), Spread { median: 50.5, most: 95.0, worst: 100.0 });
        assert_eq!(Spread::of(&values[..20]).most, 99.0);
        assert_eq!(Spread::of(&values[..1]).most, 100.0);
        assert_eq!(Spread::of(&[]).most, 0.0);
        assert!(Spread::of(&[1.0, f64::NAN]).worst.is_nan());
    }
}
