//! Recorded CSV files: their rows, and the counts of the boards, `firmware/counts.csv`.

use crate::numbers::digits;
use clap::Args;
use eigenshade_cli::output::{Rows, write_all};
use eigenshade_model::error::{Error, Result};
use std::collections::BTreeMap;
use std::fmt::Display;
use std::fs;
use std::path::{Path, PathBuf};

/// Whether a command writes its output or compares it with what is there: one of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Purpose {
    /// Write to this folder or file
    #[arg(long, value_name = "PATH")]
    pub out: Option<PathBuf>,
    /// Compare this folder or file with the current measurements
    #[arg(long, value_name = "PATH")]
    pub check: Option<PathBuf>,
}

impl Purpose {
    /// Writes `text` to `--out`, or compares it with the file of `--check`: `compare(recorded,
    /// text)` returns the first difference. `name` is that of a file in the folder, if any;
    /// `command` rewrites the file.
    pub fn write_or_compare<T>(
        &self,
        name: &str,
        text: &str,
        command: &str,
        compare: impl Fn(&str, &str) -> std::result::Result<T, String>,
    ) -> Result<()> {
        let in_folder =
            |path: &PathBuf| if name.is_empty() { path.clone() } else { path.join(name) };
        if let Some(path) = self.out.as_ref().map(in_folder) {
            write_all(Some(&path), text)?;
        }
        if let Some(path) = self.check.as_ref().map(in_folder) {
            let recorded = fs::read_to_string(&path).map_err(|error| Error::io(&path, &error))?;
            compare(&recorded, text).map_err(|fault| {
                Error::new(fault, format!("make it again with `{command}`")).in_file(&path)
            })?;
        }
        Ok(())
    }
}

/// Significant digits of measured numbers.
const DIGITS: usize = 4;

#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    pub columns: Vec<String>,
    pub rows: Vec<Record>,
}

/// A row: texts by column. Columns without a text are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record {
    texts: BTreeMap<String, String>,
    /// The row's line in its file, counted from 1.
    pub line: u64,
}

pub struct Form {
    pub name: &'static str,
    pub columns: &'static str,
    /// The columns that identify a row.
    pub keys: &'static [&'static str],
}

impl Sheet {
    /// Parses the text of a file, which appears in errors.
    pub fn parse(text: &str, file: impl AsRef<Path>) -> Result<Self> {
        let remedy = "make the file again with the command of its first line";
        let fault =
            |error: csv::Error| Error::new(error.to_string(), remedy).in_file(file.as_ref());
        let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
        let header = reader.headers().map_err(fault)?;
        let columns: Vec<String> = header.iter().map(str::to_owned).collect();
        let row = |record: csv::Result<csv::StringRecord>| {
            let record = record.map_err(fault)?;
            let line = record.position().map_or(0, csv::Position::line);
            let fields = columns.iter().cloned().zip(record.iter().map(str::to_owned));
            Ok(Record { texts: fields.collect(), line })
        };
        let rows = reader.records().map(row).collect::<Result<_>>()?;
        Ok(Self { columns, rows })
    }

    pub fn read(path: &Path) -> Result<Self> {
        let text = fs::read_to_string(path).map_err(|error| Error::io(path, &error))?;
        Self::parse(&text, path)
    }

    /// The rows with this text in a column, which must exist.
    pub fn only(mut self, column: &str, text: &str) -> Self {
        self.check(column);
        self.rows.retain(|row| row.text(column) == text);
        self
    }

    /// The texts of a column, which must exist.
    pub fn texts(&self, column: &str) -> Vec<&str> {
        self.check(column);
        self.rows.iter().map(|row| row.text(column)).collect()
    }

    fn check(&self, column: &str) {
        assert!(self.columns.iter().any(|name| name == column), "no column `{column}`");
    }

    /// The numbers of a column. An empty field stands for more than was tried.
    pub fn numbers(&self, column: &str) -> Vec<f64> {
        let parse = |text: &str| text.parse().unwrap_or(f64::INFINITY);
        self.texts(column).into_iter().map(parse).collect()
    }
}

impl Record {
    pub fn text(&self, column: &str) -> &str {
        self.texts.get(column).map_or("", String::as_str)
    }

    /// The number in a column, if it has one.
    pub fn number(&self, column: &str) -> Option<f64> {
        self.text(column).parse().ok()
    }

    /// The texts that identify the row.
    pub fn key(&self, form: &Form) -> Vec<&str> {
        form.keys.iter().map(|column| self.text(column)).collect()
    }

    /// Fills in a text or an exact number.
    pub fn put(&mut self, column: impl Into<String>, value: impl Display) {
        self.texts.insert(column.into(), value.to_string());
    }

    /// Fills in an error or a cost with few digits, if there is one.
    pub fn measure(&mut self, column: impl Into<String>, value: impl Into<Option<f64>>) {
        if let Some(value) = value.into() {
            self.put(column, digits(value, DIGITS));
        }
    }
}

/// The texts of a row's fields.
pub fn fields(values: &[&dyn Display]) -> Vec<String> {
    values.iter().map(ToString::to_string).collect()
}

/// The text of a CSV below a first line of comment; `columns` are separated by commas.
pub fn csv<R: IntoIterator<Item: AsRef<[u8]>>>(
    comment: &str,
    columns: &str,
    rows: impl IntoIterator<Item = R>,
) -> Result<String> {
    let mut bytes = format!("# {comment}\n").into_bytes();
    let mut text = Rows::new(&mut bytes, columns.split(','))?;
    for row in rows {
        text.row(row)?;
    }
    text.finish()?;
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// Compares two CSV texts cell by cell: `same(recorded row, column, old, new)`. Returns the number of
/// cells, or the first difference.
pub fn compare_cells(
    recorded: &str,
    now: &str,
    same: impl Fn(&csv::StringRecord, usize, &str, &str) -> bool,
) -> std::result::Result<usize, String> {
    let rows = |text: &str| {
        let mut reader = csv::ReaderBuilder::new();
        let reader = reader.comment(Some(b'#')).has_headers(false).flexible(true);
        let rows = reader.from_reader(text.as_bytes()).into_records().collect();
        let rows: csv::Result<Vec<csv::StringRecord>> = rows;
        rows.map_err(|error| error.to_string())
    };
    let (old, new) = (rows(recorded)?, rows(now)?);
    let mut count = 0;
    for (before, after) in old.iter().zip(&new) {
        let line = before.position().map_or(0, csv::Position::line);
        if before.len() != after.len() {
            return Err(format!(
                "line {line}: {} fields where {} belong",
                before.len(),
                after.len()
            ));
        }
        for (column, (a, b)) in before.iter().zip(after).enumerate() {
            if !same(before, column, a, b) {
                return Err(format!("line {line}: recorded `{a}`, now `{b}`"));
            }
            count += 1;
        }
    }
    if old.len() == new.len() { Ok(count) } else { Err("the number of lines differs".into()) }
}

/// The records of a file, which must have all columns.
pub fn read(form: &Form, folder: &Path) -> Result<Vec<Record>> {
    let path = folder.join(form.name);
    let sheet = Sheet::read(&path)?;
    let is_missing = |column: &&str| sheet.columns.iter().all(|name| name != column);
    match form.columns.split(',').find(is_missing) {
        None => Ok(sheet.rows),
        Some(missing) => {
            let remedy = format!("give it the columns {}", form.columns);
            Err(Error::new(format!("it has no column {missing}"), remedy).in_file(path))
        }
    }
}

/// The processor without a floating-point unit, and the number format that suits it.
pub const M0: [&str; 2] = ["microbit", "q15"];
/// The processor with a floating-point unit.
pub const M4F: [&str; 2] = ["mps2-an386", "f32"];

#[derive(Clone, Debug)]
pub struct Counts(pub Vec<Record>);

impl Counts {
    pub fn recorded() -> Self {
        let path = eigenshade_testing::repository().join("firmware/counts.csv");
        let text = std::fs::read_to_string(&path).expect("the recorded counts");
        Self(Sheet::parse(&text, path).expect("rows of counts").rows)
    }

    /// A count of an operation on a board in its format: `instructions`, or bytes of flash, RAM
    /// without the stack, or stack. `None` if it was not measured.
    pub fn get(&self, on: [&str; 2], operation: &str, column: &str) -> Option<u64> {
        let is_it = |row: &&Record| {
            ["board", "format"].map(|one| row.text(one)) == on && row.text("operation") == operation
        };
        let text = self.0.iter().find(is_it)?.text(column);
        (!text.is_empty()).then(|| text.parse().expect("a whole number"))
    }
}
