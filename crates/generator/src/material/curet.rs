//! The CUReT layout of measured BRDFs (Dana, van Ginneken, Nayar and
//! Koenderink, "Reflectance and texture of real-world surfaces", ACM
//! Transactions on Graphics 18, 1999).
//!
//! A folder contains `abrdf.dat` (one row for each material: its id and one gray value in 1/sr for
//! every direction), `table.txt` (one row for each direction: index from 1, θ_v, φ_v, θ_i, φ_i in
//! radians; equal azimuths are backscatter) and optionally `samples.csv` (`id,name`).

use std::collections::BTreeMap;
use std::path::Path;

use crate::material::measurements::{Measured, Measurement, POLAR_REMEDY, outside, polar_angle};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::Sheet;

/// Bytes of a measurement, and of its value while it is read.
const BYTES_PER_VALUE: u64 = 2 * size_of::<Measurement>() as u64;

/// The files of a folder of materials: values, directions and names.
pub const FILES: [&str; 3] = ["abrdf.dat", "table.txt", "samples.csv"];

/// Reads all materials of a folder, in the order of `abrdf.dat`.
///
/// A name such as `01-felt` consists of the two-digit id and the name in lower case; it is
/// `sample-01` if `samples.csv` has no name.
///
/// # Errors
///
/// If a file cannot be read. In `table.txt`: a row that is not five finite numbers, indices that do
/// not count up from 1, or a polar angle outside \[0, π/2\]. In `abrdf.dat`: a row that is not an
/// id and one finite number for every direction, a repeated id, or no row. In `samples.csv`:
/// columns other than `id,name`.
pub fn read(folder: impl Into<InputFile>) -> Result<Vec<Measured>> {
    let folder = folder.into();
    let [file, directions, names] = FILES.map(|file| folder.other(folder.path().join(file)));
    let path = file.path();
    let directions = read_directions(&directions)?;
    let names = read_names(names)?;
    let text = file.text()?;
    let values = text.split_ascii_whitespace().count() as u64;
    file.admit(text.len() as u64 + values.saturating_mul(BYTES_PER_VALUE))?;
    let mut taken = BTreeMap::new();
    let mut materials = Vec::new();
    for (line, row) in rows(&text) {
        let mut fields = row.split_whitespace();
        let id = identifier(fields.next().unwrap_or_default())
            .map_err(|error| error.at_line(path, line))?;
        let values = fields
            .map(finite)
            .collect::<Result<Vec<f64>>>()
            .map_err(|error| error.at_line(path, line))?;
        if values.len() != directions.len() {
            return Err(Error::new(
                format!(
                    "{} values where table.txt has {} directions",
                    values.len(),
                    directions.len()
                ),
                "give the sample's id and one value for every row of table.txt",
            )
            .at_line(path, line));
        }
        if let Some(first) = taken.insert(id, line) {
            return Err(Error::new(
                format!("sample {id} was given in line {first}"),
                "keep one row for each sample",
            )
            .at_line(path, line));
        }
        let samples = directions
            .iter()
            .zip(values)
            .map(|(direction, value)| Measurement { rgb: [value; 3], ..*direction })
            .collect();
        let name = match names.get(&id) {
            Some(name) => format!("{id:02}-{name}"),
            None => format!("sample-{id:02}"),
        };
        materials.push(Measured { name, samples });
    }
    if materials.is_empty() {
        return Err(empty(path));
    }
    Ok(materials)
}

/// Reads the directions of `table.txt`, without values.
fn read_directions(file: &InputFile) -> Result<Vec<Measurement>> {
    let (path, text) = (file.path(), file.text()?);
    file.admit(text.len() as u64 + BYTES_PER_VALUE * text.lines().count() as u64)?;
    let mut directions = Vec::new();
    for (line, row) in rows(&text) {
        let fields: Vec<&str> = row.split_whitespace().collect();
        directions.push(
            direction(&fields, directions.len() + 1).map_err(|error| error.at_line(path, line))?,
        );
    }
    if directions.is_empty() {
        return Err(empty(path));
    }
    Ok(directions)
}

fn direction(fields: &[&str], expected: usize) -> Result<Measurement> {
    let &[index, theta_v, phi_v, theta_i, phi_i] = fields else {
        return Err(Error::new(
            format!("{} fields", fields.len()),
            "a row of table.txt is index, theta_v, phi_v, theta_i, phi_i",
        ));
    };
    if identifier(index)? != expected {
        return Err(Error::new(
            format!("index {index} where {expected} was expected"),
            "number the rows of table.txt from 1",
        ));
    }
    let polar = |name, field| {
        let angle = finite(field)?;
        polar_angle(angle).ok_or_else(|| Error::new(outside(name, angle), POLAR_REMEDY))
    };
    Ok(Measurement {
        theta_i: polar("theta_i", theta_i)?,
        theta_r: polar("theta_v", theta_v)?,
        delta_phi: finite(phi_i)? - finite(phi_v)?,
        rgb: [0.0; 3],
    })
}

/// Reads the names of `samples.csv` by id; empty if the file does not exist.
fn read_names(file: InputFile) -> Result<BTreeMap<usize, String>> {
    let mut names = BTreeMap::new();
    if !file.path().exists() {
        return Ok(names);
    }
    let sheet = Sheet::read(file, "id,name")?;
    let [id, name] = sheet.columns(["id", "name"]).ok_or_else(|| sheet.wrong_header("id,name"))?;
    for row in sheet.rows() {
        let id = usize::try_from(row.integer(id)?)
            .map_err(|_| row.fault("the id is negative", "number the samples from 1"))?;
        let name = kebab(row.text(name));
        if !name.is_empty() && names.insert(id, name).is_some() {
            return Err(
                row.fault(format!("sample {id} has two names"), "keep one row for each sample")
            );
        }
    }
    Ok(names)
}

/// The lines of a text that are neither empty nor comments, with line numbers from 1.
fn rows(text: &str) -> impl Iterator<Item = (u64, &str)> {
    (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'))
}

fn empty(path: &Path) -> Error {
    Error::new("no rows", "give the file of the CUReT database").in_file(path)
}

fn finite(field: &str) -> Result<f64> {
    match field.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(Error::new(
            format!("`{field}` is not a finite number"),
            "correct the field, or remove the row",
        )),
    }
}

fn identifier(field: &str) -> Result<usize> {
    field.parse().map_err(|_| {
        Error::new(
            format!("`{field}` is not a whole number"),
            "start the row with the number of the sample or direction",
        )
    })
}

/// Converts `Plaster_b (11 zoomed)` to `plaster-b-11-zoomed`.
fn kebab(name: &str) -> String {
    let words: Vec<String> = name
        .split(|letter: char| !letter.is_alphanumeric())
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    words.join("-")
}
