//! Types and parsers of options that commands share.

use clap::Args;
use eigenshade::{Effect, Tolerance};
use eigenshade_model::budget::Budget;
use eigenshade_model::database::Named;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::rotation::Rotation;
use std::path::{Path, PathBuf};

/// The number of names that an error message lists.
const LISTED: usize = 5;

/// What clap's parsers return.
type Parsed<T> = std::result::Result<T, String>;

/// The memory limits of a command.
#[derive(Args, Clone, Copy, Debug)]
pub struct Memory {
    /// Memory limit for reading an input file and for making a table, like 4GiB
    /// [default: 512MiB for a file, 2GiB for a table]
    #[arg(long = "memory", global = true, value_name = "SIZE")]
    budget: Option<Budget>,
}

impl Memory {
    /// The limit for making a table.
    #[cfg(feature = "generate")]
    pub fn of_basis(self) -> Budget {
        self.budget.unwrap_or(Budget::BASIS)
    }

    /// A file that is read within its limit.
    pub fn file(self, path: impl AsRef<Path>) -> InputFile {
        InputFile::new(path, self.budget.unwrap_or(Budget::READING))
    }
}

/// One entry of a file of lights or materials, written as `FILE` or `FILE:NAME`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileEntry {
    /// The file.
    pub path: PathBuf,
    /// The entry's name; `None` if the file must hold exactly one entry.
    pub name: Option<String>,
}

impl FileEntry {
    /// Splits at the last colon, unless the whole text names an existing file.
    pub fn new(text: &str) -> Self {
        let whole = || Self { path: text.into(), name: None };
        if Path::new(text).exists() {
            return whole();
        }
        match text.rsplit_once(':') {
            Some((path, name)) if !path.is_empty() && !name.is_empty() => {
                Self { path: path.into(), name: Some(name.to_owned()) }
            }
            _ => whole(),
        }
    }

    /// The entry among those of the file.
    ///
    /// # Errors
    ///
    /// If the file has no entry of that name, or if no name is given and the file has several
    /// entries. The message lists a few of the available names.
    pub fn find_in(&self, entries: Vec<Named>) -> Result<Named> {
        let names: Vec<String> = entries.iter().map(|entry| entry.name.clone()).collect();
        let found = match &self.name {
            Some(name) => entries.into_iter().find(|entry| entry.name == *name),
            None if entries.len() == 1 => entries.into_iter().next(),
            None => None,
        };
        found.ok_or_else(|| {
            let what = match &self.name {
                Some(name) => format!("it has no entry `{name}`"),
                None => format!("it has {} entries", names.len()),
            };
            let file = self.path.display();
            let remedy = format!("name one as {file}:NAME; there are {}", listed(&names));
            Error::new(what, remedy).in_file(&self.path)
        })
    }
}

fn listed(names: &[String]) -> String {
    let mut text = names.iter().take(LISTED).cloned().collect::<Vec<_>>().join(", ");
    if names.len() > LISTED {
        text.push_str(&format!(", ... ({} in all)", names.len()));
    }
    text
}

/// Parses a whole number within a range.
pub fn count(low: u64, high: u64) -> impl Fn(&str) -> Parsed<usize> + Clone {
    move |text| match text.parse::<u64>() {
        Ok(number) if (low..=high).contains(&number) => Ok(number as usize),
        _ => Err(format!("expected a whole number from {low} to {high}")),
    }
}

/// Parses an effect.
pub fn effect(text: &str) -> Parsed<Effect> {
    let found = Effect::ALL.into_iter().find(|effect| effect.name() == text.trim());
    found.ok_or_else(|| "expected ambient, diffuse, broad or gloss".to_owned())
}

/// Parses a share of the peak, or decibels below it.
pub fn tolerance(text: &str) -> Parsed<Tolerance<f64>> {
    let decibels = text.strip_suffix("dB").map(|number| number.trim().parse::<u8>());
    match (decibels, text.parse::<f64>()) {
        (Some(Ok(decibels @ 1..)), _) => Ok(Tolerance::Decibels(decibels)),
        (None, Ok(share)) if (1e-30..1.0).contains(&share) => Ok(Tolerance::OfPeak(share)),
        _ => Err("expected a share from 1e-30 to less than 1, or 1 to 255 whole decibels, as in \
                  1e-3 or 60dB"
            .to_owned()),
    }
}

/// Parses a width in degrees or orders.
pub fn width(text: &str) -> Parsed<f64> {
    match text.parse() {
        Ok(width) if width > 0.0 && f64::is_finite(width) => Ok(width),
        _ => Err("expected a width above 0, as in 12".to_owned()),
    }
}

/// Parses an exposure.
pub fn positive(text: &str) -> Parsed<f32> {
    match text.parse::<f32>() {
        Ok(number) if number >= f32::MIN_POSITIVE && number.is_finite() => Ok(number),
        _ => Err("expected a number above 0, as in 1.5".to_owned()),
    }
}

/// Parses the three angles A,B,C of Rz(A) Ry(B) Rz(C).
pub fn angles(text: &str) -> Parsed<Rotation> {
    let numbers: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok().filter(|x: &f64| x.is_finite()))
        .collect();
    match numbers.as_deref() {
        // R = Rz(A) Ry(B) Rz(C).
        Some(&[a, b, c]) => Ok(Rotation { alpha: b, beta: a, gamma: c }),
        _ => Err("expected three angles in radians, as in 0.5,1.2,-0.3".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_follow_the_last_colon() {
        let entry = FileEntry::new("no/such:file.csv:felt");
        assert_eq!(entry.path, Path::new("no/such:file.csv"));
        assert_eq!(entry.name.as_deref(), Some("felt"));
        assert_eq!(FileEntry::new("no/such.csv").name, None);
        assert_eq!(FileEntry::new("no/such.csv:").name, None);
    }
}
