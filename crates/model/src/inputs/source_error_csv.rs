//! The screen errors with the first n sources of lights as CSV: one row per light, number of
//! sources, size and base,
//! `light,sources,degree,order,base,mean_0.1,..,mean_0.6,p95_0.1,..,p95_0.6,white_0.1,..,white_0.6`.
//!
//! `base` is `metal` or `dielectric`; the
//! numbers in the names are the roughness. Other columns and lines that begin with `#` are ignored.

use super::input_file::InputFile;
use super::sheet::{Row, read_entries, write_entries};
use crate::error::Result;
use crate::screen::ScreenError;
use crate::source::{Base, SourceError};
use std::io::Write;

#[rustfmt::skip]
const COLUMNS: [&str; 23] = [
    "light", "sources", "degree", "order", "base",
    "mean_0.1", "mean_0.2", "mean_0.3", "mean_0.4", "mean_0.5", "mean_0.6",
    "p95_0.1", "p95_0.2", "p95_0.3", "p95_0.4", "p95_0.5", "p95_0.6",
    "white_0.1", "white_0.2", "white_0.3", "white_0.4", "white_0.5", "white_0.6",
];

/// Reads the errors of a file.
///
/// # Errors
///
/// If the file cannot be read, a row is ragged, a base is unknown, or a number not finite or below
/// 0.
pub fn read_source_errors(file: impl Into<InputFile>) -> Result<Vec<SourceError>> {
    read_entries(file, COLUMNS, entry)
}

fn entry(row: Row<'_>, columns: [usize; 23]) -> Result<SourceError> {
    let [light, sources, degree, order, base, ..] = columns;
    let whole = |column| {
        usize::try_from(row.integer(column)?)
            .map_err(|_| row.fault("a count is out of range", "give whole numbers, 0 or more"))
    };
    let named = Base::ALL.into_iter().find(|one| one.name() == row.text(base));
    let base = named.ok_or_else(|| row.fault("unknown base", "give `metal` or `dielectric`"))?;
    let mut numbers = [0.0; 18];
    for (number, &column) in numbers.iter_mut().zip(&columns[5..]) {
        *number = row.number(column)?;
        if *number < 0.0 {
            return Err(row.fault("an error is below 0", "give errors of 0 or more"));
        }
    }
    let error =
        |k: usize| ScreenError { mean: numbers[k], p95: numbers[k + 6], white: numbers[k + 12] };
    Ok(SourceError {
        light: row.text(light).to_owned(),
        sources: whole(sources)?,
        size: (whole(degree)?, whole(order)?),
        base,
        errors: [0, 1, 2, 3, 4, 5].map(error),
    })
}

/// Writes errors, rounded up: differences of color with two decimals, shares of white with four.
///
/// # Errors
///
/// If the output fails.
pub fn write_source_errors(errors: &[SourceError], out: &mut (impl Write + ?Sized)) -> Result<()> {
    let rows = errors.iter().map(|SourceError { light, sources, size, base, errors }| {
        let counts = [*sources, size.0, size.1].map(|count| count.to_string());
        let rounded = |of: fn(&ScreenError) -> f64, digits: usize| {
            let unit = 10_f64.powi(digits as i32);
            errors.iter().map(move |one| format!("{:.digits$}", (of(one) * unit).ceil() / unit))
        };
        let numbers = rounded(|one| one.mean, 2).chain(rounded(|one| one.p95, 2));
        let numbers = numbers.chain(rounded(|one| one.white, 4));
        let key = std::iter::once(light.clone()).chain(counts);
        key.chain([base.name().to_owned()]).chain(numbers).collect::<Vec<_>>()
    });
    write_entries(COLUMNS, rows, out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_restore_errors_rounded_up() {
        let error = |mean: f64| ScreenError { mean, p95: 10.0 * mean, white: 0.01 * mean };
        let errors = [1.0, 2.003, 3.0, 2.0, 1.0, 0.0].map(error);
        let base = Base::Dielectric;
        let one = SourceError { light: "a".into(), sources: 4, size: (9, 7), base, errors };
        let mut text = Vec::new();
        write_source_errors(std::slice::from_ref(&one), &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let read = read_source_errors(InputFile::of_text(&text, "f")).unwrap();
        assert_eq!((read.len(), read[0].sources, read[0].size), (1, 4, (9, 7)));
        assert_eq!(read[0].base, base);
        for (read, written) in read[0].errors.iter().zip(one.errors) {
            for (read, written, digit) in [
                (read.mean, written.mean, 1e-2),
                (read.p95, written.p95, 1e-2),
                (read.white, written.white, 1e-4),
            ] {
                assert!((-1e-12..1.01 * digit).contains(&(read - written)), "{read} {written}");
            }
        }
        for (from, to) in
            [("2.01", "-1"), ("a,4,9", "a,-4,9"), ("2.01", "inf"), ("dielectric", "wood")]
        {
            let read = read_source_errors(InputFile::of_text(text.replace(from, to), "f"));
            let error = read.unwrap_err().to_string();
            assert!(error.contains("f:2"), "{error}");
        }
    }
}
