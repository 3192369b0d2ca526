//! Measured BRDFs, from plain CSV and from folders in the layout of CUReT.
//!
//! The CSV has the columns `theta_i,phi_i,theta_r,phi_r,r,g,b`, or `value` instead of r, g, b for
//! gray; in radians and 1/sr. Lines that start with `#` are comments; other columns are ignored.
//!
//! A CUReT folder (Dana, van Ginneken, Nayar and Koenderink, "Reflectance and texture of real-world
//! surfaces", ACM Transactions on Graphics 18, 1999) contains `abrdf.dat` (one row for each
//! material: its id and one gray value in 1/sr for every direction), `table.txt` (one row for each
//! direction: index from 1, θ_v, φ_v, θ_i, φ_i in radians; equal azimuths are backscatter) and
//! optionally `samples.csv` (`id,name`).

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_2;
use std::path::Path;

/// How far beyond the rim a polar angle may lie, since files round π/2.
const RIM_SLACK: f64 = 1e-9;

pub(super) const COLUMNS: &str = "theta_i,phi_i,theta_r,phi_r,r,g,b";

/// One measured value of a BRDF.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measurement {
    /// Polar angle of the light, in \[0, π/2\].
    pub theta_i: f64,
    /// Polar angle of the view, in \[0, π/2\].
    pub theta_r: f64,
    /// φ_i - φ_r; zero is backscatter.
    pub delta_phi: f64,
    /// f in 1/sr. Noise can make it negative.
    pub rgb: [f64; 3],
}

/// The measurements of one material.
#[derive(Clone, Debug, PartialEq)]
pub struct Measured {
    /// Name of the material: the stem of the file name.
    pub name: String,
    /// At least one measurement, in file order.
    pub samples: Vec<Measurement>,
}

/// Reads the measurements of one material.
///
/// # Errors
///
/// If the file cannot be read, a column is missing, a row has the wrong length, a field is not a
/// finite number, a polar angle is outside \[0, π/2\] by more than 1e-9, or there is no row.
pub fn read(file: impl Into<InputFile>) -> Result<Measured> {
    let file = file.into();
    of_sheet(&Sheet::read(file.clone(), COLUMNS)?, file.path())
}

/// The same, from the rows of the file `path`.
pub(super) fn of_sheet(sheet: &Sheet, path: &Path) -> Result<Measured> {
    let wrong_header = || sheet.wrong_header("theta_i,phi_i,theta_r,phi_r and r,g,b or value");
    let angles =
        sheet.columns(["theta_i", "phi_i", "theta_r", "phi_r"]).ok_or_else(wrong_header)?;
    let values = sheet.colors()?.ok_or_else(wrong_header)?;
    let samples =
        sheet.rows().map(|row| sample(row, angles, values)).collect::<Result<Vec<_>>>()?;
    if samples.is_empty() {
        return Err(Error::new(
            "it contains no measurement",
            format!("add rows below the header `{COLUMNS}`"),
        )
        .in_file(path));
    }
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok(Measured { name: name.into_owned(), samples })
}

fn sample(row: Row<'_>, angles: [usize; 4], values: [usize; 3]) -> Result<Measurement> {
    let polar = |name, column| {
        let angle = row.number(column)?;
        polar_angle(angle).ok_or_else(|| row.fault(outside(name, angle), POLAR_REMEDY))
    };
    let [theta_i, phi_i, theta_r, phi_r] = angles;
    let [r, g, b] = values;
    Ok(Measurement {
        theta_i: polar("theta_i", theta_i)?,
        theta_r: polar("theta_r", theta_r)?,
        delta_phi: row.number(phi_i)? - row.number(phi_r)?,
        rgb: [row.number(r)?, row.number(g)?, row.number(b)?],
    })
}

/// The remedy for an invalid polar angle.
pub(super) const POLAR_REMEDY: &str =
    "give radians from the normal, and leave out directions below the surface";

/// The message for an invalid polar angle.
pub(super) fn outside(name: &str, angle: f64) -> String {
    format!("{name} = {angle} is outside [0, pi/2]")
}

/// Clamps an angle to \[0, π/2\]; `None` if it is outside by more than rounding.
pub(super) fn polar_angle(angle: f64) -> Option<f64> {
    (-RIM_SLACK..=FRAC_PI_2 + RIM_SLACK).contains(&angle).then(|| angle.clamp(0.0, FRAC_PI_2))
}

/// The most values of a CUReT folder, and the most lines of its directions.
const MOST_VALUES: u64 = 1 << 22;

/// The files of a CUReT folder: values, directions and names.
pub const CURET_FILES: [&str; 3] = ["abrdf.dat", "table.txt", "samples.csv"];

/// Reads all materials of a CUReT folder, in the order of `abrdf.dat`.
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
pub fn read_curet(folder: impl Into<InputFile>) -> Result<Vec<Measured>> {
    let folder = folder.into();
    let [file, directions, names] = CURET_FILES.map(|file| folder.other(folder.path().join(file)));
    let path = file.path();
    let directions = read_directions(&directions)?;
    let names = read_names(names)?;
    let text = file.text()?;
    let values = text.split_ascii_whitespace().count() as u64;
    file.at_most(values, MOST_VALUES, "values")?;
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
    file.at_most(text.lines().count() as u64, MOST_VALUES, "lines")?;
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
