//! A file to read, and the memory that reading it may take.

use crate::budget::Budget;
use crate::error::{Error, Result};
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

/// A path with a [`Budget`]. Readers take a path alone too: for [`Budget::READING`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputFile {
    path: PathBuf,
    budget: Budget,
    beside: u64,
}

impl InputFile {
    /// This file, read within this budget.
    pub fn new(path: impl AsRef<Path>, budget: Budget) -> Self {
        Self { path: path.as_ref().to_owned(), budget, beside: 0 }
    }

    /// The same file for a caller that takes so many bytes more of each pixel while it has the
    /// file's: they count too.
    #[must_use]
    pub fn with_bytes_beside(mut self, bytes_per_pixel: u64) -> Self {
        self.beside = bytes_per_pixel;
        self
    }

    /// Where it is.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder that it is in.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    /// The same budget for another file.
    pub fn other(&self, path: impl AsRef<Path>) -> Self {
        Self::new(path, self.budget)
    }

    /// Whether so many bytes are within the budget.
    ///
    /// # Errors
    ///
    /// As [`Budget::admit`].
    pub fn admit(&self, bytes: u64) -> Result<()> {
        self.budget.admit(bytes).map_err(|error| error.in_file(&self.path))
    }

    /// Whether `count` pixels of so many bytes are, what the caller takes of each included, and
    /// `bytes` more.
    ///
    /// # Errors
    ///
    /// As [`Budget::admit`].
    pub fn admit_pixels(&self, count: u64, each: u64, bytes: u64) -> Result<()> {
        self.admit(count.saturating_mul(each + self.beside).saturating_add(bytes))
    }

    /// The file, and its length.
    ///
    /// # Errors
    ///
    /// A file that cannot be opened.
    pub fn open(&self) -> Result<(BufReader<File>, u64)> {
        let fault = |error: std::io::Error| Error::io(&self.path, &error);
        let file = File::open(&self.path).map_err(fault)?;
        let length = file.metadata().map_err(fault)?.len();
        Ok((BufReader::new(file), length))
    }

    /// All of its bytes.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, or is longer than the budget.
    pub fn bytes(&self) -> Result<Vec<u8>> {
        let (file, length) = self.open()?;
        self.admit(length)?;
        let mut bytes = Vec::new();
        // What is no file of the disk has no length: it is read until it is too long.
        file.take(self.budget.bytes().saturating_add(1))
            .read_to_end(&mut bytes)
            .map_err(|error| Error::io(&self.path, &error))?;
        let read = bytes.len() as u64;
        self.budget.covers(read).map_err(|error| error.in_file(&self.path))?;
        Ok(bytes)
    }

    /// All of it as text.
    ///
    /// # Errors
    ///
    /// As [`bytes`](Self::bytes); what is no UTF-8.
    pub fn text(&self) -> Result<String> {
        String::from_utf8(self.bytes()?).map_err(|_| {
            Error::new("it is not UTF-8 text", "save it as a UTF-8 text file").in_file(&self.path)
        })
    }
}

impl<P: AsRef<Path>> From<P> for InputFile {
    fn from(path: P) -> Self {
        Self::new(path, Budget::READING)
    }
}
