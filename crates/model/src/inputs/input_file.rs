//! A file to read.

use crate::error::{Error, Result, STANDARD_INPUT};
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};

/// Whether standard input has been read, which is possible once.
static IS_TAKEN: AtomicBool = AtomicBool::new(false);

/// The byte order mark that editors put before a text in UTF-8.
pub const MARK: &[u8] = b"\xef\xbb\xbf";

/// Receives a warning about the file at a path: one line, without the path.
pub type Warn = fn(&Path, &str);

/// The most bytes of a file that is read as a whole.
const MOST_BYTES: u64 = 512 << 20;

/// A path; `-` is standard input, which is read once and as a whole. A plain path converts to an
/// `InputFile` whose warnings are dropped.
#[derive(Clone, Debug)]
pub struct InputFile {
    path: PathBuf,
    text: Option<String>,
    warn: Option<Warn>,
}

/// Whether there is a file at this path, or a device or a pipe, but not a folder.
#[must_use]
pub fn is_file(path: &Path) -> bool {
    path.exists() && !path.is_dir()
}

impl InputFile {
    /// The file at a path.
    pub fn new(path: impl AsRef<Path>) -> Self {
        Self { path: path.as_ref().to_owned(), text: None, warn: None }
    }

    /// The same file for a caller that wants its warnings: what a reader ignores in it, chooses
    /// from it, or converts.
    #[must_use]
    pub fn with_warnings(mut self, warn: Warn) -> Self {
        self.warn = Some(warn);
        self
    }

    /// Passes a warning to the caller that wants it.
    pub fn warn(&self, what: impl AsRef<str>) {
        if let Some(warn) = self.warn {
            warn(&self.path, what.as_ref());
        }
    }

    /// A file that has already been read. Error messages name it `path`.
    pub fn of_text(text: impl Into<String>, path: impl AsRef<Path>) -> Self {
        Self { text: Some(text.into()), ..Self::new(path) }
    }

    /// The file with its text, which is not read again: standard input can be read once.
    ///
    /// # Errors
    ///
    /// As [`text`](Self::text).
    pub fn with_text(self) -> Result<Self> {
        Ok(Self { text: Some(self.text()?), ..self })
    }

    /// The path of the file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Whether this is standard input.
    #[must_use]
    pub fn is_standard_input(&self) -> bool {
        self.path.as_os_str() == STANDARD_INPUT
    }

    /// The extension of the file's name in small letters. Standard input has the extension of a
    /// CSV, which it is wherever the extension decides.
    #[must_use]
    pub fn extension(&self) -> String {
        if self.is_standard_input() {
            return "csv".to_owned();
        }
        self.path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
    }

    /// Whether the file's name has the extension of a mesh.
    #[must_use]
    pub fn is_mesh(&self) -> bool {
        ["obj", "stl", "ply"].contains(&self.extension().as_str())
    }

    /// The folder that contains the file.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.path.parent().unwrap_or(Path::new("."))
    }

    /// Another file with the same receiver of warnings.
    pub fn other(&self, path: impl AsRef<Path>) -> Self {
        Self { warn: self.warn, ..Self::new(path) }
    }

    /// Checks a number that the file contains or claims against the most that its reader takes.
    ///
    /// # Errors
    ///
    /// If it is larger.
    pub fn at_most(&self, count: u64, most: u64, things: &str) -> Result<()> {
        if count <= most {
            return Ok(());
        }
        let what = format!("it has {count} {things}, too many to read");
        Err(Error::new(what, format!("give at most {most} {things}")).in_file(&self.path))
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

    /// Opens the file behind its byte order mark, if it begins with one, and returns its length.
    ///
    /// # Errors
    ///
    /// If the file cannot be opened or read, or is text in UTF-16.
    pub fn open_text(&self) -> Result<(BufReader<File>, u64)> {
        let (mut reader, length) = self.open()?;
        let beginning = reader.fill_buf().map_err(|error| Error::io(&self.path, &error))?;
        let mark = self.mark(beginning)?;
        reader.consume(mark);
        Ok((reader, length))
    }

    /// The length of the byte order mark at the beginning of a text.
    fn mark(&self, beginning: &[u8]) -> Result<usize> {
        if beginning.starts_with(b"\xff\xfe") || beginning.starts_with(b"\xfe\xff") {
            return Err(
                Error::new("it is UTF-16 text", "save it as a UTF-8 text file").in_file(&self.path)
            );
        }
        Ok(if beginning.starts_with(MARK) { MARK.len() } else { 0 })
    }

    /// Reads the whole file.
    ///
    /// # Errors
    ///
    /// If the file cannot be read or has more than 512 MiB.
    pub fn bytes(&self) -> Result<Vec<u8>> {
        if let Some(text) = &self.text {
            return Ok(text.clone().into_bytes());
        }
        let source: Box<dyn Read> = if self.is_standard_input() {
            if IS_TAKEN.swap(true, Ordering::Relaxed) {
                let remedy = "give one input as `-`, and files for the others";
                return Err(Error::new("it is read twice", remedy).in_file(&self.path));
            }
            Box::new(std::io::stdin().lock())
        } else {
            let (file, length) = self.open()?;
            self.at_most(length, MOST_BYTES, "bytes")?;
            Box::new(file)
        };
        let mut bytes = Vec::new();
        // What is not on a disk reports no length.
        source
            .take(MOST_BYTES + 1)
            .read_to_end(&mut bytes)
            .map_err(|error| Error::io(&self.path, &error))?;
        self.at_most(bytes.len() as u64, MOST_BYTES, "bytes")?;
        Ok(bytes)
    }

    /// Reads the bytes of a text behind its byte order mark, if it begins with one.
    ///
    /// # Errors
    ///
    /// As [`bytes`](Self::bytes), and if it is UTF-16.
    pub fn bytes_of_text(&self) -> Result<Vec<u8>> {
        let mut bytes = self.bytes()?;
        bytes.drain(..self.mark(&bytes)?);
        Ok(bytes)
    }

    /// Reads the whole file as text, without its byte order mark.
    ///
    /// # Errors
    ///
    /// As [`bytes`](Self::bytes), and if the file is not UTF-8.
    pub fn text(&self) -> Result<String> {
        String::from_utf8(self.bytes_of_text()?).map_err(|_| {
            Error::new("it is not UTF-8 text", "save it as a UTF-8 text file").in_file(&self.path)
        })
    }
}

impl<P: AsRef<Path>> From<P> for InputFile {
    fn from(path: P) -> Self {
        Self::new(path)
    }
}
