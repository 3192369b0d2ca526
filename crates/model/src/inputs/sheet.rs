//! A CSV file with a header: access to columns by name, and line numbers for errors.

use super::input_file::InputFile;
use crate::error::{Error, Result};
use csv::{ErrorKind, ReaderBuilder, StringRecord, Trim};
use std::collections::HashSet;
use std::io::Write;
use std::path::Path;

/// The most rows and fields that are read.
const MOST_ROWS: u64 = 1 << 21;
const MOST_FIELDS: u64 = 1 << 24;

/// The rows of a CSV file.
///
/// Empty lines and lines that begin with `#` are skipped. Blanks around a field are ignored. The
/// columns may come in any order, mixed with others.
pub struct Sheet {
    file: InputFile,
    text: Vec<u8>,
    header: StringRecord,
    /// The concatenated fields of all rows.
    fields: String,
    /// The end of each field in `fields`.
    ends: Vec<usize>,
    /// The start of each row in `text`.
    starts: Vec<usize>,
}

impl Sheet {
    /// Reads a file. `columns` is the expected header, which appears in remedies.
    ///
    /// The file may have at most 2²¹ rows and 2²⁴ fields.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, is empty or not UTF-8, has two columns of the same name, or has
    /// a row whose length differs from the header.
    pub fn read(file: impl Into<InputFile>, columns: &str) -> Result<Self> {
        let file = file.into();
        let text = file.bytes_of_text()?;
        // Drops a text that was given: the rows hold it.
        let file = file.other(file.path());
        // An upper bound, because a comma may be part of a field.
        let count = |wanted: &[u8]| text.iter().filter(|byte| wanted.contains(byte)).count();
        let rows = count(b"\n\r") + 1;
        let fields = count(b",") + rows;
        file.at_most(rows as u64, MOST_ROWS, "rows")?;
        file.at_most(fields as u64, MOST_FIELDS, "fields")?;
        let path = file.path();
        let mut reader =
            ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(text.as_slice());
        let fault = |error: csv::Error| csv_fault(path, &text, columns, &error);
        let header = reader.headers().map_err(fault)?.clone();
        if header.is_empty() {
            return Err(Error::new("it is empty", format!("begin it with the header `{columns}`"))
                .in_file(path));
        }
        if let Some((place, name)) = doubled(&header) {
            let what =
                format!("column {} has the same name as an earlier one, `{name}`", place + 1);
            let error = Error::new(what, "give each column its own name");
            return Err(error.at_line(path, 1 + skipped(&text)));
        }
        let mut sheet = Self {
            header,
            fields: String::with_capacity(text.len()),
            ends: Vec::with_capacity(fields),
            starts: Vec::with_capacity(rows),
            text: Vec::new(),
            file: file.clone(),
        };
        let mut record = StringRecord::new();
        while reader.read_record(&mut record).map_err(fault)? {
            for field in &record {
                sheet.fields.push_str(field);
                sheet.ends.push(sheet.fields.len());
            }
            sheet.starts.push(record.position().map_or(0, |position| position.byte() as usize));
        }
        drop(reader);
        Ok(Self { text, ..sheet })
    }

    /// The names of the columns.
    pub fn header(&self) -> impl Iterator<Item = &str> {
        self.header.iter()
    }

    /// The index of a column, if it exists.
    #[must_use]
    pub fn column(&self, name: &str) -> Option<usize> {
        self.header().position(|column| column == name)
    }

    /// The indices of these columns, if all of them exist.
    #[must_use]
    pub fn columns<const N: usize>(&self, names: [&str; N]) -> Option<[usize; N]> {
        let places = names.map(|name| self.column(name));
        places.iter().all(Option::is_some).then(|| places.map(Option::unwrap_or_default))
    }

    /// The indices of red, green and blue: the columns `r,g,b`, or three times the gray column
    /// `value`. `None` if the file has neither.
    ///
    /// # Errors
    ///
    /// If the file has both, because the intended one is ambiguous.
    pub fn colors(&self) -> Result<Option<[usize; 3]>> {
        let rgb = ["r", "g", "b"];
        if let (Some(_), Some(color)) =
            (self.column("value"), rgb.into_iter().find(|name| self.column(name).is_some()))
        {
            let what = format!("it has the columns `value` and `{color}`");
            let error = Error::new(what, "keep r,g,b for colored values, or value for gray ones");
            return Err(error.at_line(self.file.path(), 1 + skipped(&self.text)));
        }
        Ok(self.columns(rgb).or_else(|| self.columns(["value"; 3])))
    }

    /// The error for a header without these columns.
    #[must_use]
    pub fn wrong_header(&self, columns: &str) -> Error {
        let found: Vec<_> = self.header.iter().collect();
        let what = format!("its header is `{}`", found.join(","));
        let error = Error::new(what, format!("give it the columns {columns}"));
        error.at_line(self.file.path(), 1 + skipped(&self.text))
    }

    /// An error that concerns the file as a whole.
    pub fn fault(&self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        Error::new(what, remedy).in_file(self.file.path())
    }

    /// The rows below the header.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = Row<'_>> {
        (0..self.starts.len()).map(|number| Row { sheet: self, number })
    }
}

/// One row of a [`Sheet`].
#[derive(Clone, Copy)]
pub struct Row<'a> {
    sheet: &'a Sheet,
    number: usize,
}

impl<'a> Row<'a> {
    /// The text in each column.
    pub fn texts(self) -> impl Iterator<Item = &'a str> {
        (0..self.sheet.header.len()).map(move |column| self.text(column))
    }

    /// The text in a column.
    #[must_use]
    pub fn text(self, column: usize) -> &'a str {
        let sheet = self.sheet;
        let place = self.number * sheet.header.len() + column;
        let start = place.checked_sub(1).map_or(0, |before| sheet.ends[before]);
        let end = sheet.ends.get(place).filter(|_| column < sheet.header.len());
        end.map_or("", |end| &sheet.fields[start..*end])
    }

    /// The finite number in a column.
    ///
    /// # Errors
    ///
    /// If the text is not a finite number.
    pub fn number(self, column: usize) -> Result<f64> {
        let text = self.text(column);
        let (what, remedy) = match text.parse::<f64>() {
            Ok(number) if number.is_finite() => return Ok(number),
            Ok(_) => ("finite number", "correct the row, or remove all rows of its entry"),
            Err(_) => ("number", "write it like 0.25 or 2.5e-1"),
        };
        Err(self.fault(format!("`{text}` is not a {what}"), remedy))
    }

    /// The finite numbers in these columns.
    ///
    /// # Errors
    ///
    /// As [`number`](Self::number), for the first column that has none.
    pub fn numbers<const N: usize>(self, columns: [usize; N]) -> Result<[f64; N]> {
        let mut numbers = [0.0; N];
        for (number, column) in numbers.iter_mut().zip(columns) {
            *number = self.number(column)?;
        }
        Ok(numbers)
    }

    /// The whole number in a column.
    ///
    /// # Errors
    ///
    /// If the text is not a whole number.
    pub fn integer(self, column: usize) -> Result<i64> {
        let text = self.text(column);
        text.parse().map_err(|_| {
            let remedy = "write a small whole number, like 0 or -1";
            self.fault(format!("`{text}` is not a whole number"), remedy)
        })
    }

    /// An error at this row.
    pub fn fault(self, what: impl Into<String>, remedy: impl Into<String>) -> Error {
        self.locate(Error::new(what, remedy))
    }

    /// The same error, located at this row.
    #[must_use]
    pub fn locate(self, error: Error) -> Error {
        let line = line_of(&self.sheet.text, self.sheet.starts[self.number]);
        error.at_line(self.sheet.file.path(), line)
    }
}

/// The entries of a CSV file with these columns, one for each row.
///
/// # Errors
///
/// As [`Sheet::read`] and `entry`, and if a column is missing.
pub(super) fn read_entries<T, const N: usize>(
    file: impl Into<InputFile>,
    columns: [&str; N],
    mut entry: impl FnMut(Row<'_>, [usize; N]) -> Result<T>,
) -> Result<Vec<T>> {
    let header = columns.join(",");
    let sheet = Sheet::read(file, &header)?;
    let places = sheet.columns(columns);
    let places = places.ok_or_else(|| sheet.wrong_header(&format!("`{header}`")))?;
    sheet.rows().map(|row| entry(row, places)).collect()
}

/// Writes a CSV file with these columns.
///
/// # Errors
///
/// If the output fails.
pub fn write_entries<const N: usize>(
    columns: [&str; N],
    rows: impl IntoIterator<Item = impl IntoIterator<Item = String>>,
    out: &mut (impl Write + ?Sized),
) -> Result<()> {
    let mut writer = csv::WriterBuilder::new().comment(Some(b'#')).from_writer(out);
    writer.write_record(columns).map_err(output_fault)?;
    for row in rows {
        writer.write_record(row.into_iter().collect::<Vec<_>>()).map_err(output_fault)?;
    }
    writer.flush().map_err(|error| output_fault(error.into()))
}

/// The error of an output.
pub(super) fn output_fault(error: csv::Error) -> Error {
    Error::new(error.to_string(), "check where the output goes")
}

/// The first column with the same name as an earlier one. Empty names do not count, and neither do
/// numbers, because a file without a header begins with numbers.
fn doubled(header: &StringRecord) -> Option<(usize, &str)> {
    let mut names = HashSet::new();
    let is_name = |name: &str| !name.is_empty() && name.parse::<f64>().is_err();
    header.iter().enumerate().find(|(_, name)| is_name(name) && !names.insert(*name))
}

fn csv_fault(path: &Path, text: &[u8], columns: &str, error: &csv::Error) -> Error {
    let line = line_of(text, error.position().map_or(0, |position| position.byte() as usize));
    let (what, remedy) = match error.kind() {
        ErrorKind::UnequalLengths { expected_len, len, .. } => (
            format!("the header has {expected_len} fields, but this row has {len}"),
            "give every row one field for each column".to_owned(),
        ),
        ErrorKind::Utf8 { .. } => (
            "it is not UTF-8 text".to_owned(),
            format!("save it as a UTF-8 text file with the header `{columns}`"),
        ),
        _ => {
            let remedy = format!("make it a CSV file with the header `{columns}`");
            return Error::new(error.to_string(), remedy).in_file(path);
        }
    };
    Error::new(what, remedy).at_line(path, line)
}

/// The line, counted from 1, of the record at byte `start`. The CSV reader reports the position
/// where it started to look for the record, before any comments.
fn line_of(text: &[u8], start: usize) -> u64 {
    let (before, after) = text.split_at(start.min(text.len()));
    let above = before.iter().filter(|&&byte| byte == b'\n').count() as u64;
    1 + above + skipped(after)
}

/// Number of empty and comment lines at the start of a text.
fn skipped(text: &[u8]) -> u64 {
    text.split_inclusive(|&byte| byte == b'\n')
        .take_while(|line| matches!(line, [b'#', ..] | [b'\n'] | [b'\r', b'\n']))
        .count() as u64
}
