//! `eigenshade evaluate`: the paper's functions at given points.

use super::evaluate_functions::Function;
use clap::Args;
use csv::{ErrorKind, ReaderBuilder, StringRecord, Trim};
use eigenshade_cli::destination;
use eigenshade_cli::number::exact;
use eigenshade_cli::rows::Rows;
use eigenshade_generator::error::{Error, Result};
use std::path::{Path, PathBuf};

/// A function of the paper at given points
///
/// Writes the points with the function's value as the last column, `value`, with
/// all its digits. A column `value` that is there already is replaced; other
/// columns are kept in their order. Indices go to 64, angles are in radians.
#[derive(Args, Debug)]
pub struct Evaluate {
    /// The function
    #[arg(value_enum)]
    function: Function,
    /// CSV with a column for each index and argument
    #[arg(value_name = "POINTS.csv")]
    points: PathBuf,
    /// Where the CSV goes, instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Evaluate {
    pub fn run(self) -> Result<()> {
        let points = Points::read(&self.points, self.function)?;
        let values = points.values()?;
        destination::write(self.out.as_deref(), |out| {
            let mut rows = Rows::new(out, points.kept(&points.header).chain(["value"]))?;
            for (record, value) in points.records.iter().zip(values) {
                let value = exact(value);
                rows.row(points.kept(record).chain([value.as_str()]))?;
            }
            rows.finish()
        })
    }
}

/// A CSV of points.
struct Points<'a> {
    path: &'a Path,
    text: Vec<u8>,
    function: Function,
    header: StringRecord,
    records: Vec<StringRecord>,
    /// Where the function's indices and arguments stand.
    indices: Vec<usize>,
    arguments: Vec<usize>,
    /// Where an old value stands.
    replaced: Option<usize>,
}

impl<'a> Points<'a> {
    fn read(path: &'a Path, function: Function) -> Result<Self> {
        let text = std::fs::read(path).map_err(|error| Error::io(path, &error))?;
        let (indices, arguments) = function.columns();
        let columns = [indices, arguments].concat().join(",");
        let mut reader =
            ReaderBuilder::new().comment(Some(b'#')).trim(Trim::All).from_reader(text.as_slice());
        let header = reader.headers().map_err(|error| broken(path, &text, &error))?.clone();
        let records = reader.records().collect::<csv::Result<Vec<_>>>();
        let records = records.map_err(|error| broken(path, &text, &error))?;
        let place = |name: &&str| header.iter().position(|column| column == *name);
        let places = |names: &[&str]| names.iter().map(place).collect::<Option<Vec<_>>>();
        let (Some(indices), Some(arguments)) = (places(indices), places(arguments)) else {
            let found = header.iter().collect::<Vec<_>>().join(",");
            let what = format!("its header is `{found}`");
            let error = Error::new(what, format!("give it the columns `{columns}`"));
            return Err(error.at_line(path, 1 + skipped(&text)));
        };
        let replaced = place(&"value");
        Ok(Self { path, text, function, header, records, indices, arguments, replaced })
    }

    /// The fields of a row without an old value.
    fn kept<'b>(&self, record: &'b StringRecord) -> impl Iterator<Item = &'b str> {
        let replaced = self.replaced;
        let fields = record.iter().enumerate();
        fields.filter(move |(place, _)| Some(*place) != replaced).map(|(_, field)| field)
    }

    fn values(&self) -> Result<Vec<f64>> {
        self.records.iter().map(|record| self.value(record)).collect()
    }

    fn value(&self, record: &StringRecord) -> Result<f64> {
        let fault = |what: String, remedy: &str| {
            Error::new(what, remedy).at_line(self.path, line_of(&self.text, record.position()))
        };
        let field = |&place: &usize| record.get(place).unwrap_or_default();
        let index = |place: &usize| {
            let text = field(place);
            let remedy = "write a small whole number, like 0 or -1";
            text.parse::<i64>().map_err(|_| fault(format!("`{text}` is no index"), remedy))
        };
        let argument = |place: &usize| {
            let text = field(place);
            let number = text.parse().ok().filter(|number: &f64| number.is_finite());
            let what = || format!("`{text}` is not a finite number");
            number.ok_or_else(|| fault(what(), "write it like 0.25 or 2.5e-1"))
        };
        let indices = self.indices.iter().map(index).collect::<Result<Vec<_>>>()?;
        let arguments = self.arguments.iter().map(argument).collect::<Result<Vec<_>>>()?;
        let value = self.function.value(&indices, &arguments);
        value.map_err(|(what, remedy)| fault(what, &remedy))
    }
}

fn broken(path: &Path, text: &[u8], error: &csv::Error) -> Error {
    let what = match error.kind() {
        ErrorKind::UnequalLengths { expected_len, len, .. } => {
            format!("the header has {expected_len} fields, this row {len}")
        }
        ErrorKind::Utf8 { .. } => "it is not UTF-8 text".to_owned(),
        _ => error.to_string(),
    };
    let error_line = line_of(text, error.position());
    Error::new(what, "make it a CSV file with one field for each column").at_line(path, error_line)
}

/// The line, from 1, of the record at `position`, which is where the reader began
/// to look for it, before comments.
fn line_of(text: &[u8], position: Option<&csv::Position>) -> u64 {
    let start = position.map_or(0, |position| position.byte() as usize).min(text.len());
    let (before, after) = text.split_at(start);
    1 + before.iter().filter(|&&byte| byte == b'\n').count() as u64 + skipped(after)
}

/// How many empty and comment lines a text begins with.
fn skipped(text: &[u8]) -> u64 {
    text.split_inclusive(|&byte| byte == b'\n')
        .take_while(|line| matches!(line, [b'#', ..] | [b'\n'] | [b'\r', b'\n']))
        .count() as u64
}
