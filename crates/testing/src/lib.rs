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

pub mod glb;
pub mod golden;

/// The root of the repository.
#[must_use]
pub fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Asserts that these numbers are the recorded ones, to a share of each.
pub fn assert_recorded(name: &str, found: &[f64], recorded: &[f64], tolerance: f64) {
    let printed: Vec<String> = found.iter().map(|one| format!("{one:.3e}")).collect();
    println!("{name}: {}", printed.join(", "));
    assert_eq!(found.len(), recorded.len(), "{name}");
    for (found, recorded) in found.iter().zip(recorded) {
        assert!((recorded - found).abs() <= tolerance * found, "{name}: {found} for {recorded}");
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
