//! Errors for bad inputs and outputs: what is wrong, where, and how to fix it.

use eigenshade_table::FileError;
use std::fmt;
use std::path::{Path, PathBuf};

/// The path that stands for standard input.
pub const STANDARD_INPUT: &str = "-";

/// An error in one input or output, displayed in one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    place: Option<(PathBuf, Option<u64>)>,
    what: String,
    remedy: String,
}

/// The result type of all fallible code on the host.
pub type Result<T> = std::result::Result<T, Error>;

impl Error {
    /// An error that belongs to no file.
    pub fn new(what: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self { place: None, what: what.into(), remedy: remedy.into() }
    }

    /// The same error with another remedy.
    #[must_use]
    pub fn with_remedy(mut self, remedy: impl Into<String>) -> Self {
        self.remedy = remedy.into();
        self
    }

    /// The same error, prefixed with the item that it concerns.
    #[must_use]
    pub fn of(mut self, subject: impl fmt::Display) -> Self {
        self.what = format!("{subject}: {}", self.what);
        self
    }

    /// The same error, located in this file.
    #[must_use]
    pub fn in_file(mut self, path: impl AsRef<Path>) -> Self {
        let line = self.place.and_then(|(_, line)| line);
        self.place = Some((path.as_ref().to_owned(), line));
        self
    }

    /// The same error, located at this line (counted from 1) of this file.
    #[must_use]
    pub fn at_line(mut self, path: impl AsRef<Path>, line: u64) -> Self {
        self.place = Some((path.as_ref().to_owned(), Some(line)));
        self
    }

    /// The error for bytes that are not a valid table.
    #[must_use]
    pub fn table(error: &FileError) -> Self {
        Self::new(error.what(), error.remedy())
    }

    /// The error of a line: problem, `; ` and remedy, or the remedy `other` if the line has none.
    #[must_use]
    pub fn of_line(line: impl fmt::Display, other: &str) -> Self {
        let line = line.to_string();
        let (what, remedy) = line.rsplit_once("; ").unwrap_or((&line, other));
        Self::new(what, remedy)
    }

    /// The error for an operating system failure on reading or writing a file.
    #[must_use]
    pub fn io(path: impl AsRef<Path>, error: &std::io::Error) -> Self {
        use std::io::ErrorKind;
        let remedy = match error.kind() {
            ErrorKind::NotFound => "check the path, and that its folder exists",
            ErrorKind::PermissionDenied => "check the permissions of the file and its folder",
            ErrorKind::NotADirectory | ErrorKind::IsADirectory | ErrorKind::AlreadyExists => {
                "a file and a folder are mixed up: check the path"
            }
            ErrorKind::StorageFull => "free some space on the disk, or write elsewhere",
            ErrorKind::InvalidData => "save it as a UTF-8 text file",
            _ => "check the file and the disk",
        };
        Self::new(error.to_string(), remedy).in_file(path)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((path, line)) = &self.place {
            if path.as_os_str() == STANDARD_INPUT {
                f.write_str("standard input")?;
            } else {
                write!(f, "{}", path.display())?;
            }
            line.map_or(Ok(()), |line| write!(f, ":{line}"))?;
            f.write_str(": ")?;
        }
        write!(f, "{}; {}", self.what, self.remedy)
    }
}

impl std::error::Error for Error {}
