//! The files of a figure, before they are written.

use eigenshade_cli::output::destination;
use eigenshade_cli::output::number::exact;
use eigenshade_cli::output::rows::Rows;
use eigenshade_cli::picture::canvas::Canvas;
use eigenshade_cli::picture::png_file;
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// The command that makes these files; the first line of each text names it.
pub const COMMAND: &str = "experiments paper";
/// Significant digits of the figures' numbers.
const DIGITS: usize = 6;

/// One output file.
#[derive(Clone, Debug, PartialEq)]
pub struct Artefact {
    /// Its path relative to the requested folder, with `/` as the separator.
    pub name: String,
    /// The content of the file.
    pub content: Content,
}

/// The content of a file.
#[derive(Clone, Debug, PartialEq)]
pub enum Content {
    /// CSV, Markdown or SVG.
    Text(String),
    /// PNG.
    Picture(Canvas),
}

impl Artefact {
    /// A text file.
    #[must_use]
    pub fn text(name: impl Into<String>, text: String) -> Self {
        Self { name: name.into(), content: Content::Text(text) }
    }

    /// A picture file.
    #[must_use]
    pub fn picture(name: impl Into<String>, canvas: Canvas) -> Self {
        Self { name: name.into(), content: Content::Picture(canvas) }
    }

    /// CSV of these rows; the columns of the header are separated by commas.
    ///
    /// # Errors
    ///
    /// Never in practice: the rows are as long as the header.
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

    /// The same file in a folder.
    #[must_use]
    pub fn below(self, folder: &str) -> Self {
        Self { name: format!("{folder}/{}", self.name), ..self }
    }

    /// Writes the file below `folder`, either completely or not at all.
    ///
    /// # Errors
    ///
    /// If the file, its folder or the disk fails.
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
