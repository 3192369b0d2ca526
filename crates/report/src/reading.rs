//! Errors of estimates of light and material, which `docs/reading.md` shows, from images of
//! peak 1 with camera effects: noise, few bits, clipping and hidden parts.

use crate::numbers::median;
use crate::sheet;
use crate::tolerances;
use csv::StringRecord;
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::picture::SphereView;
use eigenshade_cli::table;
use eigenshade_generator::basis;
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_generator::reading::reader::{Reader, Reading};
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::srgb::{linear, srgb};
use eigenshade_model::{parallel, shipped};
use eigenshade_table::{Table, light};
use eigenshade_testing::fixtures::{Image, direct_images};
use eigenshade_testing::largest;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::SeedableRng;
use rand_distr::{Distribution, StandardNormal};
use std::path::Path;

/// Tolerance for the figures of images that are not degraded, as a logarithm: they are amplified
/// rounding, which differs between hosts.
const ROUNDING: f64 = 1.5;
/// Rows that are only rounding: all components, and no error in the pixels that are used.
const EXACT: [&str; 3] = ["as it is", "clipped, left out", "half hidden"];

/// Whether a recorded cell is the same as a new one. Counts may be off by one.
pub fn same(row: &StringRecord, column: usize, old: &str, new: &str) -> bool {
    let is_exact = row.get(0) == Some("218") && row.get(1).is_some_and(|one| EXACT.contains(&one));
    let allowed = if is_exact { ROUNDING } else { tolerances::REPORT };
    let near = |(old, new): (&str, &str)| match [old, new].map(str::parse::<i32>) {
        [Ok(old), Ok(new)] => old.abs_diff(new) <= 1,
        _ => match [old, new].map(str::parse::<f64>) {
            [Ok(old), Ok(new)] => (old / new).ln().abs() <= allowed,
            _ => old == new,
        },
    };
    let [before, after] = [old, new].map(|cell| cell.split([',', ' ']).collect::<Vec<_>>());
    old == new
        || column > 1 && before.len() == after.len() && before.into_iter().zip(after).all(near)
}

/// Materials of the images, from matte to specular.
const SHOWN_MATERIALS: [&str; 7] = [
    "ptfe-633nm",
    "10-plaster-a",
    "07-velvet",
    "13-artificial-grass",
    "05-leather",
    "15-aluminum-foil",
    "34-slate-b",
];
/// Width of each image in pixels.
const SIZE: usize = 64;

/// The tables of the page: errors of the estimates, then ranks of the material and errors of the
/// light. `tables` is the folder of the shipped tables.
pub fn csv(tables: &Path) -> Result<[String; 2]> {
    let few = table::read(tables.join("curet.bin"))?;
    let (degree, order) = (few.gram.degree, few.gram.order);
    let lights = read_lights(tables.join("inputs/lights.csv"), None)?.truncated(degree);
    let materials = read_materials(tables.join("inputs/materials.csv"), None)?.truncated(order);
    let mut scene = few.scene.clone();
    scene.basis.components = Some(usize::MAX);
    let whole = basis::build(&scene, &lights, &materials)?;

    let view = SphereView::new(SIZE);
    let inside = view.pixels.iter().zip(&view.normals).filter(|(pixel, _)| pixel.is_inside);
    let (shown_lights, other_lights) = split(&lights.entries, &shipped::SHOWN_LIGHTS);
    let (shown_materials, other_materials) = split(&materials.entries, &SHOWN_MATERIALS);
    let of_lights = |entries| Lights { degree, entries };
    let of_materials = |entries| Materials { order, entries };
    let normals = inside.map(|(_, normal)| *normal).collect();
    let set = TestSet::new(&of_lights(shown_lights), &of_materials(shown_materials), normals);
    let all = (lights, materials);
    let other = (of_lights(other_lights), of_materials(other_materials));
    let tables = [&few, &whole].into_iter();
    let cases: Vec<(&Table, Degradation)> =
        tables.flat_map(|table| ALL.map(|degradation| (table, degradation))).collect();
    let progress = progress_bar("cases", cases.len());
    let scored = parallel::map(cases.len(), &progress, |case| {
        let (table, degradation) = &cases[case];
        score(table, if degradation.is_unknown { &other } else { &all }, degradation, &set)
    });
    progress.finish_and_clear();
    let scored: Vec<Score> = scored.into_iter().collect::<Result<_>>()?;
    let rows = |cells: fn(&Score) -> Vec<String>| {
        cases.iter().zip(&scored).map(move |((table, degradation), score)| {
            [vec![table.count().to_string(), degradation.name.to_owned()], cells(score)].concat()
        })
    };
    let csv = |columns, cells| sheet::csv("report reading --out docs", columns, rows(cells));
    let estimates = "components,image,d: SP,d: LS,d: PM,image: SP,image: LS,image: PM";
    let scenes = "components,image,first,last place,light: 2,light: 9,true material: 2,\
                  true material: 9,posterior modes: 2,least-norm modes of LS: 2";
    Ok([csv(estimates, Score::of_estimates)?, csv(scenes, Score::of_scene)?])
}

/// The entries with one of these names, and the others.
fn split(entries: &[Named], names: &[&str]) -> (Vec<Named>, Vec<Named>) {
    entries.iter().cloned().partition(|entry| names.contains(&entry.name.as_str()))
}

/// Reads every image as one channel; images that show the same pixels are read together.
fn score(
    table: &Table,
    (lights, materials): &(Lights, Materials),
    degradation: &Degradation,
    set: &TestSet,
) -> Result<Score> {
    let reader = Reader::new(table, table.count(), lights, materials)?;
    let degrade =
        |(seed, image): (u64, &TestImage)| degradation.apply(&image.pixels, &set.normals, seed);
    let degraded: Vec<(Vec<f64>, Vec<f64>)> = (0..).zip(&set.images).map(degrade).collect();
    let together = if degradation.storage == Storage::Clipped { 1 } else { degraded.len() };
    let noise = (degradation.noise > 0.0).then_some(degradation.noise);
    let read = |group| reader.read(&observe(table, group, &set.normals), noise);
    let readings: Vec<Reading> = degraded.chunks(together).map(read).collect::<Result<_>>()?;
    Ok(scores(&readings, table, set, &degraded, materials))
}

fn observe(table: &Table, images: &[(Vec<f64>, Vec<f64>)], normals: &[[f64; 3]]) -> Observation {
    let mut observer = Observer::new(EigenimageValues::new(table, table.count()), images.len());
    for (pixel, normal) in normals.iter().enumerate() {
        let values: Vec<f64> = images.iter().map(|(image, _)| image[pixel]).collect();
        observer.see(*normal, &values, images[0].1[pixel]);
    }
    observer.finish()
}

#[derive(Clone, Copy, Debug)]
pub struct Degradation {
    pub name: &'static str,
    /// Standard deviation of normal noise on each pixel.
    pub noise: f64,
    pub storage: Storage,
    /// Whether the left half, n_x < 0, is hidden.
    pub is_half_hidden: bool,
    /// Whether the lights and materials of the images are absent from the statistics.
    pub is_unknown: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Storage {
    /// As exact numbers.
    Exact,
    /// In 8 bits, linear, with the peak at 254.
    Bits,
    /// In 8 bits of sRGB, with the peak at 254.
    SrgbBits,
    /// Clipped halfway between the image's mean and its peak, with the clipped pixels left out.
    Clipped,
    /// The same, with the clipped pixels kept at their clipped values.
    ClippedAndKept,
}

const NONE: Degradation = Degradation {
    name: "as it is",
    noise: 0.0,
    storage: Storage::Exact,
    is_half_hidden: false,
    is_unknown: false,
};
const HALF: Degradation = Degradation { name: "half hidden", is_half_hidden: true, ..NONE };
pub const ALL: [Degradation; 12] = [
    NONE,
    Degradation { name: "noise 1 %", noise: 0.01, ..NONE },
    Degradation { name: "noise 5 %", noise: 0.05, ..NONE },
    Degradation { name: "8 bits, linear", storage: Storage::Bits, ..NONE },
    Degradation { name: "8 bits, sRGB", storage: Storage::SrgbBits, ..NONE },
    Degradation { name: "clipped, left out", storage: Storage::Clipped, ..NONE },
    Degradation { name: "clipped, kept", storage: Storage::ClippedAndKept, ..NONE },
    HALF,
    Degradation { name: "half hidden, noise 1 %", noise: 0.01, ..HALF },
    Degradation { name: "half hidden, noise 5 %", noise: 0.05, ..HALF },
    Degradation { name: "unknown, noise 1 %", noise: 0.01, is_unknown: true, ..NONE },
    Degradation { name: "unknown, half hidden, noise 1 %", noise: 0.01, is_unknown: true, ..HALF },
];

impl Degradation {
    /// The degraded image and its weights. `seed` selects the noise, the same on every host.
    pub fn apply(&self, image: &[f64], normals: &[[f64; 3]], seed: u64) -> (Vec<f64>, Vec<f64>) {
        let mut random = ChaCha8Rng::seed_from_u64(seed);
        let mean = image.iter().sum::<f64>() / image.len() as f64;
        let clip = 0.5 * (1.0 + mean);
        let scale = 254.0 / 255.0;
        let pixel = |(value, normal): (&f64, &[f64; 3])| {
            let noise: f64 = StandardNormal.sample(&mut random);
            let value = value + self.noise * noise;
            let is_hidden = self.is_half_hidden && normal[0] < 0.0;
            let is_out = self.storage == Storage::Clipped && value >= clip;
            let stored = match self.storage {
                Storage::Exact => value,
                Storage::Bits => (254.0 * value).round().max(0.0) / 254.0,
                Storage::SrgbBits => linear(f64::from(srgb(scale * value)) / 255.0) / scale,
                Storage::Clipped | Storage::ClippedAndKept => value.min(clip),
            };
            (stored, if is_hidden || is_out { 0.0 } else { 1.0 })
        };
        image.iter().zip(normals).map(pixel).unzip()
    }
}

/// Iterations for a product in least-norm modes, of which many do not converge within 10,000.
const LEAST_NORM_TURNS: usize = 200;

/// Images of known lights on known materials, in luminance.
struct TestSet {
    /// The normal of each pixel.
    normals: Vec<[f64; 3]>,
    images: Vec<TestImage>,
}

/// An image by the direct sum, scaled to a peak of 1.
struct TestImage {
    light: Vec<f64>,
    material: Vec<f64>,
    name: String,
    pixels: Vec<f64>,
    /// The factor by which it was scaled.
    scale: f64,
}

impl TestSet {
    /// Combines every light with every material.
    fn new(lights: &Lights, materials: &Materials, normals: Vec<[f64; 3]>) -> Self {
        let images = direct_images(lights, materials, &normals);
        let names = materials.entries.iter().flat_map(|one| vec![&one.name; lights.entries.len()]);
        let image = |((light, material, pixels), name): (Image, &String)| {
            let scale = largest(pixels.iter().copied()).recip();
            let pixels = pixels.iter().map(|value| scale * value).collect();
            TestImage { light, material, name: name.clone(), pixels, scale }
        };
        Self { images: images.into_iter().zip(names).map(image).collect(), normals }
    }
}

/// The errors of all readings of one kind of degradation.
#[derive(Default)]
struct Score {
    /// |d - reference| / |reference| by scalar product, least squares and posterior mean.
    coefficients: [Vec<f64>; 3],
    /// Rms of the image's error over the pixels that were not seen (or over all pixels if all were
    /// seen), relative to its peak, by the same three methods.
    images: [Vec<f64>; 3],
    /// Rank of the true material among the candidates, from 1.
    places: Vec<usize>,
    /// Errors of the light, up to degree 2 and up to the table's degree, with the likeliest
    /// material and with the true one; then up to degree 2 from the product in the posterior modes,
    /// and up to degree 2 from the product in the least-norm modes of least squares.
    lights: [Vec<f64>; 6],
}

/// The median of many errors and the worst one.
fn cell(errors: &[f64]) -> String {
    match errors.iter().copied().max_by(f64::total_cmp) {
        Some(worst) => format!("{:.1e}, {worst:.1e}", median(errors)),
        None => "-".into(),
    }
}

impl Score {
    /// Errors of d for each estimate, then of its image where it was not seen.
    fn of_estimates(&self) -> Vec<String> {
        self.coefficients.iter().chain(&self.images).map(|errors| cell(errors)).collect()
    }

    /// Ranks of the true material, then errors of the light.
    fn of_scene(&self) -> Vec<String> {
        let first = self.places.iter().filter(|place| **place == 1).count();
        let places = match self.places.iter().max() {
            Some(last) => [format!("{first} of {}", self.places.len()), last.to_string()],
            None => ["-", "-"].map(String::from),
        };
        places.into_iter().chain(self.lights.iter().map(|errors| cell(errors))).collect()
    }
}

/// The scores of readings whose channels are the images. `degraded` has the pixels' weights.
fn scores(
    readings: &[Reading],
    table: &Table,
    set: &TestSet,
    degraded: &[(Vec<f64>, Vec<f64>)],
    materials: &Materials,
) -> Score {
    let components = table.count();
    let transfers = Transfers::new(table, components);
    let values = EigenimageValues::new(table, components);
    let mut rows = vec![vec![0.0; components + 1]; set.normals.len()];
    rows.iter_mut().zip(&set.normals).for_each(|(row, normal)| values.at(*normal, row));
    let channels =
        readings.iter().flat_map(|reading| (0..reading.channels.len()).map(move |c| (reading, c)));
    let images = set.images.iter().zip(degraded);
    let mut score = Score::default();
    for ((reading, channel), (image, (_, weights))) in channels.zip(images) {
        let light = &image.light;
        let reference: Vec<f64> = transfers
            .of(&image.material)
            .row_iter()
            .map(|row| image.scale * row.iter().zip(light).map(|(t, l)| t * l).sum::<f64>())
            .collect();
        let all = weights.iter().all(|weight| *weight > 0.0);
        let unseen: Vec<usize> =
            (0..weights.len()).filter(|pixel| all || weights[*pixel] == 0.0).collect();
        let found = &reading.channels[channel];
        let estimates = [&found.scalar_product.0, &found.least_squares.0, &found.posterior.0.d];
        for (which, d) in estimates.into_iter().enumerate() {
            score.coefficients[which].push(distance(d, &reference) / length(&reference));
            let off = |&pixel: &usize| {
                let made: f64 = rows[pixel].iter().zip(d).map(|(u, d)| u * d).sum();
                (made - image.pixels[pixel]).powi(2)
            };
            let square: f64 = unseen.iter().map(off).sum();
            score.images[which].push((square / unseen.len() as f64).sqrt());
        }
        let mut ranked: Vec<_> = reading.candidates.iter().collect();
        ranked
            .sort_by(|a, b| b.channels[channel].evidence.total_cmp(&a.channels[channel].evidence));
        let low = light::count(2).min(light.len());
        let mut add = |which: usize, estimate: &[f64], count: usize| {
            score.lights[which].push(misdirection(&estimate[..count], &light[..count]));
        };
        let best = &ranked[0].channels[channel].light;
        add(0, best, low);
        add(1, best, light.len());
        let place = ranked.iter().position(|one| materials.entries[one.index].name == image.name);
        if let Some(place) = place {
            let known = &ranked[place].channels[channel].light;
            score.places.push(place + 1);
            add(2, known, low);
            add(3, known, light.len());
        }
        add(4, &found.product.light, low);
        if let Ok(product) = RankOne::within(&found.least_norm, LEAST_NORM_TURNS) {
            add(5, &product.light, low);
        }
    }
    score
}

fn length(values: &[f64]) -> f64 {
    values.iter().map(|value| value * value).sum::<f64>().sqrt()
}

fn distance(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// |s found - reference| / |reference| at the best s: unknown albedo leaves the exposure open.
fn misdirection(found: &[f64], reference: &[f64]) -> f64 {
    let product: f64 = found.iter().zip(reference).map(|(a, b)| a * b).sum();
    let square = found.iter().map(|a| a * a).sum::<f64>();
    let factor = if square > 0.0 { product / square } else { 0.0 };
    let scaled: Vec<f64> = found.iter().map(|a| factor * a).collect();
    distance(&scaled, reference) / length(reference)
}
