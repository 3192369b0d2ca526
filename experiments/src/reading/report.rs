//! The tables of the errors of estimates from damaged images.

use super::damage::{self, Damage};
use super::score::{Score, Truths, scores};
use crate::pages::Part;
use eigenshade_cli::output::message::bar;
use eigenshade_cli::picture::sphere_view::SphereView;
use eigenshade_cli::reading::image_reading::{Reader, Reading};
use eigenshade_cli::table::table_file;
use eigenshade_generator::basis;
use eigenshade_generator::reading::eigenimage_values::EigenimageValues;
use eigenshade_generator::reading::observation::{Observation, Observer};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_shading::{parallel, shipped};
use eigenshade_table::Table;
use std::fmt::Write as _;
use std::path::Path;

/// The command that regenerates the tables.
pub const COMMAND: &str = "cargo run --release -p experiments -- reading --out docs/reading.md";

const HEAD_ESTIMATES: &str = "\
| components | image | d: SP | d: LS | d: PM | image: SP | image: LS | image: PM |
|---:|---|---:|---:|---:|---:|---:|---:|
";
const HEAD_SCENES: &str = "\
| components | image | first | last place | light 2 | light 9 | true, 2 | true, 9 | posterior modes, 2 | least-norm modes of LS, 2 |
|---:|---|---:|---:|---:|---:|---:|---:|---:|---:|
";

/// Width of each image in pixels.
const SIZE: usize = 64;

/// The tables of the page: errors of the estimates, then ranks of the material and errors of the
/// light. `tables` is the folder of the shipped tables.
///
/// # Errors
///
/// If a table or database cannot be read.
pub fn parts(tables: &Path) -> Result<Vec<Part>> {
    let table = table_file::read(tables.join("sphere.bin"))?;
    let (degree, order) = (table.gram.degree, table.gram.order);
    let lights = read_lights(tables.join("inputs/lights.csv"), None)?.truncated(degree);
    let materials = read_materials(tables.join("inputs/materials.csv"), None)?.truncated(order);
    let mut scene = table.scene.clone();
    scene.basis.components = Some(usize::MAX);
    let whole = basis::build(&scene, &lights, &materials)?;

    let view = SphereView::new(SIZE);
    let inside = view.pixels.iter().zip(&view.normals).filter(|(pixel, _)| pixel.is_inside);
    let normals: Vec<[f64; 3]> = inside.map(|(_, normal)| *normal).collect();
    let truths = Truths::new(
        [
            chosen(&lights.entries, &shipped::SHOWN_LIGHTS),
            chosen(&materials.entries, &shipped::SHOWN_MATERIALS),
        ],
        [degree, order],
        normals,
    );
    let known =
        [&table, &whole].map(|table| Database { table, lights: &lights, materials: &materials });
    let other_lights = Lights { degree, entries: others(&lights.entries, &shipped::SHOWN_LIGHTS) };
    let entries = others(&materials.entries, &shipped::SHOWN_MATERIALS);
    let other_materials = Materials { order, entries };
    let unknown =
        known.map(|known| Database { lights: &other_lights, materials: &other_materials, ..known });
    // Alternates cheap and expensive cases, so that threads share them evenly.
    let cases: Vec<(Damage, Database<'_>)> = damage::ALL
        .into_iter()
        .flat_map(|damage| (if damage.is_unknown { unknown } else { known }).map(|of| (damage, of)))
        .collect();
    let progress = bar("cases", cases.len());
    let scored = parallel::map(cases.len(), &progress, |case| {
        let (damage, database) = cases[case];
        database.score(damage, &truths)
    });
    progress.finish_and_clear();
    let scored: Vec<Score> = scored.into_iter().collect::<Result<_>>()?;
    let (mut estimates, mut scenes) = (HEAD_ESTIMATES.to_owned(), HEAD_SCENES.to_owned());
    for of_table in 0..2 {
        let cases = cases.iter().zip(&scored).skip(of_table).step_by(2);
        for ((damage, database), score) in cases {
            let (count, name) = (database.table.components.len(), damage.name);
            let _ = writeln!(estimates, "| {count} | {name} |{}", estimate_cells(score));
            let _ = writeln!(scenes, "| {count} | {name} |{}", scene_cells(score));
        }
    }
    Ok(vec![("estimates", estimates), ("scenes", scenes)])
}

fn chosen(entries: &[Named], names: &[&str]) -> Vec<Named> {
    entries.iter().filter(|entry| names.contains(&entry.name.as_str())).cloned().collect()
}

fn others(entries: &[Named], names: &[&str]) -> Vec<Named> {
    entries.iter().filter(|entry| !names.contains(&entry.name.as_str())).cloned().collect()
}

/// A table with the data from which the statistics of a reading are made.
#[derive(Clone, Copy)]
struct Database<'a> {
    table: &'a Table,
    lights: &'a Lights,
    materials: &'a Materials,
}

impl Database<'_> {
    fn score(&self, damage: Damage, truths: &Truths) -> Result<Score> {
        let readings = self.readings(damage, truths)?;
        Ok(scores(&readings, self.table, truths, damage, self.materials))
    }

    /// Reads every image as one channel; images that show the same pixels are read together.
    fn readings(&self, damage: Damage, truths: &Truths) -> Result<Vec<Reading>> {
        let components = self.table.components.len();
        let reader = Reader::new(self.table, components, self.lights, self.materials)?;
        let damaged: Vec<(Vec<f64>, Vec<f64>)> = (0u64..)
            .zip(&truths.images)
            .map(|(seed, image)| damage.apply(image, &truths.normals, seed))
            .collect();
        let together = if damage.is_the_same_for_all() { damaged.len() } else { 1 };
        damaged
            .chunks(together)
            .map(|group| {
                let observation = observe(self.table, group, &truths.normals);
                reader.read(&observation, damage.stated_noise())
            })
            .collect()
    }
}

fn observe(table: &Table, images: &[(Vec<f64>, Vec<f64>)], normals: &[[f64; 3]]) -> Observation {
    let values = EigenimageValues::new(table, table.components.len());
    let mut observer = Observer::new(values, images.len());
    for (pixel, normal) in normals.iter().enumerate() {
        let values: Vec<f64> = images.iter().map(|(image, _)| image[pixel]).collect();
        observer.see(*normal, &values, images[0].1[pixel]);
    }
    observer.finish()
}

/// Median and worst error of d for each estimate, then of its image where it was not seen.
fn estimate_cells(score: &Score) -> String {
    let groups = [&score.coefficients, &score.images];
    groups.iter().flat_map(|group| group.iter()).map(|errors| format!(" {errors} |")).collect()
}

/// Ranks of the true material, then errors of the light.
fn scene_cells(score: &Score) -> String {
    let places = if score.places.is_empty() {
        " - | - |".to_owned()
    } else {
        let first = score.places.iter().filter(|place| **place == 0).count();
        let mut sorted = score.places.clone();
        sorted.sort_unstable();
        let worst = sorted.last().map_or(0, |place| place + 1);
        format!(" {first} of {} | {worst} |", sorted.len())
    };
    let lights = score.lights.iter().map(|errors| format!(" {errors} |"));
    places + &lights.collect::<String>()
}
