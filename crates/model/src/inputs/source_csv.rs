//! Sources of lights as CSV: one row per source, `light,x,y,z,r,g,b,spread`.
//!
//! The rows of a light are in the order of their worth: its first n are its best n. Other columns
//! and lines that begin with `#` are ignored.

use super::coefficient_text::exact;
use super::input_file::InputFile;
use super::sheet::{Row, read_entries, write_entries};
use crate::error::Result;
use crate::source::{NamedSources, Source};
use eigenshade_table::highlights::MAX_SOURCES;
use std::io::Write;

const COLUMNS: [&str; 8] = ["light", "x", "y", "z", "r", "g", "b", "spread"];

/// Reads the sources of all lights of a file, in the order in which the names first appear.
///
/// # Errors
///
/// If the file cannot be read, a row is ragged or a number not finite, or a light has more than
/// [`MAX_SOURCES`].
pub fn read_sources(file: impl Into<InputFile>) -> Result<Vec<NamedSources>> {
    let mut lights: Vec<NamedSources> = Vec::new();
    read_entries(file, COLUMNS, |row, columns| {
        let (name, source) = entry(row, columns)?;
        let place = lights.iter().position(|light| light.name == name).unwrap_or_else(|| {
            lights.push(NamedSources { name: name.to_owned(), sources: Vec::new() });
            lights.len() - 1
        });
        let sources = &mut lights[place].sources;
        if sources.len() == MAX_SOURCES {
            let what = format!("the light `{name}` has more than {MAX_SOURCES} sources");
            return Err(row.fault(what, "remove the row"));
        }
        sources.push(source);
        Ok(())
    })?;
    Ok(lights)
}

fn entry<'a>(row: Row<'a>, columns: [usize; 8]) -> Result<(&'a str, Source)> {
    let [name, numbers @ ..] = columns;
    let [x, y, z, r, g, b, spread] = row.numbers(numbers)?;
    Ok((row.text(name), Source { direction: [x, y, z], energy: [r, g, b], spread }))
}

/// Writes sources so that reading the file restores every number to the last bit.
///
/// # Errors
///
/// If the output fails.
pub fn write_sources(lights: &[NamedSources], out: &mut (impl Write + ?Sized)) -> Result<()> {
    let rows = lights.iter().flat_map(|NamedSources { name, sources }| {
        sources.iter().map(move |source| {
            let numbers = [&source.direction[..], &source.energy, &[source.spread]].concat();
            [name.clone()].into_iter().chain(numbers.into_iter().map(exact))
        })
    });
    write_entries(COLUMNS, rows, out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_restore_sources() {
        let source = |x: f64| Source {
            direction: [x, 0.6, 0.8],
            energy: [1.5, 0.1, 1e6],
            spread: 0.1 / 3.0,
        };
        let lights = [
            NamedSources { name: "a".into(), sources: vec![source(0.0)] },
            NamedSources { name: "b".into(), sources: [0.1, 0.2, 0.3].map(source).to_vec() },
        ];
        let mut text = Vec::new();
        write_sources(&lights, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(read_sources(InputFile::of_text(&text, "f")).unwrap(), lights);
        assert_eq!(lights[1].first(2), &lights[1].sources[..2]);
        assert_eq!(lights[1].first(32).len(), 3);
        assert!(lights[1].first(0).is_empty());
    }

    #[test]
    fn faults_name_their_line() {
        let header = COLUMNS.join(",");
        let many = "a,0,0,1,1,1,1,0\n".repeat(MAX_SOURCES + 1);
        for (rows, expected) in [(&*many, "more than 32 sources"), ("a,0,0,nan,1,1,1,0", "nan")] {
            let read = read_sources(InputFile::of_text(format!("{header}\n{rows}"), "f"));
            let error = read.unwrap_err().to_string();
            assert!(error.contains(expected) && error.contains("f:"), "{error}");
        }
    }
}
