//! The tables of `../tables/ladder.csv`: the first components of a table, and how far its
//! polynomials are trimmed.

use eigenshade_table::Table;
use eigenshade_table::reduce::with_components;
use eigenshade_table::trim::trim;
use std::fs;

/// The folder of the list, and of the files that it names.
const FOLDER: &str = "../tables";

/// A table of the list.
pub struct Rung {
    /// The name of its module.
    pub name: String,
    /// The file that it is made from.
    pub from: String,
    components: usize,
    tolerance: Option<f64>,
}

impl Rung {
    /// The first components of the table in the file, trimmed.
    pub fn of(&self, whole: &Table) -> Table {
        let mut table = with_components(whole, |number, _| number < self.components);
        if let Some(tolerance) = self.tolerance {
            trim(&mut table, tolerance);
        }
        table
    }
}

/// All of the list.
pub fn all() -> Result<Vec<Rung>, String> {
    let path = format!("{FOLDER}/ladder.csv");
    println!("cargo::rerun-if-changed={path}");
    let text = fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    let lines = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    let rungs = lines.map(|line| rung(line).ok_or(format!("{path}: `{line}` is no table")));
    rungs.collect()
}

fn rung(line: &str) -> Option<Rung> {
    let fields: Vec<&str> = line.split(',').collect();
    let [name, file, components, tolerance] = fields[..] else { return None };
    let tolerance = match tolerance {
        "" => None,
        text => Some(text.parse().ok()?),
    };
    let (name, from) = (name.to_owned(), format!("{FOLDER}/{file}"));
    Some(Rung { name, from, components: components.parse().ok()?, tolerance })
}
