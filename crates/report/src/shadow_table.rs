//! The table of `docs/shadows.md` from `docs/shadows.csv`.

use crate::pages::{Part, table};
use crate::shadows::{MATERIALS, WAYS};
use crate::sheet::{Record, Sheet};

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
        let of_way: Vec<&Record> =
            sheet.rows.iter().filter(|row| row.text("way") == *way).collect();
        let bytes = range(of_way.iter().filter_map(|row| row.number("bytes")));
        let bytes = bytes.map_or_else(String::new, |[least, most]| {
            format!("{:.0} to {:.0} KB", least / 1e3, most / 1e3)
        });
        let cells = MATERIALS.iter().map(|material| {
            let of = |column: &str| {
                let rows = of_way.iter().filter(|row| row.text("material") == *material);
                let found = range(rows.filter_map(|row| row.number(column)));
                found.map_or("-".into(), |[least, most]| format!("{least:.1} to {most:.1}"))
            };
            format!("{}; {}", of("tilted_rms"), of("tilted_mean"))
        });
        [title.to_owned(), bytes].into_iter().chain(cells).collect()
    });
    let columns: String = MATERIALS.iter().map(|material| format!(" | {material}:")).collect();
    ("shapes", table(&format!(" | bytes:{columns}"), lines))
}

fn range(numbers: impl Iterator<Item = f64>) -> Option<[f64; 2]> {
    numbers.fold(None, |range, one| {
        let [least, most] = range.unwrap_or([one; 2]);
        Some([f64::min(least, one), f64::max(most, one)])
    })
}
