//! A file to read, and a limit on the memory that reading it may take.

use crate::budget::Budget;
use crate::error::{Error, Result};
use std::fs::File;
use std::io::{BufReader, Read};
use std::path::{Path, PathBuf};

/// A path with a [`Budget`]. A plain path converts to an `InputFile` with [`Budget::READING`].
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct InputFile {
    path: PathBuf,
    budget: Budget,
    beside: u64,
}

impl InputFile {
    /// A file to be read within this budget.
    pub fn new(path: impl AsRef<Path>, budget: Budget) -> Self {
        Self { path: path.as_ref().to_owned(), budget, beside: 0 }
    }

    /// The same file for a caller that allocates this many additional bytes per pixel while it
    /// holds the file's data. They count toward the budget, as do those of earlier calls.
    #[must_use]
    pub fn with_bytes_beside(mut self, bytes_per_pixel: u64) -> Self {
        self.beside = self.beside.saturating_add(bytes_per_pixel);
        self
    }

    /// The path of the file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The folder that contains the file.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    /// Another file with the same budget.
    pub fn other(&self, path: impl AsRef<Path>) -> Self {
        Self::new(path, self.budget)
    }

    /// Checks that this many bytes are within the budget.
    ///
    /// # Errors
    ///
    /// See [`Budget::admit`].
    pub fn admit(&self, bytes: u64) -> Result<()> {
        self.budget.admit(bytes).map_err(|error| error.in_file(&self.path))
    }

    /// Checks that `count` pixels of `each` bytes, the caller's additional bytes per pixel, and
    /// `bytes` more are within the budget.
    ///
    /// # Errors
    ///
    /// See [`Budget::admit`].
    pub fn admit_pixels(&self, count: u64, each: u64, bytes: u64) -> Result<()> {
        self.admit(count.saturating_mul(each.saturating_add(self.beside)).saturating_add(bytes))
    }

    /// Opens the file and returns its length.
    ///
    /// # Errors
    ///
    /// If the file cannot be opened.
    pub fn open(&self) -> Result<(BufReader<File>, u64)> {
        let fault = |error: std::io::Error| Error::io(&self.path, &error);
        let file = File::open(&self.path).map_err(fault)?;
        let length = file.metadata().map_err(fault)?.len();
        Ok((BufReader::new(file), length))
    }

    /// Reads the whole file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or is larger than the budget.
    pub fn bytes(&self) -> Result<Vec<u8>> {
        let (file, length) = self.open()?;
        self.admit(length)?;
        let mut bytes = Vec::new();
        // Files that are not on a disk report no length: the read stops when it exceeds the budget.
        file.take(self.budget.bytes().saturating_add(1))
            .read_to_end(&mut bytes)
            .map_err(|error| Error::io(&self.path, &error))?;
        let read = bytes.len() as u64;
        self.budget.covers(read).map_err(|error| error.in_file(&self.path))?;
        Ok(bytes)
    }

    /// Reads the whole file as text.
    ///
    /// # Errors
    ///
    /// As [`bytes`](Self::bytes), and if the file is not UTF-8.
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
