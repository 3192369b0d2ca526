//! The files that a command measures or draws: CSV, charts and pictures. CSV files are compared with
//! those that are there: texts must be equal, numbers nearly so, as hosts differ in the last digits.

use crate::sheet;
use eigenshade_cli::output;
use eigenshade_cli::picture::Canvas;
use eigenshade_model::error::{self, Error};
use eigenshade_shading::picture;
use std::fs;
use std::path::Path;

#[derive(Clone, Debug, PartialEq)]
pub struct OutputFile {
    /// Its path relative to the requested folder, with `/` as the separator.
    pub name: String,
    pub content: Content,
}

#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// CSV or SVG.
    Text(String),
    /// PNG.
    Picture(Canvas),
}

impl OutputFile {
    pub fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Content::Text(text) }
    }

    pub fn picture(name: impl Into<String>, canvas: Canvas) -> Self {
        Self { name: name.into(), content: Content::Picture(canvas) }
    }

    /// Writes the file below `folder`, either completely or not at all.
    pub fn write(&self, folder: &Path) -> error::Result<()> {
        let path = folder.join(&self.name);
        if let Some(parent) = path.parent() {
            fs::create_dir_all(parent).map_err(|error| Error::io(parent, &error))?;
        }
        match &self.content {
            Content::Text(text) => output::write_all(Some(&path), text),
            Content::Picture(canvas) => {
                picture::write_png(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

/// A CSV that `report COMMAND` writes; `columns` are separated by commas.
pub fn csv<R: IntoIterator<Item: AsRef<[u8]>>>(
    command: &str,
    name: impl Into<String>,
    columns: &str,
    rows: impl IntoIterator<Item = R>,
) -> error::Result<OutputFile> {
    Ok(OutputFile::text(name, sheet::csv(&format!("report {command}"), columns, rows)?))
}

pub fn chart(name: impl Into<String>, svg: &str) -> OutputFile {
    OutputFile::text(name, format!("<!-- report pages -->\n{svg}"))
}

/// Writes the files below `folder`.
pub fn write(files: &[OutputFile], folder: &Path) -> error::Result<()> {
    files.iter().try_for_each(|file| file.write(folder))
}

/// Compares every CSV with the one in `folder`, and returns how many cells were compared. `remedy`
/// is for a file that differs.
pub fn compare(files: &[OutputFile], folder: &Path, remedy: &str) -> error::Result<usize> {
    let mut count = 0;
    for OutputFile { name, content } in files {
        let Content::Text(text) = content else { continue };
        let path = folder.join(name);
        let recorded = fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))?;
        count += near(&recorded, text).map_err(|fault| Error::new(fault, remedy).in_file(&path))?;
    }
    Ok(count)
}

/// The allowed relative difference of two numbers: two units of the six digits.
const ALLOWED: f64 = 2e-5;
/// The difference that is always allowed, relative to the largest number of the file: rounding.
const FLOOR: f64 = 1e-13;

/// Compares two CSV texts, and returns the number of cells or the first difference.
fn near(recorded: &str, now: &str) -> Result<usize, String> {
    let values = now.split([',', '\n']).filter_map(number);
    let floor = FLOOR * values.fold(0.0, |most, (value, _)| value.abs().max(most));
    let same = |_: &csv::StringRecord, _, old: &str, new: &str| {
        old == new || numbers(old, new, floor).unwrap_or(false)
    };
    sheet::compare_cells(recorded, now, same)
}

/// Whether two numbers are near, `None` if they are not both numbers. `floor` is always allowed.
fn numbers(old: &str, new: &str, floor: f64) -> Option<bool> {
    let ((a, _), (b, unit)) = (number(old)?, number(new)?);
    let allowed = (ALLOWED * a.abs().max(b.abs())).max(floor).max(unit);
    Some((a - b).abs() <= allowed)
}

/// A number, and one unit of its last digit if it has a decimal point, because a number with fewer
/// digits may be rounded either way. Whole numbers are counts and must be equal.
fn number(word: &str) -> Option<(f64, f64)> {
    let value: f64 = word.parse().ok().filter(|value: &f64| value.is_finite())?;
    let (digits, power) = word.split_once('e').unwrap_or((word, "0"));
    let places = digits.split_once('.').map(|(_, places)| places.len());
    let power: i32 = power.parse().ok()?;
    let unit = places.map_or(0.0, |places| 10f64.powi(power - places as i32));
    Some((value, 1.000_001 * unit))
}

#[cfg(test)]
mod tests {
    use super::near;

    #[test]
    fn last_digits_may_differ_and_nothing_else() {
        for (a, b, is_same) in [
            ("a,1.00001e-3,7\n", "a,1.00002e-3,7\n", true),
            // Fewer digits may be rounded either way.
            ("0.7", "0.8", true),
            // Rounding, compared with the largest number of the file.
            ("1\n3e-20", "1\n5e-20", true),
            ("0.7", "0.9", false),
            ("a,1.00001e-3,7", "a,1.0005e-3,7", false),
            ("a,7", "a,8", false),
            ("a,7", "b,7", false),
            ("a,7", "a", false),
            ("a,7,", "a,,7", false),
            ("a\nb", "a", false),
            ("a,NaN", "a,1", false),
        ] {
            assert_eq!(near(a, b).is_ok(), is_same, "{a} {b}");
        }
        assert_eq!(near("# c\nx,1\n3,2", "# d\nx,1\n3,2"), Ok(4));
        assert!(near("1\n2", "1\n3").unwrap_err().starts_with("line 2: "));
    }
}
