//! The total error: a picture against direct integration of the BRDF under the whole map. It
//! contains the errors of the table, of its degree and order, and of the number format.

pub mod lamps;
pub mod references;
pub mod rivals;
pub mod subjects;

use super::errors::Spread;
use super::images::Pair;
use super::numbers::{numbers, table_bytes};
use super::settings::{DEGREE, Format, ORDER, Recipe, Setting, WindowChoice};
use crate::sheet::Record;
use crate::sphere::Picture;
use eigenshade_generator::basis;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::Materials;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::source::NamedSources;
use eigenshade_model::window::Window;
use eigenshade_model::{parallel, shipped};
use eigenshade_shading::sources::screen::{Errors as PictureErrors, Reference, windowed};
use eigenshade_table::reduce::with_components;
use eigenshade_table::{Table, decode};
use indicatif::ProgressBar;
use lamps::Lamps;
use references::World;
use rivals::Prefiltered;
use std::collections::BTreeSet;
use std::path::Path;
use subjects::{GROUPS, Group, Kind, Subject, coefficients};

/// The highest order. To project the materials to a higher one takes as long as all the rest.
pub const HIGHEST: usize = 16;
/// The rival whose look-up on a device is that of a baked map by points.
pub const MATCAP: &str = "matcap32 f32";
/// The rival that engines draw with.
pub const PREFILTERED: &str = "prefiltered f32";

/// Numbers of components of which the runtime's table could have had one.
pub const COMPONENTS: [usize; 5] = [20, 30, 46, 70, 100];

/// The row name of the runtime's scene with a number of components and of sources.
pub fn components_name(count: usize, sources: usize) -> String {
    let sources = if sources > 0 { format!(" sources{sources}") } else { String::new() };
    format!("sphere.toml K{count} f32{sources}")
}

/// The errors of one way to a picture, by material and then by map.
pub type Errors = Vec<Vec<PictureErrors>>;

/// The materials with their reference pictures and coefficients.
pub struct Study {
    world: World,
    subjects: Vec<Subject>,
    /// By material and then by map.
    references: Vec<Vec<Reference>>,
    /// By order.
    materials: Vec<Materials>,
    sources: Vec<NamedSources>,
}

impl Study {
    /// Integrates pictures under the maps of a folder, at normals of this spacing in radians.
    pub fn new(
        folder: &Path,
        subjects: Vec<Subject>,
        orders: &[usize],
        spacing: f64,
        progress: &ProgressBar,
    ) -> Result<Self> {
        let world = World::new(folder, &shipped::lights()?, spacing)?;
        progress.set_length(subjects.len() as u64);
        let reference = |subject: &Subject| {
            let pictures = world.pictures(&subject.surface, &world.sphere.normals).into_iter();
            progress.inc(1);
            pictures.map(|picture| Reference::new(picture, &world.sphere)).collect()
        };
        let references = subjects.iter().map(reference).collect();
        let orders = orders.iter().copied().filter(|&order| order <= HIGHEST);
        let orders = Vec::from_iter(BTreeSet::from_iter(orders));
        let materials = coefficients(&subjects, &orders);
        Ok(Self { world, subjects, references, materials, sources: shipped::sources()? })
    }

    /// The errors of a setting; `None` if its order is too high.
    pub fn of_setting(&self, setting: &Setting, table: &Table) -> Result<Option<Errors>> {
        let order = setting.recipe.order;
        let Some(materials) = self.materials.iter().find(|one| one.order == order) else {
            return Ok(None);
        };
        let (sphere, lights) = (&self.world.sphere, &self.world.lights.entries);
        let numbers = numbers(setting, table, &sphere.normals)?;
        let lamps = Lamps::new(setting, lights, &self.sources, &sphere.normals)?;
        let maps = lights.len();
        let found = parallel::map(self.subjects.len() * maps, &(), |k| {
            let (material, map) = (k / maps, k % maps);
            let gloss = self.subjects[material].gloss.filter(|_| setting.sources > 0);
            let light = gloss.map_or(&lights[map].rgb, |_| lamps.rest(map));
            let drawn = |window: Window| -> Result<Picture> {
                let channel = |c: usize| {
                    let material = materials.entries[material].rgb[c].clone();
                    let mut light = light[c].clone();
                    window.apply(&mut light);
                    numbers.image(&Pair { light, material })
                };
                let rest = [channel(0)?, channel(1)?, channel(2)?];
                match gloss {
                    Some(gloss) => lamps.add(map, &gloss, &rest),
                    None => Ok(rest.map(|channel| channel.irradiances)),
                }
            };
            let picture = match setting.window {
                WindowChoice::None => drawn(Window::None),
                WindowChoice::Auto => windowed(setting.recipe.degree, sphere, drawn),
            };
            Ok(self.references[material][map].errors(&picture?, sphere))
        });
        let found = found.into_iter().collect::<Result<Vec<_>>>()?;
        Ok(Some(found.chunks(maps).map(<[_]>::to_vec).collect()))
    }

    /// The rows of the shipped tables with all their components.
    pub fn shipped(&self) -> Result<Vec<Record>> {
        let mut rows = Vec::new();
        for (name, bytes, (degree, order), format) in [
            ("sphere.bin", shipped::TABLE, (DEGREE, ORDER), Format::F32),
            ("sphere.bin", shipped::TABLE, (DEGREE, ORDER), Format::Q15),
            ("color.bin", shipped::COLOR, (DEGREE, ORDER), Format::F32),
            ("pbr.bin", shipped::PBR, (12, 12), Format::F32),
        ] {
            let table = decode(bytes).map_err(|error| {
                Error::new(error.to_string(), "report it").in_file(format!("tables/{name}"))
            })?;
            let setting = Setting::of(Recipe::all(degree, order)).in_format(format);
            if let Some(errors) = self.of_setting(&setting, &table)? {
                rows.extend(self.rows(&format!("{name} {format}"), setting.sources, &errors));
            }
        }
        Ok(rows)
    }

    /// The rows of the scene of the runtime's table with other numbers of components, with and
    /// without sources.
    pub fn components(&self) -> Result<Vec<Record>> {
        let tables = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables"));
        let Loaded { mut scene, lights, materials, .. } =
            scene_file::load(tables.join("sphere.toml"))?;
        scene.basis.components = COMPONENTS.last().copied();
        let whole = basis::build(&scene, &lights, &materials)?;
        let mut rows = Vec::new();
        for count in COMPONENTS {
            let table = with_components(&whole, |number, _| number < count);
            let setting = Setting::of(Recipe::all(DEGREE, ORDER));
            let bytes = [Format::F32, Format::Q15]
                .map(|format| table_bytes(&setting.in_format(format), &table));
            let [floats, integers] = bytes;
            let (floats, integers) = (floats?, integers?);
            for sources in [0, 8] {
                let setting = Setting { sources, ..setting };
                let Some(errors) = self.of_setting(&setting, &table)? else { continue };
                let mut found = self.rows(&components_name(count, sources), sources, &errors);
                for row in &mut found {
                    row.put("f32_bytes", floats);
                    row.put("q15_bytes", integers);
                }
                rows.extend(found);
            }
        }
        Ok(rows)
    }

    /// The rows of the rivals, for formulas.
    pub fn rivals(&self) -> Result<Vec<Record>> {
        let matcap = self.by(|subject| match subject.kind {
            Kind::Measured => Ok(Vec::new()),
            _ => Ok(rivals::matcap(&subject.surface, &self.world)),
        })?;
        let mut filtered: Vec<Prefiltered> = Vec::new();
        let prefiltered = self.by(|subject| {
            let Some(gltf) = subject.gltf else { return Ok(Vec::new()) };
            let place = filtered.iter().position(|one| one.roughness == gltf.roughness);
            let place = place.unwrap_or(filtered.len());
            if place == filtered.len() {
                filtered.push(Prefiltered::new(gltf.roughness, &self.world)?);
            }
            filtered[place].pictures(gltf, &self.world)
        })?;
        Ok([self.rows(MATCAP, 0, &matcap), self.rows(PREFILTERED, 0, &prefiltered)].concat())
    }

    /// The errors by map of these pictures; none for a material without any.
    fn by(&self, mut pictures: impl FnMut(&Subject) -> Result<Vec<Picture>>) -> Result<Errors> {
        let sphere = &self.world.sphere;
        let errors = self.subjects.iter().zip(&self.references).map(|(subject, references)| {
            let pictures = pictures(subject)?;
            let pairs = pictures.iter().zip(references);
            Ok(pairs.map(|(found, one)| one.errors(found, sphere)).collect())
        });
        errors.collect()
    }

    /// A row for each group whose materials all have errors.
    pub fn rows(&self, setting: &str, sources: usize, errors: &Errors) -> Vec<Record> {
        let row = |Group { name, count, has }: &Group| {
            let pairs = self.subjects.iter().zip(errors);
            let of = pairs.filter(|(subject, errors)| has(subject) && !errors.is_empty());
            let errors: Vec<&[PictureErrors]> = of.map(|(_, errors)| &errors[..]).collect();
            if errors.len() != *count {
                return None;
            }
            let mut row = Record::default();
            row.put("setting", setting);
            row.put("sources", sources);
            row.put("kind", name);
            let errors = errors.concat();
            row.put("pictures", errors.len());
            let close = errors.iter().filter(|error| error.all.is_close()).count();
            row.measure("close", close as f64 / errors.len() as f64);
            for (column, of) in ERROR_COLUMNS {
                let Spread { median, most, .. } =
                    Spread::of(&errors.iter().map(of).collect::<Vec<f64>>());
                row.measure(format!("{column}_median"), median);
                row.measure(format!("{column}_most"), most);
            }
            Some(row)
        };
        GROUPS.iter().filter_map(row).collect()
    }
}

/// A part of an error.
type Part = fn(&PictureErrors) -> f64;

/// The columns of the screen error, each with its median and its 95th percentile over the pictures:
/// CIEDE2000 of all pixels and of those below white, and the rms as a share of white.
pub const ERROR_COLUMNS: [(&str, Part); 5] = [
    ("mean", |error| error.all.mean),
    ("p95", |error| error.all.p95),
    ("below_mean", |error| error.below.mean),
    ("below_p95", |error| error.below.p95),
    ("white", |error| error.all.white),
];
