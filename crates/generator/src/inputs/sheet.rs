//! A CSV file with a header: columns by name, and the line of every fault.

use crate::error::{Error, Result};
use csv::{ErrorKind, ReaderBuilder, StringRecord, Trim};
use std::fs;
use std::path::{Path, PathBuf};

/// The rows of a CSV file.
///
/// Lines that begin with `#` and empty lines are skipped; blanks around a field
/// do not count; the columns may stand in any order among others.
pub struct Sheet {
    path: PathBuf,
    text: Vec<u8>,
    header: StringRecord,
    records: Vec<StringRecord>,
}

impl Sheet {
    /// Reads the file. `columns` is the header that it should have, for the
    /// remedies.
    ///
    /// # Errors
    ///
    /// A file that cannot be read, is empty or no UTF-8, or has a row of another
    /// length than its header.
    pub fn read(path: &Path, columns: &str) -> Result<Self> {
        let text = fs::read(path).map_err(|error| Error::io(path, &error))?;
        Self::parse(text, path, columns)
    }

    /// [`read`](Self::read) of a file's text; `path` is what faults call it.
    ///
    /// # Errors
    ///
    /// As there.
    pub fn parse(text: Vec<u8>, path: &Path, columns: &str) -> Result<Self> {
        let mut reader =
            ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(text.as_slice());
        let fault = |error: csv::Error| csv_fault(path, &text, columns, &error);
        let header = reader.headers().map_err(fault)?.clone();
        if header.is_empty() {
            return Err(Error::new(
                "there is nothing in it",
                format!("begin it with the header `{columns}`"),
            )
            .in_file(path));
        }
        let records = reader.records().collect::<csv::Result<Vec<_>>>().map_err(fault)?;
        Ok(Self { path: path.to_owned(), header, records, text })
    }

    /// The names of the columns.
    pub fn header(&self) -> impl Iterator<Item = &str> {
        self.header.iter()
    }

    /// Where a column stands, if it is there.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header().position(|column| column == name)
    }

    /// Where each of these columns stands, if all of them are there.
    #[must_use]
    pub fn columns<const N: usize>(&self, names: [&str; N]) -> Option<[usize; N]> {
        let places = names.map(|name| self.column(name));
        places.iter().all(Option::is_some).then(|| places.map(Option::unwrap_or_default))
    }

    /// The fault of a header without these columns.
    #[must_use]
    pub fn wrong_header(&self, columns: &str) -> Error {
        let found: Vec<_> = self.header.iter().collect();
        Error::new(
            format!("its header is `{}`", found.join(",")),
            format!("give it the columns {columns}"),
        )
        .at_line(&self.path, 1 + skipped(&self.text))
    }

    /// A fault of the file as a whole.
    pub fn fault(&self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::new(what, remedy).in_file(&self.path)
    }

    /// The rows below the header.
    pub fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.records.iter().map(|record| Row { sheet: self, record })
    }
}

/// One row of a [`Sheet`].
#[derive(Clone, Copy)]
pub struct Row<'a> {
    sheet: &'a Sheet,
    record: &'a StringRecord,
}

impl<'a> Row<'a> {
    /// The texts of all columns.
    pub fn texts(self) -> impl Iterator<Item = &'a str> {
        self.record.iter()
    }

    /// The text of a column.
    #[must_use]
    pub fn text(self, column: usize) -> &'a str {
        self.record.get(column).unwrap_or_default()
    }

    /// The finite number in a column.
    ///
    /// # Errors
    ///
    /// A text that is none.
    pub fn number(self, column: usize) -> Result<f64> {
        let text = self.text(column);
        let number: f64 = text.parse().map_err(|_| {
            self.fault(format!("`{text}` is no number"), "write it like 0.25 or 2.5e-1")
        })?;
        if number.is_finite() {
            Ok(number)
        } else {
            Err(self.fault(
                format!("`{text}` is not a finite number"),
                "correct the row, or take it out with all of its entry",
            ))
        }
    }

    /// The whole number in a column.
    ///
    /// # Errors
    ///
    /// A text that is none.
    pub fn integer(self, column: usize) -> Result<i64> {
        let text = self.text(column);
        text.parse().map_err(|_| {
            self.fault(format!("`{text}` is no index"), "write a small whole number, like 0 or -1")
        })
    }

    /// A fault at this row.
    pub fn fault(self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        let line = line_of(&self.sheet.text, self.record.position());
        Error::new(what, remedy).at_line(&self.sheet.path, line)
    }
}

fn csv_fault(path: &Path, text: &[u8], columns: &str, error: &csv::Error) -> Error {
    let line = line_of(text, error.position());
    match error.kind() {
        ErrorKind::UnequalLengths { expected_len, len, .. } => Error::new(
            format!("the header has {expected_len} fields, this row {len}"),
            "give every row one field for each column",
        )
        .at_line(path, line),
        ErrorKind::Utf8 { .. } => Error::new(
            "it is not UTF-8 text",
            format!("save it as a UTF-8 text file with the header `{columns}`"),
        )
        .at_line(path, line),
        _ => {
            Error::new(error.to_string(), format!("make it a CSV file with the header `{columns}`"))
                .in_file(path)
        }
    }
}

/// The line, from 1, of the record at `position`. The reader gives the place
/// where it began to look for the record, before any comments.
fn line_of(text: &[u8], position: Option<&csv::Position>) -> u64 {
    let start = position.map_or(0, |position| position.byte() as usize);
    let (before, after) = text.split_at(start.min(text.len()));
    let above = before.iter().filter(|&&byte| byte == b'\n').count() as u64;
    1 + above + skipped(after)
}

/// How many empty and comment lines a text begins with.
fn skipped(text: &[u8]) -> u64 {
    text.split_inclusive(|&byte| byte == b'\n')
        .take_while(|line| matches!(line, [b'#', ..] | [b'\n'] | [b'\r', b'\n']))
        .count() as u64
}
