//! Sources of lights as CSV: one row per source,
//! `light,set,x,y,z,r,g,b,major_x,major_y,major_z,minor`.
//!
//! `set` is the most sources of the set that the row belongs to. Other columns and lines that begin
//! with `#` are ignored.

use super::coefficient_text::exact;
use super::input_file::InputFile;
use super::sheet::{Row, read_entries, write_entries};
use crate::error::Result;
use crate::source::{Source, SourceSets};
use eigenshade_table::highlights::MAX_SOURCES;
use std::io::Write;

const COLUMNS: [&str; 12] =
    ["light", "set", "x", "y", "z", "r", "g", "b", "major_x", "major_y", "major_z", "minor"];

/// Reads the sets of all lights of a file, in the order in which the names first appear.
///
/// # Errors
///
/// If the file cannot be read, a row is ragged or a number not finite, or a set has more rows than
/// `set` says or than [`MAX_SOURCES`].
pub fn read_sources(file: impl Into<InputFile>) -> Result<Vec<SourceSets>> {
    let mut lights: Vec<SourceSets> = Vec::new();
    read_entries(file, COLUMNS, |row, columns| {
        let (name, set, source) = entry(row, columns)?;
        let place = lights.iter().position(|light| light.name == name).unwrap_or_else(|| {
            lights.push(SourceSets { name: name.to_owned(), sets: Vec::new() });
            lights.len() - 1
        });
        let sets = &mut lights[place].sets;
        let place = sets.binary_search_by_key(&set, |(most, _)| *most).unwrap_or_else(|place| {
            sets.insert(place, (set, Vec::new()));
            place
        });
        let sources = &mut sets[place].1;
        if sources.len() == set {
            let what = format!("the light `{name}` has more than {set} sources in the set {set}");
            return Err(row.fault(what, "remove the row, or give it another set"));
        }
        sources.push(source);
        Ok(())
    })?;
    Ok(lights)
}

fn entry<'a>(row: Row<'a>, columns: [usize; 12]) -> Result<(&'a str, usize, Source)> {
    let [name, set, numbers @ ..] = columns;
    let most =
        usize::try_from(row.integer(set)?).ok().filter(|set| (1..=MAX_SOURCES).contains(set));
    let most = most.ok_or_else(|| {
        let remedy = format!("give the most sources of the set, 1 to {MAX_SOURCES}");
        row.fault("its set is out of range", remedy)
    })?;
    let [x, y, z, r, g, b, u, v, w, minor] = row.numbers(numbers)?;
    let source = Source { direction: [x, y, z], energy: [r, g, b], major: [u, v, w], minor };
    Ok((row.text(name), most, source))
}

/// Writes sources so that reading the file restores every number to the last bit.
///
/// # Errors
///
/// If the output fails.
pub fn write_sources(lights: &[SourceSets], out: &mut (impl Write + ?Sized)) -> Result<()> {
    let rows = lights.iter().flat_map(|SourceSets { name, sets }| {
        let sources = sets.iter().flat_map(|(most, set)| set.iter().map(move |one| (most, one)));
        sources.map(move |(most, source)| {
            let numbers = [&source.direction[..], &source.energy, &source.major, &[source.minor]];
            let numbers = numbers.concat().into_iter().map(exact);
            [name.clone(), most.to_string()].into_iter().chain(numbers)
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
            major: [0.1 / 3.0, 0.0, 0.0],
            minor: 0.01,
        };
        let lights = [
            SourceSets { name: "a".into(), sets: vec![(1, vec![source(0.0)])] },
            SourceSets {
                name: "b".into(),
                sets: vec![(2, vec![source(0.1), source(0.2)]), (8, vec![source(0.3)])],
            },
        ];
        let mut text = Vec::new();
        write_sources(&lights, &mut text).unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(read_sources(InputFile::of_text(&text, "f")).unwrap(), lights);
        assert_eq!(lights[1].of_most(4).len(), 2);
        assert_eq!(lights[1].of_most(32).len(), 1);
        assert!(lights[1].of_most(1).is_empty());
    }

    #[test]
    fn faults_name_their_line() {
        let header = COLUMNS.join(",");
        for (rows, expected) in [
            ("a,1,0,0,1,1,1,1,0,0,0,0\na,1,0,0,1,1,1,1,0,0,0,0", "more than 1 sources"),
            ("a,0,0,0,1,1,1,1,0,0,0,0", "out of range"),
            ("a,33,0,0,1,1,1,1,0,0,0,0", "out of range"),
            ("a,1,0,0,nan,1,1,1,0,0,0,0", "nan"),
        ] {
            let read = read_sources(InputFile::of_text(format!("{header}\n{rows}"), "f"));
            let error = read.unwrap_err().to_string();
            assert!(error.contains(expected) && error.contains("f:"), "{error}");
        }
    }
}
