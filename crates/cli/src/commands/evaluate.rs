//! `eigenshade evaluate`: evaluates functions of the paper.

use super::Memory;
use super::evaluate_functions::Function;
use clap::Args;
use eigenshade_cli::output::number::exact;
use eigenshade_cli::output::rows::Rows;
use eigenshade_cli::output::{collision, destination};
use eigenshade_model::error::Result;
use eigenshade_model::inputs::sheet::{Row, Sheet};
use std::path::PathBuf;

/// Evaluate a function of the paper at given points
///
/// Writes the points with the function's value in the last column, `value`, with all digits. An
/// existing column `value` is replaced; the other columns keep their order. Indices go up to 64;
/// angles are in radians.
#[derive(Args, Debug)]
pub struct Evaluate {
    /// The function
    #[arg(value_enum)]
    function: Function,
    /// CSV with one column for each index and argument
    #[arg(value_name = "POINTS.csv")]
    points: PathBuf,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Evaluate {
    pub fn run(self, memory: Memory) -> Result<()> {
        collision::refuse(&self.out, [&self.points])?;
        let function = self.function;
        let (indices, arguments) = function.columns();
        let columns = [indices, arguments].concat().join(",");
        let sheet = Sheet::read(memory.file(&self.points), &columns)?;
        let places = |names: &[&str]| -> Result<Vec<usize>> {
            let places = names.iter().map(|name| sheet.column(name)).collect::<Option<_>>();
            places.ok_or_else(|| sheet.wrong_header(&format!("`{columns}`")))
        };
        let (indices, arguments) = (places(indices)?, places(arguments)?);
        // First all values, then the file.
        let values = sheet
            .rows()
            .map(|row| value(function, row, &indices, &arguments))
            .collect::<Result<Vec<_>>>()?;
        let replaced = sheet.column("value");
        let is_kept = |(place, _): &(usize, &str)| Some(*place) != replaced;
        destination::write(self.out.as_deref(), |out| {
            let kept = sheet.header().enumerate().filter(is_kept).map(|(_, name)| name);
            let mut rows = Rows::new(out, kept.chain(["value"]))?;
            for (row, value) in sheet.rows().zip(values) {
                let value = exact(value);
                let kept = row.texts().enumerate().filter(is_kept).map(|(_, text)| text);
                rows.row(kept.chain([value.as_str()]))?;
            }
            rows.finish()
        })
    }
}

fn value(function: Function, row: Row<'_>, indices: &[usize], arguments: &[usize]) -> Result<f64> {
    let indices = indices.iter().map(|&place| row.integer(place)).collect::<Result<Vec<_>>>()?;
    let arguments = arguments.iter().map(|&place| row.number(place)).collect::<Result<Vec<_>>>()?;
    let value = function.value(&indices, &arguments);
    match value.map_err(|(what, remedy)| row.fault(what, remedy))? {
        value if value.is_finite() => Ok(value),
        value => Err(row.fault(format!("the value is {value}"), "keep to smaller indices")),
    }
}
