//! The error of the model: the direct sum of a degree and an order, compared with the BRDF itself
//! integrated under captured maps without any truncation.

use super::knobs::{DEGREE, HIGHER, LOWER, ORDER};
use super::materials::modelled;
use super::method::Spread;
use crate::accuracy::{Reference, spacing};
use eigenshade_generator::direct::Surroundings;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::brdf::Surface;
use eigenshade_model::database::Lights;
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::shipped;
use indicatif::ProgressBar;
use std::path::Path;

/// The maps: some are soft, others have a small strong light.
pub const MAPS: [&str; 6] = ["esplanade", "hall", "park", "sky", "studio", "venice"];
/// The surfaces of a quick run.
const QUICK: [&str; 3] = ["lambertian", "ggx-0.9-0.7", "teflon"];

/// One surface at one degree and order.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which surface.
    pub surface: String,
    /// The degree of the lights.
    pub degree: usize,
    /// The order of the materials.
    pub order: usize,
    /// The rms over the sphere and the channels relative to the peak, by map.
    pub errors: Vec<f64>,
}

/// The degrees and orders for which the model is measured.
#[must_use]
pub fn sizes() -> Vec<(usize, usize)> {
    LOWER.into_iter().chain([(DEGREE, ORDER)]).chain(HIGHER).collect()
}

/// Integrates under the maps in this folder; with `quick`, only three surfaces.
///
/// # Errors
///
/// If a map is missing or cannot be read.
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
    let all = shipped::lights()?;
    let find = |name: &&str| {
        let found = all.entries.iter().find(|light| light.name == **name);
        found.cloned().ok_or_else(|| Error::new("a light is missing", "build the program anew"))
    };
    let entries = MAPS.iter().map(find).collect::<Result<Vec<_>>>()?;
    let lights = Lights { degree: all.degree, entries };
    let mut surfaces = modelled()?;
    surfaces.retain(|surface| !quick || QUICK.contains(&surface.name.as_str()));
    let mut rows = Vec::new();
    for surface in &surfaces {
        rows.extend(of_surface(surface, &maps, &lights, progress));
    }
    Ok(rows)
}

fn of_surface(
    surface: &Surface,
    maps: &Surroundings,
    lights: &Lights,
    progress: &ProgressBar,
) -> Vec<Row> {
    let reference = Reference::new(surface, maps, spacing(surface), 1.0, progress);
    let row = |(degree, order)| Row {
        surface: surface.name.clone(),
        degree,
        order,
        errors: reference.of_sum(lights, degree, order),
    };
    sizes().into_iter().map(row).collect()
}

/// The errors of a degree and an order over all surfaces and maps; `None` if no row has them.
#[must_use]
pub fn spread(rows: &[Row], degree: usize, order: usize) -> Option<Spread> {
    let of_size = rows.iter().filter(|row| (row.degree, row.order) == (degree, order));
    let errors: Vec<f64> = of_size.flat_map(|row| row.errors.iter().copied()).collect();
    (!errors.is_empty()).then(|| Spread::of(&errors))
}
