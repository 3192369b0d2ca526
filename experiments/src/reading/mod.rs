//! Errors of estimates of light and material from degraded images.
//!
//! `experiments reading` writes the tables of `docs/reading.md`.

pub mod degrade;
mod score;

use crate::pages::{Page, Part, same_word, table};
use crate::tolerances;
use degrade::Degradation;
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
    let other_lights = Lights { degree, entries: other_lights };
    let other_materials = Materials { order, entries: other_materials };
    let normals = inside.map(|(_, normal)| *normal).collect();
    let set = TestSet::new([shown_lights, shown_materials], [degree, order], normals);
    // Alternates cheap and expensive cases, so that threads share them evenly.
    let cases: Vec<(Degradation, Database<'_>)> = degrade::ALL
        .into_iter()
        .flat_map(|degradation| {
            let (lights, materials) = if degradation.is_unknown {
                (&other_lights, &other_materials)
            } else {
                (&lights, &materials)
            };
            [&few, &whole].map(|table| (degradation, Database { table, lights, materials }))
        })
        .collect();
    let progress = progress_bar("cases", cases.len());
    let scored = parallel::map(cases.len(), &progress, |case| {
        let (degradation, database) = &cases[case];
        database.score(degradation, &set)
    });
    progress.finish_and_clear();
    let scored: Vec<Score> = scored.into_iter().collect::<Result<_>>()?;
    let rows = |cells: fn(&Score) -> Vec<String>| {
        let of_table = |first: usize| cases.iter().zip(&scored).skip(first).step_by(2);
        let row =
            move |((degradation, database), score): (&(Degradation, Database<'_>), &Score)| {
                let count = database.table.count().to_string();
                [vec![count, degradation.name.to_owned()], cells(score)].concat()
            };
        (0..2).flat_map(of_table).map(row).collect::<Vec<_>>()
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

/// A table with the data from which the statistics of a reading are made.
struct Database<'a> {
    table: &'a Table,
    lights: &'a Lights,
    materials: &'a Materials,
}

impl Database<'_> {
    /// Reads every image as one channel; images that show the same pixels are read together.
    fn score(&self, degradation: &Degradation, set: &TestSet) -> Result<Score> {
        let reader = Reader::new(self.table, self.table.count(), self.lights, self.materials)?;
        let degraded: Vec<(Vec<f64>, Vec<f64>)> = (0u64..)
            .zip(&set.images)
            .map(|(seed, image)| degradation.apply(image, &set.normals, seed))
            .collect();
        let together = if degradation.is_the_same_for_all() { degraded.len() } else { 1 };
        let read = |group| {
            reader.read(&observe(self.table, group, &set.normals), degradation.stated_noise())
        };
        let readings: Vec<Reading> = degraded.chunks(together).map(read).collect::<Result<_>>()?;
        Ok(scores(&readings, self.table, set, &degraded, self.materials))
    }
}

fn observe(table: &Table, images: &[(Vec<f64>, Vec<f64>)], normals: &[[f64; 3]]) -> Observation {
    let mut observer = Observer::new(EigenimageValues::new(table, table.count()), images.len());
    for (pixel, normal) in normals.iter().enumerate() {
        let values: Vec<f64> = images.iter().map(|(image, _)| image[pixel]).collect();
        observer.see(*normal, &values, images[0].1[pixel]);
    }
    observer.finish()
}
