//! The tables of the page, made from the figures' CSV files.

use super::variance::SURFACES;
use super::{Modes, Sheets, title};
use crate::numbers::{self, limit};
use crate::pages::{self, Part};
use crate::sheet::Sheet;
use eigenshade_cli::messages::grouped;
use eigenshade_model::error::{Error, Result};
use std::fs;
use std::path::Path;

/// Numbers of components for which errors are given.
const COUNTS: [usize; 8] = [5, 6, 9, 10, 20, 30, 50, 100];
/// Numbers of components for which reconstructions are given.
const RECONSTRUCTED: [usize; 7] = [5, 10, 20, 30, 40, 50, 70];
/// Errors for which numbers of components are given.
const LIMITS: [f64; 4] = [0.1, 0.05, 0.01, 0.001];
/// A material is represented if its mean error is at most this.
const REPRESENTED: f64 = 0.1;

impl Sheet {
    pub fn of(self, modes: Modes) -> Self {
        self.only("modes", &modes.count().to_string())
    }
}

fn variance(sheets: &Sheets) -> Table {
    let of = |&(_, degree, name): &(usize, usize, &str)| {
        let sheet = sheets["variance_beyond"].clone().only("surface", name);
        let (modes, beyond) = (sheet.numbers("modes"), sheet.numbers("beyond"));
        [degree as f64, modes[degree], beyond[degree], beyond[degree - 1]]
    };
    let numbers: Vec<[f64; 4]> = SURFACES.iter().map(of).collect();
    let column = |k: usize| numbers.iter().map(|row| row[k]).collect();
    Table::new("surface", SURFACES.map(|(_, _, name)| name.to_owned()))
        .column("l up to", column(0), count)
        .column("modes", column(1), count)
        .column("variance beyond", column(2), percent)
        .column("beyond one degree less", column(3), percent)
}

fn spheres(sheets: &Sheets) -> Table {
    let [whole, selected] = Modes::BOTH.map(|modes| sheets["spheres"].clone().of(modes));
    Table::new("sphere", pairs(&whole))
        .column("slant of the brightest point", whole.numbers("slant_of_peak"), degrees)
        .column("negative", whole.numbers("share_below_zero"), percent)
        .column("negative, 1,000 modes", selected.numbers("share_below_zero"), percent)
        .column("rms difference, 1,000 modes", selected.numbers("rms_off_of_peak"), percent)
        .column("error, 1,000 modes", selected.numbers("error"), percent)
}

fn errors(sheets: &Sheets) -> Table {
    let sheet = &sheets["error"];
    let column = |name: &str| at(&sheet.numbers(name), &COUNTS);
    Table::new("components", COUNTS.map(|count| count.to_string()))
        .column("image-centered", column("image_centered"), percent)
        .column("standard", column("standard"), percent)
        .column("image-centered, 1,000 modes", column("image_centered_1000"), percent)
        .column("standard, 1,000 modes", column("standard_1000"), percent)
}

/// The errors of each material under the lights as captured, and under rotated lights.
fn poses(sheets: &Sheets) -> [Sheet; 2] {
    ["error_by_material", "error_rotated"].map(|name| sheets[name].clone())
}

fn components(sheets: &Sheets) -> Table {
    let [sheet, _] = poses(sheets);
    let counts = |limit: f64| -> Vec<f64> {
        let names = sheet.columns[1..].iter();
        let mut counts: Vec<f64> =
            names.map(|name| needed(&sheet.numbers(name), limit) as f64).collect();
        counts.sort_by(f64::total_cmp);
        counts
    };
    let sorted = LIMITS.map(counts);
    let (middle, last) = (sorted[0].len() / 2, sorted[0].len() - 1);
    let at = |place: usize| sorted.iter().map(|counts| counts[place]).collect();
    let of = |name| LIMITS.map(|limit| needed(&sheet.numbers(name), limit) as f64).into();
    Table::new("mean error within", LIMITS.map(limit))
        .column("fewest", at(0), count)
        .column("median", at(middle), count)
        .column("most", at(last), count)
        .column("velvet", of("07-velvet"), count)
        .column("leather", of("05-leather"), count)
}

fn rotations(sheets: &Sheets) -> Table {
    let poses = poses(sheets);
    let mean = [sheets["error"].numbers("image_centered"), poses[1].numbers("all")];
    let of = |pose: usize| {
        let (sheet, mean) = (&poses[pose], &mean[pose]);
        let error = |name| percent(sheet.numbers(name)[5]);
        let within = |count: usize| {
            let names = sheet.columns.iter().filter(|name| name.contains('-'));
            names.filter(|name| sheet.numbers(name)[count] <= REPRESENTED).count().to_string()
        };
        let named = ["07-velvet", "05-leather", "11-plaster-b"].map(error);
        let all = [percent(mean[5])].into_iter().chain(named);
        all.chain([5, 6, 8, 10].map(within)).collect::<Vec<_>>()
    };
    let names = ["all materials", "velvet", "leather", "plaster b"];
    let names = names.map(|name| format!("error with 5 components, {name}"));
    let counts = [5, 6, 8, 10].map(|k| format!("materials within 10 % with {k} components"));
    Table::new("", names.into_iter().chain(counts))
        .texts("lights as captured", of(0))
        .texts("lights rotated every way", of(1))
}

fn reconstruction(sheets: &Sheets) -> Table {
    let column = |material: &str, column: &str| {
        let sheet = sheets["reconstruction"].clone().only("material", material);
        at(&sheet.numbers(column), &RECONSTRUCTED)
    };
    Table::new("components", RECONSTRUCTED.map(|count| count.to_string()))
        .column("velvet, forest: error", column("07-velvet", "error"), percent)
        .column("its brightest point", column("07-velvet", "brightest"), percent)
        .column("leather, studio: error", column("05-leather", "error"), percent)
        .column("its brightest point", column("05-leather", "brightest"), percent)
}

fn bound(sheets: &Sheets) -> Table {
    let [all, selected] = Modes::BOTH.map(|modes| sheets["bound"].clone().of(modes));
    Table::new("accuracy", all.numbers("accuracy").into_iter().map(limit))
        .column("terms: fewest", all.numbers("least_terms"), count)
        .column("median", all.numbers("median_terms"), count)
        .column("most", all.numbers("most_terms"), count)
        .column("sufficient, median", all.numbers("sufficient_terms"), count)
        .column("largest error", all.numbers("largest_error"), percent)
        .column("error / bound, largest", all.numbers("largest_error_over_bound"), ratio)
        .column("above the uncorrelated sum", all.numbers("exceeding_uncorrelated"), percent)
        .column("images that 1,000 modes reach", selected.numbers("images"), count)
}

fn bound_spheres(sheets: &Sheets) -> Table {
    let sheet = &sheets["bound_spheres"];
    Table::new("sphere", pairs(sheet))
        .column("stated", sheet.numbers("accuracy"), limit)
        .column("terms", sheet.numbers("terms"), count)
        .column("bound", sheet.numbers("bound"), percent)
        .column("error", sheet.numbers("error"), percent)
        .column("error over pixels", sheet.numbers("pixel_error"), percent)
        .column("largest pixel", sheet.numbers("largest_pixel_error"), percent)
}

/// Makes a table from the figures' numbers.
type TableOf = fn(&Sheets) -> Table;

/// The tables, by the names of their markers in the page.
const TABLES: [(&str, TableOf); 8] = [
    ("variance", variance),
    ("spheres", spheres),
    ("errors", errors),
    ("components", components),
    ("rotations", rotations),
    ("reconstruction", reconstruction),
    ("bound", bound),
    ("bound spheres", bound_spheres),
];

/// Reads the CSV files of `docs/paper`.
pub fn read(folder: &Path) -> Result<Sheets> {
    let mut sheets = Sheets::new();
    for entry in fs::read_dir(folder).map_err(|error| Error::io(folder, &error))? {
        let path = entry.map_err(|error| Error::io(folder, &error))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        if let Some(name) = name.strip_suffix(".csv") {
            sheets.insert(name.to_owned(), Sheet::read(&path)?);
        }
    }
    Ok(sheets)
}

/// The tables of the page.
pub fn parts(sheets: &Sheets) -> Vec<Part> {
    TABLES.iter().map(|(name, made)| (*name, made(sheets).text())).collect()
}

/// The least number of components with at most this error.
pub fn needed(errors: &[f64], error: f64) -> usize {
    errors.iter().position(|found| *found <= error).unwrap_or(errors.len())
}

fn pairs(sheet: &Sheet) -> Vec<String> {
    let names = sheet.texts("material").into_iter().zip(sheet.texts("light"));
    names.map(|(material, light)| format!("{}, {light}", title(material))).collect()
}

fn at(column: &[f64], places: &[usize]) -> Vec<f64> {
    places.iter().map(|&place| column[place]).collect()
}

/// A Markdown table: names in the first column, numbers in the others.
struct Table {
    columns: String,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn new(header: &str, names: impl IntoIterator<Item = String>) -> Self {
        Self { columns: header.into(), rows: names.into_iter().map(|name| vec![name]).collect() }
    }

    fn texts(mut self, header: &str, texts: impl IntoIterator<Item = String>) -> Self {
        self.columns += &format!(" | {header}:");
        self.rows.iter_mut().zip(texts).for_each(|(row, text)| row.push(text));
        self
    }

    fn column(self, header: &str, numbers: Vec<f64>, format: fn(f64) -> String) -> Self {
        self.texts(header, numbers.into_iter().map(format))
    }

    fn text(self) -> String {
        pages::table(&self.columns, self.rows)
    }
}

fn count(value: f64) -> String {
    grouped(value as usize)
}

fn degrees(value: f64) -> String {
    format!("{value:.0}°")
}

fn ratio(value: f64) -> String {
    format!("{value:.3}")
}

/// A share in percent, with three digits.
fn percent(share: f64) -> String {
    numbers::percent(share, 3)
}
