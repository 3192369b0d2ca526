//! What a figure gives: files, not yet written.

use eigenshade_cli::output::destination;
use eigenshade_cli::output::number::exact;
use eigenshade_cli::output::rows::Rows;
use eigenshade_cli::picture::canvas::Canvas;
use eigenshade_cli::picture::png_file;
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// What makes these files; each text says so in its first line.
pub const COMMAND: &str = "experiments paper";
/// Significant digits of the figures' numbers.
const DIGITS: usize = 6;

/// One file.
#[derive(Clone, Debug, PartialEq)]
pub struct Artefact {
    /// Its name, relative to the folder that is asked for; with `/`.
    pub name: String,
    /// What is in it.
    pub content: Content,
}

/// What is in a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// CSV, Markdown or SVG.
    Text(String),
    /// PNG.
    Picture(Canvas),
}

impl Artefact {
    /// A text.
    #[must_use]
    pub fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Content::Text(text) }
    }

    /// A picture.
    #[must_use]
    pub fn picture(name: impl Into<String>, canvas: Canvas) -> Self {
        Self { name: name.into(), content: Content::Picture(canvas) }
    }

    /// CSV of these rows; the header's columns are separated by commas.
    ///
    /// # Errors
    ///
    /// None in truth: the rows are as long as the header.
    pub fn csv(name: impl Into<String>, header: &str, rows: &[Vec<String>]) -> Result<Self> {
        let mut bytes = format!("# {COMMAND}\n").into_bytes();
        let mut sheet = Rows::new(&mut bytes, header.split(','))?;
        for row in rows {
            sheet.row(row)?;
        }
        sheet.finish()?;
        Ok(Self::text(name, String::from_utf8_lossy(&bytes).into_owned()))
    }

    /// An SVG chart.
    #[must_use]
    pub fn chart(name: impl Into<String>, svg: &str) -> Self {
        Self::text(name, format!("<!-- {COMMAND} -->\n{svg}"))
    }

    /// The same in a folder.
    #[must_use]
    pub fn below(self, folder: &str) -> Self {
        Self { name: format!("{folder}/{}", self.name), ..self }
    }

    /// Writes it below `folder`, whole or not at all.
    ///
    /// # Errors
    ///
    /// The faults of the file, its folder or the disk.
    pub fn write(&self, folder: &Path) -> Result<()> {
        let path = folder.join(&self.name);
        if let Some(parent) = path.parent() {
            std::fs::create_dir_all(parent).map_err(|error| Error::io(parent, &error))?;
        }
        match &self.content {
            Content::Text(text) => destination::write_text(Some(&path), text),
            Content::Picture(canvas) => {
                png_file::write(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

/// A number of six significant digits.
#[must_use]
pub fn digits(value: f64) -> String {
    exact(format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value))
}
