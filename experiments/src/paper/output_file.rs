//! The files of a figure, before they are written.

use eigenshade_cli::output;
use eigenshade_cli::output::Rows;
use eigenshade_cli::output::exact;
use eigenshade_cli::picture;
use eigenshade_cli::picture::Canvas;
use eigenshade_model::error::{Error, Result};
use std::fmt::Display;
use std::path::Path;

/// The command that makes these files; the first line of each text names it.
const COMMAND: &str = "experiments paper";
/// The folder of the figures, next to the page that shows them.
pub const FOLDER: &str = "paper";
/// Significant digits of the figures' numbers.
const DIGITS: usize = 6;

/// One output file.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputFile {
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

impl OutputFile {
    /// CSV of these rows, below [`FOLDER`]; the columns of the header are separated by commas.
    pub fn csv(name: &str, header: &str, rows: &[Vec<String>]) -> Result<Self> {
        let mut bytes = format!("# {COMMAND}\n").into_bytes();
        let mut sheet = Rows::new(&mut bytes, header.split(','))?;
        for row in rows {
            sheet.row(row)?;
        }
        sheet.finish()?;
        let text = String::from_utf8_lossy(&bytes).into_owned();
        Ok(Self { name: format!("{FOLDER}/{name}"), content: Content::Text(text) })
    }

    /// An SVG chart below [`FOLDER`].
    pub fn chart(name: &str, svg: &str) -> Self {
        let text = format!("<!-- {COMMAND} -->\n{svg}");
        Self { name: format!("{FOLDER}/{name}"), content: Content::Text(text) }
    }

    /// A PNG below [`FOLDER`].
    pub fn picture(name: &str, canvas: Canvas) -> Self {
        Self { name: format!("{FOLDER}/{name}"), content: Content::Picture(canvas) }
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
            Content::Text(text) => output::write_all(Some(&path), text),
            Content::Picture(canvas) => {
                picture::write_png(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

/// A row of a CSV: texts, then numbers with six significant digits.
pub fn row(texts: &[&dyn Display], numbers: impl IntoIterator<Item = f64>) -> Vec<String> {
    let texts = texts.iter().map(ToString::to_string);
    texts.chain(numbers.into_iter().map(digits)).collect()
}

/// A number with six significant digits.
pub fn digits(value: f64) -> String {
    exact(format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value))
}
