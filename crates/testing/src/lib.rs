//! Test oracles and fixtures shared by several packages.
#![expect(missing_docs, reason = "no published package depends on it")]

use std::path::{Path, PathBuf};

pub mod tolerances;
pub mod vectors;

pub mod oracle;
pub mod rotations;

pub mod fixtures;
pub mod glossy;

pub mod images;
pub mod pictures;

pub mod golden;

/// The root of the repository.
#[must_use]
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The part of a page between `<!-- NAME: ... -->` and `<!-- end of NAME -->`.
#[must_use]
pub fn part<'a>(page: &'a str, name: &str) -> &'a str {
    let (_, part) = page.split_once(&format!("<!-- {name}: ")).expect("the part's start");
    part.split_once(&format!("<!-- end of {name} -->")).expect("the part's end").0
}

/// Asserts that the part of a page has a line that begins like this and states these numbers, to a
/// share of each.
pub fn assert_stated(page: &str, name: &str, start: &str, found: &[f64], tolerance: f64) {
    let line = part(page, name).lines().find_map(|line| line.strip_prefix(start));
    let line = line.unwrap_or_else(|| panic!("the table `{name}` of the page lacks `{start}`"));
    let stated: Vec<f64> =
        line.split(['|', '/']).filter_map(|one| one.trim().parse().ok()).collect();
    let printed: Vec<String> = found.iter().map(|one| format!("{one:.3e}")).collect();
    println!("{start} {}", printed.join(" | "));
    assert_eq!(stated.len(), found.len(), "{start}{line}");
    for (stated, found) in stated.iter().zip(found) {
        assert!((stated - found).abs() <= tolerance * found, "{start}{line}: {found}");
    }
}

/// The largest |x|, or NaN if any value is NaN.
pub fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, value| {
        if value.is_nan() || value.abs() > most { value.abs() } else { most }
    })
}

/// The largest |a - b| of lists of one length.
#[must_use]
pub fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len(), "lists of one length");
    largest(a.iter().zip(b).map(|(a, b)| a - b))
}

/// The median and the largest of some numbers.
#[must_use]
pub fn median_and_largest<T: PartialOrd + Copy>(mut values: Vec<T>) -> [T; 2] {
    values.sort_by(|a, b| a.partial_cmp(b).expect("numbers"));
    [values[values.len() / 2], values[values.len() - 1]]
}

/// The largest error relative to the largest expected value.
#[must_use]
pub fn relative_error(found: &[f64], expected: &[f64]) -> f64 {
    largest_difference(found, expected) / largest(expected.iter().copied())
}
