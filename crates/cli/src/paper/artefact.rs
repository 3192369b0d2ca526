//! What a figure gives: files, not yet written.

use crate::canvas::Canvas;
use crate::number::exact;
use crate::{destination, picture};
use eigenshade_generator::error::{Error, Result};
use std::path::Path;

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

    /// CSV of these rows.
    #[must_use]
    pub fn csv(name: impl Into<String>, header: &str, rows: &[Vec<String>]) -> Self {
        let mut text = format!("{header}\n");
        for row in rows {
            debug_assert_eq!(row.len(), header.split(',').count());
            text.push_str(&row.join(","));
            text.push('\n');
        }
        Self::text(name, text)
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
                picture::write(&path, canvas.width, canvas.height, &canvas.bytes)
            }
        }
    }
}

/// A number of [`DIGITS`] significant digits.
#[must_use]
pub fn digits(value: f64) -> String {
    exact(format!("{value:.*e}", DIGITS - 1).parse().unwrap_or(value))
}
