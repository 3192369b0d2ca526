//! Errors of pictures with small sources against direct integration of whole maps, pictures of
//! them, and the gloss of the shipped materials.

use crate::accuracy_cost::scope::published;
use crate::numbers::median;
use crate::pages::{Part, table};
use crate::sheet::{Record, Sheet, fields};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::named_maps;
use eigenshade_generator::material::brdf::Measure;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::source_csv::read_sources;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::screen::ScreenError;
use eigenshade_model::shipped;
use eigenshade_model::source::{NamedGloss, NamedSources};
use eigenshade_shading::sources::gloss::Fitter;
use eigenshade_shading::sources::pursuit::{self, FITTED};
use eigenshade_shading::sources::remaining::picture;
use eigenshade_shading::sources::response::{Glossy, Response};
use eigenshade_shading::sources::screen::Reference;
use eigenshade_shading::sources::sphere::{Picture, Sphere};
use eigenshade_shading::sources::view::View;
use eigenshade_table::highlights::SHIPPED_SOURCES;
use indicatif::ProgressBar;
use std::path::Path;

/// Degrees and orders, and whether sources are used.
const SIZES: [((usize, usize), bool); 4] =
    [((9, 7), true), ((12, 12), true), ((24, 24), false), ((32, 32), false)];
/// Numbers of sources.
const COUNTS: [usize; 5] = [1, 2, 4, 8, SHIPPED_SOURCES];
/// A rotation of the light that sources are not fitted to.
const OTHER: Rotation = Rotation { alpha: 0.8, beta: -2.1, gamma: 0.9 };
/// Spacing of the normals in radians, other than that of the fit.
const SPACING: f64 = 0.071;

/// The error of one picture of a metal.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    pub light: String,
    /// Whether the light is turned.
    pub is_turned: bool,
    pub roughness: f64,
    /// Degree and order.
    pub size: (usize, usize),
    /// The number of sources, or all if the light has fewer.
    pub sources: usize,
    pub error: ScreenError,
}

/// The columns of the errors.
pub const COLUMNS: &str = "light,turned,roughness,degree,order,sources,mean,p95,white";

impl Row {
    /// A row of `docs/highlights.csv`.
    fn of(record: &Record) -> Option<Self> {
        let number = |column| record.number(column);
        let count = |column: &str| record.text(column).parse().ok();
        Some(Self {
            light: record.text("light").into(),
            is_turned: record.text("turned") == "1",
            roughness: number("roughness")?,
            size: (count("degree")?, count("order")?),
            sources: count("sources")?,
            error: ScreenError {
                mean: number("mean")?,
                p95: number("p95")?,
                white: number("white")?,
            },
        })
    }

    /// The fields of [`COLUMNS`].
    pub fn fields(&self) -> Vec<String> {
        let Self { light, is_turned, roughness, size: (degree, order), sources, error } = self;
        let [mean, p95] = [error.mean, error.p95].map(|difference| format!("{difference:.2}"));
        let (turned, white) = (u8::from(*is_turned), format!("{:.4}", error.white));
        fields(&[light, &turned, roughness, degree, order, sources, &mean, &p95, &white])
    }
}

/// The rows of `docs/highlights.csv`.
pub fn read(path: &Path) -> Result<Vec<Row>> {
    let rows = Sheet::read(path)?.rows;
    let fault = |line| Error::new("it lacks a number", "make the file again").at_line(path, line);
    rows.iter().map(|record| Row::of(record).ok_or_else(|| fault(record.line))).collect()
}

/// Lights that no camera took: their names and maps.
fn synthetic() -> Vec<(&'static str, EnvironmentMap)> {
    let (width, height) = (512, 256);
    let map = |radiance: &dyn Fn([f64; 3]) -> f32| {
        let mut map = EnvironmentMap { width, height, texels: vec![[0.0; 3]; width * height] };
        for texel in 0..width * height {
            map.texels[texel] = [radiance(map.direction(texel % width, texel / width)); 3];
        }
        map
    };
    let near = |direction: [f64; 3], to: [f64; 3], radius: f64| {
        let cosine: f64 = direction.iter().zip(to).map(|(a, b)| a * b).sum();
        cosine > radius.cos()
    };
    let lamps = [[0.48, 0.64, 0.6], [-0.8, 0.36, 0.48], [0.0, -0.6, -0.8]];
    vec![
        ("one sun", map(&|d| if near(d, [0.36, 0.8, 0.48], 0.008) { 2e4 } else { 0.3 })),
        (
            "three lamps",
            map(&|d| if lamps.iter().any(|&lamp| near(d, lamp, 0.06)) { 60.0 } else { 0.1 }),
        ),
        ("constant", map(&|_| 1.0)),
    ]
}

/// The errors under all captured lights and three synthetic ones, or under those with these names.
pub fn errors(inputs: &Path, names: &[String], progress: &ProgressBar) -> Result<Vec<Row>> {
    let sources = read_sources(inputs.join("sources.csv"))?;
    let sizes = SIZES.map(|(size, _)| size);
    let materials = FITTED.iter().map(|&roughness| Glossy::new([roughness, 1.0, 0.0], &sizes));
    let materials = materials.collect::<Result<Vec<_>>>()?;
    let is_chosen = |name: &str| names.is_empty() || names.iter().any(|one| one == name);
    let mut lights = Vec::new();
    for (name, path) in named_maps(&[inputs.join("maps")])? {
        if is_chosen(&name) {
            let sources = sources.iter().find(|light| light.name == name).cloned();
            lights.push((EnvironmentMap::from_path(path)?, sources.unwrap_or_default(), name));
        }
    }
    for (name, map) in synthetic() {
        if is_chosen(name) {
            let sources = pursuit::find(&map, &pursuit::metals(&FITTED)?, SHIPPED_SOURCES)?;
            lights.push((map, NamedSources { name: name.into(), sources }, name.into()));
        }
    }
    progress.set_length(lights.len() as u64);
    let mut rows = Vec::new();
    for (map, of_light, name) in &lights {
        for turn in [None, Some(OTHER)] {
            let degree = sizes.iter().map(|size| size.0).max().unwrap_or(0);
            let view = View::new(map, turn, degree)?;
            let sphere = view.sphere(SPACING);
            for material in &materials {
                let reference = view.pictures(material, &sphere.normals).reference;
                let reference = Reference::new(reference, &sphere);
                for (response, (size, has_sources)) in material.responses.iter().zip(SIZES) {
                    let responses = response.at_all(&sphere.normals);
                    let counts =
                        std::iter::once(0).chain(COUNTS.into_iter().filter(|_| has_sources));
                    for sources in counts {
                        let gloss = &material.gloss;
                        let (first, responses) = (of_light.first(sources), [&responses[..]; 3]);
                        let found = picture(&view, size.0, responses, gloss, first, &sphere);
                        let ScreenError { mean, p95, white } =
                            reference.errors(&found, &sphere).all;
                        // The digits that are recorded.
                        let [mean, p95] = [mean, p95].map(|one| (one * 1e2).round() / 1e2);
                        let error = ScreenError { mean, p95, white: (white * 1e4).round() / 1e4 };
                        let (light, is_turned) = (name.clone(), turn.is_some());
                        let roughness = gloss.roughness;
                        rows.push(Row { light, is_turned, roughness, size, sources, error });
                    }
                }
            }
        }
        progress.inc(1);
    }
    Ok(rows)
}

/// The tables of the page.
pub fn parts(rows: &[Row]) -> Vec<Part> {
    let find = |light: &str, is_turned: bool, roughness: f64, setting: ((usize, usize), usize)| {
        rows.iter().find(|row| {
            (&*row.light, row.is_turned, row.roughness) == (light, is_turned, roughness)
                && (row.size, row.sources) == setting
        })
    };
    let mut lights: Vec<&str> = rows.iter().map(|row| row.light.as_str()).collect();
    lights.dedup();
    let [low, high, most] = [(9, 7), (12, 12), (32, 32)];
    let settings = [(low, 0), (low, 4), (high, 0), (high, 4), (high, 8), (high, 16), (most, 0)];
    let title = |((degree, order), sources): ((usize, usize), usize)| match sources {
        0 => format!("{degree}/{order}:"),
        _ => format!("{degree}/{order} + {sources}:"),
    };
    let titles = settings.map(title).join(" | ");
    let cell = |row: Option<&Row>| {
        row.map_or("-".into(), |row| format!("{:.1} / {:.1}", row.error.mean, row.error.p95))
    };
    let lines = lights.iter().map(|light| {
        let cells = settings.map(|setting| cell(find(light, false, 0.3, setting)));
        std::iter::once((*light).to_owned()).chain(cells).collect()
    });
    let by_light = table(&format!("light | {titles}"), lines);
    let mut lines = Vec::new();
    for roughness in FITTED {
        for (is_turned, name) in [(false, "as fitted"), (true, "turned")] {
            let cells = settings.map(|setting| {
                let found = lights.iter();
                let found = found.filter_map(|light| find(light, is_turned, roughness, setting));
                let errors: Vec<ScreenError> = found.map(|row| row.error).collect();
                let of = |of: fn(&ScreenError) -> f64| errors.iter().map(of).collect::<Vec<f64>>();
                let [mean, p95] = [of(|error| error.mean), of(|error| error.p95)];
                format!("{:.1} / {:.1}", median(&mean), median(&p95))
            });
            lines.push([roughness.to_string(), name.to_owned()].into_iter().chain(cells).collect());
        }
    }
    let medians = table(&format!("roughness: | light | {titles}"), lines);
    vec![("errors by light", by_light), ("median errors", medians)]
}

/// The gloss of each shipped material in color, or of those with these names, and what it leaves.
pub fn glosses(names: &[String]) -> Result<Vec<NamedGloss>> {
    let mut all = published()?;
    all.retain(|surface| names.is_empty() || names.contains(&surface.name));
    let mut fitter = Fitter::default();
    all.iter().map(|surface| fitter.named(surface)).collect()
}

/// The pictures of [`spheres`]: a degree, an order and a number of sources; `None` is the reference.
pub const DRAWN: [Option<((usize, usize), usize)>; 4] =
    [Some(((9, 7), 0)), Some(((9, 7), 4)), Some(((12, 12), 8)), None];

/// Pictures of a shipped material under a captured light, one for each of [`DRAWN`].
pub fn spheres(inputs: &Path, map: &str, on: &str, normals: &[[f64; 3]]) -> Result<Vec<Picture>> {
    let path = inputs.join(format!("maps/{map}.exr"));
    let view = View::new(&EnvironmentMap::from_path(path)?, None, 12)?;
    let surface = published()?.into_iter().find(|surface| surface.name == on);
    let surface = surface.ok_or_else(|| Error::new("no such material", "take a shipped one"))?;
    let sources =
        shipped::sources()?.into_iter().find(|light| light.name == map).unwrap_or_default();
    let gloss = shipped::glosses()?.into_iter().find(|one| one.name == on);
    let gloss = gloss.ok_or_else(|| Error::new("no gloss", "take a shipped material"))?.gloss;
    let sphere = Sphere::of_normals(normals);
    let drawn = |drawn: Option<((usize, usize), usize)>| {
        let Some((size, most)) = drawn else { return Ok(view.reference(&surface, normals)) };
        let projected = surface.project(size.1, Measure::default()).material;
        let rows = projected.rgb.each_ref().map(|b| Response::new(size, b).at_all(normals));
        let rows = rows.each_ref().map(Vec::as_slice);
        Ok(picture(&view, size.0, rows, &gloss, sources.first(most), &sphere))
    };
    DRAWN.into_iter().map(drawn).collect()
}
