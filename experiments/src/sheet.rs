//! CSV files in memory: rows of texts by column.

use crate::numbers::digits;
use eigenshade_cli::output::Rows;
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet as parser;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::path::Path;

/// Significant digits of measured numbers.
const DIGITS: usize = 4;

/// The rows of a CSV file.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sheet {
    /// The names of the columns.
    pub columns: Vec<String>,
    /// The rows.
    pub rows: Vec<Record>,
}

/// A row: texts by column. Columns without a text are empty.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Record(BTreeMap<String, String>);

/// The form of a CSV file.
pub struct Form {
    /// The file's name.
    pub name: &'static str,
    /// Its columns.
    pub columns: &'static str,
    /// The columns that identify a row.
    pub keys: &'static [&'static str],
}

impl Sheet {
    /// Parses the text of a file, whose name appears in errors.
    pub fn parse(text: &str, name: &str) -> Result<Self> {
        let header = text.lines().find(|line| !line.starts_with('#')).unwrap_or_default();
        let parsed = parser::Sheet::parse(text.into(), Path::new(name), header)?;
        let columns = parsed.header().map(str::to_owned).collect();
        Ok(Self { columns, rows: records(&parsed) })
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
    /// The text in a column.
    pub fn text(&self, column: &str) -> &str {
        self.0.get(column).map_or("", String::as_str)
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
        self.0.insert(column.into(), value.to_string());
    }

    /// Fills in an error or a cost with few digits, if there is one.
    pub fn measure(&mut self, column: impl Into<String>, value: impl Into<Option<f64>>) {
        if let Some(value) = value.into() {
            self.put(column, digits(value, DIGITS));
        }
    }
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

/// The records of a file, which must have all columns.
pub fn read(form: &Form, folder: &Path) -> Result<Vec<Record>> {
    Ok(records(&open(form, folder)?))
}

/// The file in this folder, which must have all columns, with the lines of its rows.
pub fn open(form: &Form, folder: &Path) -> Result<parser::Sheet> {
    let sheet = parser::Sheet::read(folder.join(form.name), form.columns)?;
    if form.columns.split(',').any(|column| sheet.column(column).is_none()) {
        return Err(sheet.wrong_header(form.columns));
    }
    Ok(sheet)
}

/// The rows of a parsed file.
pub fn records(sheet: &parser::Sheet) -> Vec<Record> {
    let record = |row: parser::Row<'_>| {
        let fields = sheet.header().zip(row.texts());
        Record(fields.map(|(column, text)| (column.to_owned(), text.to_owned())).collect())
    };
    sheet.rows().map(record).collect()
}
