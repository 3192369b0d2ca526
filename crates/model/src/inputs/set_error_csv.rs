//! The errors that sets of sources leave as CSV: one row per light, set and size,
//! `light,set,degree,order,rms_0.1,..,rms_0.6,worst_0.1,..,worst_0.6`.
//!
//! `set` is the most sources of the set, 0 without sources; the numbers in the names are the
//! roughness of metals. Other columns and lines that begin with `#` are ignored.

use super::input_file::InputFile;
use super::sheet::{Row, read_entries, write_entries};
use crate::error::Result;
use crate::source::{SetError, SetErrors};
use std::io::Write;

#[rustfmt::skip]
const COLUMNS: [&str; 16] = [
    "light", "set", "degree", "order",
    "rms_0.1", "rms_0.2", "rms_0.3", "rms_0.4", "rms_0.5", "rms_0.6",
    "worst_0.1", "worst_0.2", "worst_0.3", "worst_0.4", "worst_0.5", "worst_0.6",
];

/// Reads the errors of a file.
///
/// # Errors
///
/// If the file cannot be read, a row is ragged, or a number not finite or below 0.
pub fn read_set_errors(file: impl Into<InputFile>) -> Result<Vec<SetError>> {
    read_entries(file, COLUMNS, entry)
}

fn entry(row: Row<'_>, columns: [usize; 16]) -> Result<SetError> {
    let [light, set, degree, order, ..] = columns;
    let whole = |column| {
        usize::try_from(row.integer(column)?)
            .map_err(|_| row.fault("a count is out of range", "give whole numbers, 0 or more"))
    };
    let mut numbers = [0.0; 12];
    for (number, &column) in numbers.iter_mut().zip(&columns[4..]) {
        *number = row.number(column)?;
        if *number < 0.0 {
            return Err(row.fault("an error is below 0", "give errors of 0 or more"));
        }
    }
    Ok(SetError {
        light: row.text(light).to_owned(),
        most: whole(set)?,
        size: (whole(degree)?, whole(order)?),
        errors: [0, 1, 2, 3, 4, 5]
            .map(|k: usize| SetErrors { rms: numbers[k], worst: numbers[k + 6] }),
    })
}

/// Writes errors with four decimals, rounded up.
///
/// # Errors
///
/// If the output fails.
pub fn write_set_errors(errors: &[SetError], out: &mut (impl Write + ?Sized)) -> Result<()> {
    let rows = errors.iter().map(|SetError { light, most, size, errors }| {
        let counts = [*most, size.0, size.1].map(|count| count.to_string());
        let rms = errors.iter().map(|error| error.rms);
        let numbers = rms.chain(errors.iter().map(|error| error.worst));
        let numbers = numbers.map(|number| format!("{:.4}", (number * 1e4).ceil() / 1e4));
        std::iter::once(light.clone()).chain(counts).chain(numbers)
    });
    write_entries(COLUMNS, rows, out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_restore_errors_rounded_up() {
        let error = |rms: f64| SetErrors { rms, worst: 10.0 * rms };
        let errors = [0.01, 0.020_01, 0.03, 0.02, 0.01, 0.0].map(error);
        let one = SetError { light: "a".into(), most: 4, size: (9, 7), errors };
        let mut text = Vec::new();
        write_set_errors(std::slice::from_ref(&one), &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        let read = read_set_errors(InputFile::of_text(&text, "f")).unwrap();
        assert_eq!((read.len(), read[0].most, read[0].size), (1, 4, (9, 7)));
        for (read, written) in read[0].errors.iter().zip(one.errors) {
            for (read, written) in [(read.rms, written.rms), (read.worst, written.worst)] {
                assert!((0.0..1.01e-4).contains(&(read - written)), "{read} {written}");
            }
        }
        for (from, to) in [("0.0201", "-1"), ("a,4,9", "a,-4,9"), ("0.0201", "inf")] {
            let read = read_set_errors(InputFile::of_text(text.replace(from, to), "f"));
            let error = read.unwrap_err().to_string();
            assert!(error.contains("f:2"), "{error}");
        }
    }
}
