//! The error of the model: the direct sum of a degree and an order, compared with the BRDF itself
//! integrated under captured maps without any truncation.

use super::errors::Spread;
use super::scope::modelled;
use super::settings::sizes;
use crate::accuracy::{Reference, named};
use crate::sheet::Record;
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::{Measure, Projected};
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::{parallel, shipped};
use indicatif::ProgressBar;
use std::path::Path;

/// The maps: some are soft, others have a small strong light.
pub const MAPS: [&str; 6] = ["esplanade", "hall", "park", "sky", "studio", "venice"];
/// The surfaces of a quick run.
const QUICK: [&str; 3] = ["lambertian", "ggx-0.9-0.7", "teflon"];

/// One surface at one degree and order.
pub struct Row {
    surface: String,
    size: (usize, usize),
    /// The rms over the sphere and the channels relative to the peak, by map.
    errors: Vec<f64>,
}

impl Row {
    pub fn record(&self) -> Record {
        let mut record = Record::default();
        record.put("surface", &self.surface);
        record.put("degree", self.size.0);
        record.put("order", self.size.1);
        let Spread { median, worst, .. } = Spread::of(&self.errors);
        record.measure("median", median);
        record.measure("worst", worst);
        for (map, &error) in MAPS.into_iter().zip(&self.errors) {
            record.measure(map, error);
        }
        record
    }
}

/// Integrates under the maps in this folder; with `quick`, only three surfaces.
pub fn rows(folder: &Path, quick: bool, progress: &ProgressBar) -> Result<Vec<Row>> {
    let map = |name: &&str| {
        let path = folder.join(format!("{name}.exr"));
        if !path.is_file() {
            let remedy = "give the folder of the project's maps, tables/inputs/maps, with --maps";
            return Err(Error::new("there is no such map", remedy).in_file(path));
        }
        EnvironmentMap::from_path(path)
    };
    let maps = MAPS.iter().map(map).collect::<Result<Vec<_>>>()?;
    let maps = Surroundings::new(&maps)?;
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
        let reference = Reference::new(surface, &maps, 1.0, progress);
        rows.extend(sizes.iter().zip(projected).map(|(&size, Projected { material, .. })| Row {
            surface: surface.name.clone(),
            size,
            errors: reference.of_sum(&lights, size, material),
        }));
    }
    Ok(rows)
}

/// The errors of a degree and an order over all surfaces and maps.
pub fn spread(rows: &[Row], size: (usize, usize)) -> Spread {
    let of_size = rows.iter().filter(|row| row.size == size);
    Spread::of(&of_size.flat_map(|row| row.errors.iter().copied()).collect::<Vec<f64>>())
}
