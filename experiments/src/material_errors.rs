//! The total error of each shipped material in color, and of PTFE: the picture of its coefficients
//! at a degree and an order against direct integration under environment maps.

use crate::accuracy_cost::scope::published;
use crate::accuracy_cost::total::references::{ReferencePicture, World};
use crate::numbers::median;
use crate::reference::sums;
use crate::sheet::fields;
use eigenshade_generator::material::brdf::{Brdf, Geometry, Surface};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::scattering;
use eigenshade_shading::shipped::{ERROR_SIZES, named_materials};
use indicatif::ProgressBar;
use std::path::Path;

/// The material that was measured and is not in color.
const MEASURED: &str = "ptfe-633nm";
/// Distance of evenly spaced normals in radians: 1,000, and 800 that mirror lamps of the maps.
pub const SPACING: f64 = 0.08;

/// The errors of one material at one size, relative to the peak.
#[derive(Clone, Debug)]
pub struct Errors {
    /// The median over the maps of the rms over the picture.
    pub median: f64,
    /// The largest rms of a map.
    pub worst: f64,
    /// Its map.
    pub map: String,
    /// The largest error of a pixel under any map.
    pub pixel: f64,
}

/// The errors of materials, by name and then by size.
pub type Found = Vec<(String, Vec<Errors>)>;

/// The errors of the shipped materials, or of those with these names, at each of [`ERROR_SIZES`].
pub fn errors(inputs: &Path, names: &[String], spacing: f64, bar: &ProgressBar) -> Result<Found> {
    let materials = materials()?;
    if let Some(name) = names.iter().find(|name| materials.iter().all(|(s, _)| s.name != **name)) {
        let what = format!("no material is named `{name}`");
        return Err(Error::new(what, "give names of tables/inputs/merl-abc.csv, or none"));
    }
    let is_chosen =
        |(surface, _): &&(Surface, [Named; 2])| names.is_empty() || names.contains(&surface.name);
    let chosen: Vec<_> = materials.iter().filter(is_chosen).collect();
    let lights = read_lights(inputs.join("lights.csv"), None)?;
    let world = World::new(&inputs.join("maps"), &lights, spacing)?;
    bar.set_length(chosen.len() as u64);
    let of_material = |(surface, shipped): &(Surface, [Named; 2])| {
        let pictures = world.pictures(surface, &world.sphere.normals).into_iter();
        let references: Vec<_> =
            pictures.map(|one| ReferencePicture::new(one, &world.sphere)).collect();
        bar.inc(1);
        let of_size = |(size, material)| errors_of(&references, &world, size, material);
        (surface.name.clone(), ERROR_SIZES.into_iter().zip(shipped).map(of_size).collect())
    };
    Ok(chosen.into_iter().map(of_material).collect())
}

/// The columns of `merl.errors.csv`.
pub const COLUMNS: &str = "material,degree,order,median,worst,map,pixel";

/// Its rows.
pub fn rows(found: &Found) -> impl Iterator<Item = Vec<String>> {
    found.iter().flat_map(|(name, errors)| {
        ERROR_SIZES.into_iter().zip(errors).map(move |((degree, order), errors)| {
            let [median, worst] = [errors.median, errors.worst].map(|rms| format!("{rms:.5}"));
            let pixel = format!("{:.4}", errors.pixel);
            fields(&[name, &degree, &order, &median, &worst, &errors.map, &pixel])
        })
    })
}

fn errors_of(all: &[ReferencePicture], world: &World, size: (usize, usize), on: &Named) -> Errors {
    let found = sums(&world.sphere, &world.lights, size, on);
    let errors = all.iter().zip(&found).map(|(one, found)| one.error(found, &world.sphere));
    let (rms, pixels): (Vec<f64>, Vec<f64>) = errors.map(|one| (one.rms, one.pixel)).unzip();
    let worst = (0..rms.len()).max_by(|&a, &b| rms[a].total_cmp(&rms[b])).unwrap_or_default();
    Errors {
        median: median(&rms),
        worst: rms[worst],
        map: world.lights.entries[worst].name.clone(),
        pixel: pixels.into_iter().fold(0.0, f64::max),
    }
}

/// The BRDFs with the coefficients that are shipped for each of [`ERROR_SIZES`].
fn materials() -> Result<Vec<(Surface, [Named; 2])>> {
    let [(_, low), (_, high)] = ERROR_SIZES;
    let shipped = [named_materials(low)?, named_materials(high)?];
    let find = |entries: &[Named], name: &str| {
        entries.iter().find(|entry| entry.name == name).cloned().ok_or_else(|| {
            let what = format!("no shipped material is named `{name}`");
            Error::new(what, "make the files again, as in tables/README.md")
        })
    };
    let of_name = |name: &str| -> Result<[Named; 2]> {
        Ok([find(&shipped[0].entries, name)?, find(&shipped[1].entries, name)?])
    };
    let mut materials = Vec::new();
    for surface in published()? {
        let named = of_name(&surface.name)?;
        materials.push((surface, named));
    }
    let measured = of_name(MEASURED)?;
    let modes = Modes { order: low, coefficients: measured[0].rgb[1].clone() };
    materials.push((Surface::gray(MEASURED.to_owned(), Box::new(modes)), measured));
    Ok(materials)
}

/// A BRDF that is a sum of modes.
struct Modes {
    order: usize,
    coefficients: Vec<f64>,
}

impl Brdf for Modes {
    fn value(&self, at: Geometry) -> f64 {
        let [theta_i, theta_r] = [at.incident, at.reflected].map(|cosine| cosine.min(1.0).acos());
        let azimuth = at.azimuth_cosine().acos();
        scattering::brdf(self.order, &self.coefficients, theta_i, theta_r, azimuth)
    }

    fn width(&self) -> f64 {
        1.0 / self.order.max(1) as f64
    }
}
