//! The gloss of materials as CSV: one row per material,
//! `material,roughness,f0_r,f0_g,f0_b,f90_r,f90_g,f90_b,albedo_r,albedo_g,albedo_b,error`.
//!
//! Other columns and lines that begin with `#` are ignored.

use super::input_file::InputFile;
use super::sheet::{Row, read_entries, write_entries};
use crate::error::Result;
use crate::source::{Gloss, NamedGloss};
use std::io::Write;

#[rustfmt::skip]
const COLUMNS: [&str; 12] = [
    "material", "roughness", "f0_r", "f0_g", "f0_b", "f90_r", "f90_g", "f90_b",
    "albedo_r", "albedo_g", "albedo_b", "error",
];

/// Reads the gloss of all materials of a file.
///
/// # Errors
///
/// If the file cannot be read, a row is ragged, a parameter is not from 0 to 1, or an error is not
/// finite or below 0.
pub fn read_glosses(file: impl Into<InputFile>) -> Result<Vec<NamedGloss>> {
    read_entries(file, COLUMNS, entry)
}

fn entry(row: Row<'_>, columns: [usize; 12]) -> Result<NamedGloss> {
    let mut numbers = [0.0; 11];
    for (k, (number, &column)) in numbers.iter_mut().zip(&columns[1..]).enumerate() {
        *number = row.number(column)?;
        let most = if k < 10 { 1.0 } else { f64::INFINITY };
        if !(0.0..=most).contains(number) {
            let what = format!("`{}` is out of range", COLUMNS[k + 1]);
            return Err(row.fault(what, "give a number from 0 to 1; the error may be larger"));
        }
    }
    let [roughness, f0_r, f0_g, f0_b, f90_r, f90_g, f90_b, r, g, b, error] = numbers;
    let gloss = Gloss {
        roughness,
        reflectance: [f0_r, f0_g, f0_b],
        grazing: [f90_r, f90_g, f90_b],
        albedo: [r, g, b],
    };
    Ok(NamedGloss { name: row.text(columns[0]).to_owned(), gloss, error })
}

/// Writes glosses with four decimals.
///
/// # Errors
///
/// If the output fails.
pub fn write_glosses(glosses: &[NamedGloss], out: &mut (impl Write + ?Sized)) -> Result<()> {
    let rows = glosses.iter().map(|NamedGloss { name, gloss, error }| {
        let Gloss { roughness, reflectance, grazing, albedo } = gloss;
        let numbers = [&[*roughness][..], reflectance, grazing, albedo, &[*error]].concat();
        let numbers = numbers.into_iter().map(|number| format!("{number:.4}"));
        std::iter::once(name.clone()).chain(numbers)
    });
    write_entries(COLUMNS, rows, out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_restore_glosses_and_faults_name_their_line() {
        let gloss = Gloss {
            roughness: 0.125,
            reflectance: [0.9, 0.5, 0.25],
            grazing: [1.0; 3],
            albedo: [0.0, 0.0625, 1.0],
        };
        let one = NamedGloss { name: "gold, leaf".into(), gloss, error: 1.5 };
        let mut text = Vec::new();
        write_glosses(std::slice::from_ref(&one), &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(read_glosses(InputFile::of_text(&text, "f")).unwrap(), [one]);
        for (from, to) in [("0.1250", "1.1"), ("0.1250", "-0.1"), ("1.5000", "nan")] {
            let read = read_glosses(InputFile::of_text(text.replace(from, to), "f"));
            let error = read.unwrap_err().to_string();
            assert!(error.contains("f:2"), "{error}");
        }
    }
}
