//! The total screen error of each shipped material in color, and of PTFE: the picture of its
//! coefficients at a degree and an order against direct integration under environment maps.

use crate::accuracy_cost::errors::Spread;
use crate::accuracy_cost::scope::published;
use crate::accuracy_cost::total::references::World;
use crate::sheet::fields;
use crate::sphere::{Picture, Sphere};
use eigenshade::mathematics::Libm;
use eigenshade::{Highlights, Rgb};
use eigenshade_generator::material::brdf::{Brdf, Geometry, Surface};
use eigenshade_index::highlights::MAX_SOURCES;
use eigenshade_index::light;
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::scattering;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::source::{Gloss, SourceSets};
use eigenshade_shading::shader::{OwnedNormals, fault};
use eigenshade_shading::shipped::{ERROR_SIZES, TotalError, named_materials};
use eigenshade_shading::{highlights, shipped};
use eigenshade_sources::screen::{self, Reference};
use indicatif::ProgressBar;
use std::path::Path;

/// The material that was measured and is not in color.
const MEASURED: &str = "ptfe-633nm";
/// Distance of evenly spaced normals in radians: 1,000, and 800 that mirror lamps of the maps.
pub const SPACING: f64 = 0.08;

/// The numbers of sources: none, and as many as `eigenshade render` takes at most.
pub const SOURCES: [usize; 2] = [0, 8];

/// The errors of one material at one size with at most so many sources.
#[derive(Clone, Debug)]
pub struct Errors {
    pub size: (usize, usize),
    pub sources: usize,
    /// The median over the maps of each measure, and what 95 of 100 maps do not exceed.
    pub error: TotalError,
    /// The map with the largest mean.
    pub map: String,
}

/// The errors of materials, by name.
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
    let (sets, glosses) = (shipped::sources()?, shipped::glosses()?);
    let mut found = Vec::new();
    for (surface, shipped) in chosen {
        let pictures = world.pictures(surface, &world.sphere.normals).into_iter();
        let references: Vec<_> = pictures.map(|one| Reference::new(one, &world.sphere)).collect();
        let gloss = glosses.iter().find(|one| one.name == surface.name).map(|one| one.gloss);
        let gloss = gloss.filter(|gloss| {
            highlights::gloss::<f64>(gloss).is_ok_and(|gloss| gloss.needs_sources())
        });
        let mut of_material = Vec::new();
        for (size, material) in ERROR_SIZES.into_iter().zip(shipped) {
            for sources in SOURCES {
                let gloss = gloss.filter(|_| sources > 0).map(|gloss| (gloss, &sets[..]));
                let errors = errors_of(&references, &world, size, material, gloss)?;
                of_material.push(Errors { sources, ..errors });
            }
        }
        bar.inc(1);
        found.push((surface.name.clone(), of_material));
    }
    Ok(found)
}

/// The columns of `merl.errors.csv`.
pub const COLUMNS: &str = "material,degree,order,sources,mean,mean_most,p95,p95_most,map";

/// Its rows.
pub fn rows(found: &Found) -> impl Iterator<Item = Vec<String>> {
    found.iter().flat_map(|(name, errors)| {
        errors.iter().map(move |Errors { size: (degree, order), sources, error, map }| {
            let TotalError { median, most } = error;
            let numbers = [median.mean, most.mean, median.p95, most.p95];
            let [mean, mean_most, p95, p95_most] = numbers.map(|number| format!("{number:.2}"));
            fields(&[name, degree, order, sources, &mean, &mean_most, &p95, &p95_most, map])
        })
    })
}

/// The errors of the direct sums (15) with at most 8 sources if there is a gloss, with the windows
/// that `eigenshade render` chooses.
fn errors_of(
    all: &[Reference],
    world: &World,
    size: (usize, usize),
    on: &Named,
    gloss: Option<(Gloss, &[SourceSets])>,
) -> Result<Errors> {
    let mut errors = Vec::new();
    for (reference, light) in all.iter().zip(&world.lights.entries) {
        let picture = picture(&world.sphere, light, size, on, gloss)?;
        errors.push(reference.errors(&picture, &world.sphere).all);
    }
    let spread =
        |of: fn(&ScreenError) -> f64| Spread::of(&errors.iter().map(of).collect::<Vec<_>>());
    let [mean, p95, white] =
        [spread(|error| error.mean), spread(|error| error.p95), spread(|error| error.white)];
    let of =
        |of: fn(&Spread) -> f64| ScreenError { mean: of(&mean), p95: of(&p95), white: of(&white) };
    let worst = (0..errors.len()).max_by(|&a, &b| errors[a].mean.total_cmp(&errors[b].mean));
    Ok(Errors {
        size,
        sources: 0,
        error: TotalError { median: of(|spread| spread.median), most: of(|spread| spread.most) },
        map: world.lights.entries[worst.unwrap_or_default()].name.clone(),
    })
}

/// The picture of a material under a light, of which the degrees are summed apart, so that windows
/// cost little.
fn picture(
    sphere: &Sphere,
    light: &Named,
    (degree, order): (usize, usize),
    on: &Named,
    gloss: Option<(Gloss, &[SourceSets])>,
) -> Result<Picture> {
    let mut rest = light.rgb.each_ref().map(|channel| channel[..light::count(degree)].to_vec());
    let mut lit = vec![Rgb::gray(0.0); sphere.normals.len()];
    if let Some((gloss, sets)) = gloss {
        let sources = sets.iter().find(|one| one.name == light.name);
        let sources = sources.map_or(&[][..], |sets| sets.of_most(SOURCES[1]));
        highlights::take_out(&mut rest, degree, sources)?;
        let sources = sources.iter().map(highlights::source).collect::<Result<Vec<_>>>()?;
        let gloss = highlights::gloss(&gloss)?;
        let lobes = Highlights::<f64, MAX_SOURCES>::new::<Libm>(&gloss, &sources).map_err(fault)?;
        lobes.add_slice(OwnedNormals::new(&sphere.normals).view()?, &mut lit).map_err(fault)?;
    }
    let channel = |c: usize| {
        let one = |l: usize| {
            let mut one = vec![0.0; light::count(degree)];
            one[l * l..light::count(l)].copy_from_slice(&rest[c][l * l..light::count(l)]);
            one
        };
        let lights: Vec<Vec<f64>> = (0..=degree).map(one).collect();
        let lights = lights.iter().map(Vec::as_slice).collect();
        sphere.direct((degree, order), &[(lights, &on.rgb[c][..])])
    };
    let degrees = [channel(0), channel(1), channel(2)];
    screen::windowed(degree, sphere, |window| {
        let factors = screen::factors(window, degree);
        let channel = |c: usize| {
            let sum = |k: usize| {
                let terms = degrees[c].iter().zip(&factors);
                terms.map(|(image, factor)| factor * image[k]).sum::<f64>()
                    + <[f64; 3]>::from(lit[k])[c]
            };
            (0..lit.len()).map(sum).collect()
        };
        Ok([channel(0), channel(1), channel(2)])
    })
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
