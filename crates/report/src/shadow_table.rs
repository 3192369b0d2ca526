//! The table of `docs/shadows.md` from `docs/shadows.csv`.

use crate::pages::{Part, table};
use crate::shadows::{MATERIALS, WAYS};
use crate::sheet::{Record, Sheet};
use std::iter;

/// The names of [`WAYS`] on the page.
const TITLES: [&str; WAYS.len()] = [
    "without shadows",
    "transports of all pixels",
    "a code for each pixel",
    "4,096 codes",
    "1,024 codes",
];

/// For each way and material the rms and the mean CIEDE2000 under tilted lights, each from the best
/// shape to the worst.
#[must_use]
pub fn part(sheet: &Sheet) -> Part {
    let lines = WAYS.iter().zip(TITLES).map(|((way, _), title)| {
        let rows = sheet.rows.iter().filter(|row| row.text("way") == *way);
        let bytes = range(rows.filter_map(|row| row.number("bytes")));
        let bytes = bytes.map_or_else(String::new, |[least, most]| {
            format!("{:.0} to {:.0} KB", least / 1e3, most / 1e3)
        });
        let cells = MATERIALS.iter().map(|material| {
            let of = |column: &str| cell(sheet, way, material, column);
            format!("{}; {}", of("tilted_rms"), of("tilted_mean"))
        });
        [title.to_owned(), bytes].into_iter().chain(cells).collect()
    });
    let columns: String = MATERIALS.iter().map(|material| format!(" | {material}:")).collect();
    ("shapes", table(&format!(" | bytes:{columns}"), lines))
}

/// The mean CIEDE2000 without and with shadows, as the README states it.
#[must_use]
pub fn limits(sheet: &Sheet) -> Part {
    let lines =
        [("convex", "without shadows"), ("codes: 4096", "with its shadows")].map(|(way, title)| {
            let cells = MATERIALS.iter().map(|material| cell(sheet, way, material, "tilted_mean"));
            iter::once(title.to_owned()).chain(cells).collect()
        });
    let columns: String = MATERIALS.iter().map(|material| format!(" | {material}:")).collect();
    ("reliefs", table(&format!("a relief{columns}"), lines))
}

/// A column of a way and a material, from the best shape to the worst.
fn cell(sheet: &Sheet, way: &str, material: &str, column: &str) -> String {
    let is_of = |row: &&Record| row.text("way") == way && row.text("material") == material;
    let rows = sheet.rows.iter().filter(is_of);
    let found = range(rows.filter_map(|row| row.number(column)));
    found.map_or("-".into(), |[least, most]| format!("{least:.1} to {most:.1}"))
}

fn range(numbers: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    numbers.fold(None, |range, one| {
        let [least, most] = range.unwrap_or([one; 2]);
        Some([f64::min(least, one), f64::max(most, one)])
    })
}
