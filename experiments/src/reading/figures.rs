//! Reads figures back from the tables of `docs/reading.md`.

use crate::tolerances;

/// Tolerance for the figures of undamaged images, as a logarithm: they are amplified rounding,
/// which differs between hosts.
const REPORT_ROUNDING: f64 = 1.5;

/// Damage that leaves only rounding errors if all components are used.
const EXACT: [&str; 3] = ["as it is", "clipped, left out", "half hidden"];

/// The cells of every row of both tables.
#[must_use]
pub fn cells(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    text.lines()
        .filter(|line| line.starts_with("| 50 |") || line.starts_with("| 218 |"))
        .map(row)
        .collect()
}

/// The numbers of a cell, `median, worst` or `first of all`.
#[must_use]
pub fn numbers(cell: &str) -> Vec<f64> {
    cell.split([',', ' ']).filter_map(|word| word.parse().ok()).collect()
}

/// Compares the figures of two pages: within [`tolerances::REPORT`], or within [`REPORT_ROUNDING`]
/// for those that are only rounding. Counts may be off by one.
///
/// # Errors
///
/// The first row that differs.
pub fn compare(recorded: &str, now: &str) -> Result<(), String> {
    let [recorded, now] = [recorded, now].map(cells);
    if recorded.len() != now.len() {
        return Err(format!("it has {} rows where there are {}", recorded.len(), now.len()));
    }
    for (old, new) in recorded.iter().zip(&now) {
        let is_exact = old[0] == "218" && EXACT.contains(&old[1].as_str());
        let allowed = if is_exact { REPORT_ROUNDING } else { tolerances::REPORT };
        let near = |(a, b): (&f64, &f64)| {
            (a / b).ln().abs() <= allowed || (a.fract() == 0.0 && (a - b).abs() <= 1.0)
        };
        let same = |(old, new): (&String, &String)| {
            let (old, new) = (numbers(old), numbers(new));
            old.len() == new.len() && old.iter().zip(&new).all(near)
        };
        if old[..2] != new[..2] || !old.iter().zip(new).skip(2).all(same) {
            return Err(format!("it says {old:?} where it is {new:?}"));
        }
    }
    Ok(())
}
