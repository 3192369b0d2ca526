//! Errors of estimates of light and material from degraded images.
//!
//! `experiments reading` writes the tables of `docs/reading.md`.

mod degrade;
mod score;

use crate::pages::{Page, Part, same_word, table};
use crate::tolerances;
use degrade::{Degradation, Storage};
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::picture::SphereView;
use eigenshade_cli::reading::{Reader, Reading};
use eigenshade_cli::table;
use eigenshade_generator::basis;
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_shading::{parallel, shipped};
use eigenshade_table::Table;
use score::{Score, TestSet, scores};
use std::path::Path;

/// Tolerance for the figures of images that are not degraded, as a logarithm: they are amplified
/// rounding, which differs between hosts.
const ROUNDING: f64 = 1.5;

/// Rows of figures that are only rounding: all components, and no error in the pixels that are
/// used.
const EXACT: [&str; 3] =
    ["| 218 | as it is |", "| 218 | clipped, left out |", "| 218 | half hidden |"];

/// `docs/reading.md`. Counts may be off by one.
pub const PAGE: Page = Page {
    name: "reading",
    same: |line, old, new| {
        let is_exact = EXACT.iter().any(|start| line.starts_with(start));
        let allowed = if is_exact { ROUNDING } else { tolerances::REPORT };
        let mut names = line.split('|').take(3).flat_map(str::split_whitespace);
        let is_name = names.any(|word| word == old);
        let counts = [old, new].map(|word| word.parse::<i32>().ok().filter(|_| !is_name));
        match counts {
            [Some(old), Some(new)] => old.abs_diff(new) <= 1,
            _ => same_word(old, new, |old, new| (old / new).ln().abs() <= allowed),
        }
    },
};

/// Width of each image in pixels.
const SIZE: usize = 64;

/// The tables of the page: errors of the estimates, then ranks of the material and errors of the
/// light. `tables` is the folder of the shipped tables.
///
/// # Errors
///
/// If a table or database cannot be read.
pub fn parts(tables: &Path) -> Result<Vec<Part>> {
    let few = table::read(tables.join("sphere.bin"))?;
    let (degree, order) = (few.gram.degree, few.gram.order);
    let lights = read_lights(tables.join("inputs/lights.csv"), None)?.truncated(degree);
    let materials = read_materials(tables.join("inputs/materials.csv"), None)?.truncated(order);
    let mut scene = few.scene.clone();
    scene.basis.components = Some(usize::MAX);
    let whole = basis::build(&scene, &lights, &materials)?;

    let view = SphereView::new(SIZE);
    let inside = view.pixels.iter().zip(&view.normals).filter(|(pixel, _)| pixel.is_inside);
    let (shown_lights, other_lights) = split(&lights.entries, &shipped::SHOWN_LIGHTS);
    let (shown_materials, other_materials) = split(&materials.entries, &shipped::SHOWN_MATERIALS);
    let of_lights = |entries| Lights { degree, entries };
    let of_materials = |entries| Materials { order, entries };
    let normals = inside.map(|(_, normal)| *normal).collect();
    let set = TestSet::new(&of_lights(shown_lights), &of_materials(shown_materials), normals);
    let all = (lights, materials);
    let other = (of_lights(other_lights), of_materials(other_materials));
    let cases: Vec<(&Table, Degradation)> = [&few, &whole]
        .into_iter()
        .flat_map(|table| degrade::ALL.map(|degradation| (table, degradation)))
        .collect();
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
    let estimates =
        "components: | image | d: SP: | d: LS: | d: PM: | image: SP: | image: LS: | image: PM:";
    let scenes = "\
        components: | image | first: | last place: | light 2: | light 9: | true, 2: | true, 9: \
        | posterior modes, 2: | least-norm modes of LS, 2:";
    Ok(vec![
        ("estimates", table(estimates, rows(Score::of_estimates))),
        ("scenes", table(scenes, rows(Score::of_scene))),
    ])
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
    let degraded: Vec<(Vec<f64>, Vec<f64>)> = (0u64..)
        .zip(&set.images)
        .map(|(seed, image)| degradation.apply(&image.pixels, &set.normals, seed))
        .collect();
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
