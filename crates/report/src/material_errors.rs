//! The total screen error of each shipped material in color, and of PTFE: the picture of its
//! coefficients at a degree and an order against direct integration under environment maps.

use crate::accuracy_cost::errors::Spread;
use crate::accuracy_cost::scope::published;
use crate::accuracy_cost::total::references::World;
use crate::numbers::{median, percent};
use crate::pages::table;
use crate::sheet::{Record, Sheet, fields};
use crate::sphere::{Picture, Sphere};
use eigenshade_generator::material::brdf::{Brdf, Geometry, Surface};
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::inputs::coefficient_csv::read_lights;
use eigenshade_model::scattering;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::shipped;
use eigenshade_model::shipped::{ERROR_SIZES, TotalError, named_materials};
use eigenshade_model::source::{Gloss, NamedSources, Source};
use eigenshade_shading::sources::screen::{self, Reference};
use eigenshade_table::light;
use indicatif::ProgressBar;
use std::convert::Infallible;
use std::path::Path;

/// The material that was measured and is not in color.
const MEASURED: &str = "ptfe-633nm";
/// Distance of evenly spaced normals in radians: 1,000, and 800 that mirror lamps of the maps.
pub const SPACING: f64 = 0.08;

/// The numbers of sources: none, and as many as `eigenshade render` takes at most.
pub const SOURCES: [usize; 2] = [0, 8];

/// The errors of one material at one size and a number of sources.
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
    let (all_sources, glosses) = (shipped::sources()?, shipped::glosses()?);
    let mut found = Vec::new();
    for (surface, shipped) in chosen {
        let integrated = world.pictures(surface, &world.sphere.normals).into_iter();
        let references: Vec<_> = integrated.map(|one| Reference::new(one, &world.sphere)).collect();
        let gloss = glosses.iter().find(|one| one.name == surface.name).map(|one| one.gloss);
        let gloss = gloss.filter(Gloss::needs_sources);
        let mut of_material = Vec::new();
        for (size, material) in ERROR_SIZES.into_iter().zip(shipped) {
            for (sources, pictures) in
                pictures(&world, size, material, gloss.as_ref(), &all_sources)
            {
                let error = errors_of(&references, &world, &pictures);
                of_material.push(Errors { size, sources, ..error });
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

/// The table of the energies that orders leave out, of `merl.energy.csv`.
pub fn energies(sheet: &Sheet) -> String {
    let row = |of_kind: &[Record]| {
        let shares: Vec<f64> = of_kind.iter().filter_map(|row| row.number("left_out")).collect();
        let worst = (0..shares.len()).max_by(|&a, &b| shares[a].total_cmp(&shares[b]));
        let worst = worst.unwrap_or_default();
        let [model, order] = ["model", "order"].map(|column| of_kind[0].text(column));
        let numbers = [median(&shares), Spread::of(&shares).most, shares[worst]];
        let [middle, most, largest] = numbers.map(|share| percent(share, 2));
        let largest = format!("{largest} ({})", of_kind[worst].text("material"));
        vec![format!("{}, {order}", model.to_uppercase()), middle, most, largest]
    };
    let kind = |row: &Record| ["model", "order"].map(|column| row.text(column).to_owned());
    let kinds = sheet.rows.chunk_by(|a, b| kind(a) == kind(b));
    table("model, order | median: | 95th percentile: | worst material:", kinds.map(row))
}

fn errors_of(all: &[Reference], world: &World, pictures: &[Picture]) -> Errors {
    let pairs = all.iter().zip(pictures);
    let errors: Vec<ScreenError> =
        pairs.map(|(one, picture)| one.errors(picture, &world.sphere).all).collect();
    let spread =
        |of: fn(&ScreenError) -> f64| Spread::of(&errors.iter().map(of).collect::<Vec<_>>());
    let [mean, p95, white] =
        [spread(|error| error.mean), spread(|error| error.p95), spread(|error| error.white)];
    let of =
        |of: fn(&Spread) -> f64| ScreenError { mean: of(&mean), p95: of(&p95), white: of(&white) };
    let worst = (0..errors.len()).max_by(|&a, &b| errors[a].mean.total_cmp(&errors[b].mean));
    Errors {
        size: Default::default(),
        sources: 0,
        error: TotalError { median: of(|spread| spread.median), most: of(|spread| spread.most) },
        map: world.lights.entries[worst.unwrap_or_default()].name.clone(),
    }
}

/// For each of [`SOURCES`], the pictures of a material by the direct sum (15), by map, with the
/// windows that `eigenshade render` chooses. The degrees are summed apart, all lights at once.
fn pictures(
    world: &World,
    (degree, order): (usize, usize),
    on: &Named,
    gloss: Option<&Gloss>,
    sources: &[NamedSources],
) -> Vec<(usize, Vec<Picture>)> {
    let (sphere, lights) = (&world.sphere, &world.lights.entries);
    let mut lit = Vec::new();
    let mut apart = [const { Vec::new() }; 3];
    for most in SOURCES {
        for light in lights {
            let mut rest =
                light.rgb.each_ref().map(|channel| channel[..light::count(degree)].to_vec());
            let of_light = sources.iter().find(|one| one.name == light.name && gloss.is_some());
            let sources = of_light.map_or(&[][..], |light| light.first(most));
            highlights::take_out(&mut rest, degree, sources);
            lit.push(gloss.map(|gloss| shone(gloss, sources, sphere)));
            for (apart, rest) in apart.iter_mut().zip(&rest) {
                apart.extend((0..=degree).map(|l| {
                    let mut one = vec![0.0; rest.len()];
                    one[l * l..light::count(l)].copy_from_slice(&rest[l * l..light::count(l)]);
                    one
                }));
            }
        }
    }
    let channel = |c: usize| (apart[c].iter().map(Vec::as_slice).collect(), &on.rgb[c][..]);
    let degrees = sphere.direct((degree, order), &[0, 1, 2].map(channel));
    let (count, terms) = (SOURCES.len() * lights.len(), degree + 1);
    let picture = |k: usize| {
        let Ok(picture) = screen::windowed(degree, sphere, |window| {
            let factors = screen::factors(window, degree);
            let channel = |c: usize| {
                let images = &degrees[(c * count + k) * terms..][..terms];
                let pixel = |n: usize| {
                    let sum: f64 = images.iter().zip(&factors).map(|(one, f)| f * one[n]).sum();
                    sum + lit[k].as_ref().map_or(0.0, |lit| lit[n][c])
                };
                (0..sphere.normals.len()).map(pixel).collect()
            };
            Ok::<Picture, Infallible>([channel(0), channel(1), channel(2)])
        });
        picture
    };
    let all: Vec<Picture> = (0..count).map(picture).collect();
    SOURCES.into_iter().zip(all.chunks(lights.len()).map(<[_]>::to_vec)).collect()
}

/// The highlights of sources at the normals of a sphere.
fn shone(gloss: &Gloss, sources: &[Source], sphere: &Sphere) -> Vec<[f64; 3]> {
    let lobes = Highlights::new(gloss, sources);
    sphere.normals.iter().map(|&normal| lobes.irradiance(normal)).collect()
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
