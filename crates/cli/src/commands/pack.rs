//! `eigenshade pack`: writes a table as a wire file.

use super::options::{TableChoice, choice, count};
use clap::Args;
use eigenshade_cli::messages::grouped;
use eigenshade_cli::output;
use eigenshade_cli::table::{self, rounding};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::shipped;
use eigenshade_table::reduce::with_components;
use eigenshade_table::wire::{self, Endian, NumberFormat};
use eigenshade_table::{Rounding, Table};
use std::path::PathBuf;

/// Write a table as a wire file, which the runtime reads in place
///
/// Wire files are for tables that arrive at run time, from flash or over a network:
/// `Basis::from_bytes` reads them. `eigenshade info` describes them.
#[derive(Args, Debug)]
pub struct Pack {
    #[command(flatten)]
    table: TableChoice,
    /// Number format of the file
    #[arg(short, long, default_value = "f32",
        value_parser = choice(NumberFormat::ALL.map(|format| (format.name(), "", format))))]
    format: NumberFormat,
    /// Keep only the first components, which have the highest variance [default: all]
    #[arg(long, value_name = "K", value_parser = count(1, u64::from(u16::MAX)))]
    components: Option<usize>,
    /// Write for a big-endian machine
    #[arg(long)]
    big_endian: bool,
    /// Write the wire file to this file
    #[arg(short, long, value_name = "FILE")]
    out: PathBuf,
}

impl Pack {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions([&self.out], [self.table.path()])?;
        let table = self.first_components(self.table.read()?)?;
        let format = self.format;
        let endian = if self.big_endian { Endian::Big } else { Endian::Little };
        let bytes = wire::encode(&table, format, endian)
            .map_err(|error| Error::of_line(error, "pack it as f32").in_file(self.table.path()))?;
        output::write_all(Some(&self.out), &bytes)?;
        let mut text = format!("{:<12} {}\n", "bytes", grouped(bytes.len()));
        let (rounding, over) = match self.components {
            None => (table.rounding(format).copied(), "the table's database"),
            Some(_) => {
                let materials = shipped::named_materials(table.gram.order)?;
                let of_format = [format];
                let found = rounding::measure(&table, &shipped::lights()?, &materials, &of_format);
                (found.first().copied(), "the shipped lights and materials")
            }
        };
        if let Some(Rounding { largest, rms, .. }) = rounding {
            let error = format!("{largest:.1e} of the peak at most, rms {rms:.1e}, over {over}");
            text += &format!("{:<12} {error}\n", "error");
        }
        output::report(text)
    }

    /// The table with the components that are asked for.
    fn first_components(&self, table: Table) -> Result<Table> {
        if self.components.is_none() {
            return Ok(table);
        }
        let count = table::components(&table, self.components, self.table.path())?;
        if !table.has_projection() {
            let what = "only a table that projects can lose components";
            return Err(Error::new(what, "make it with fewer").in_file(self.table.path()));
        }
        Ok(with_components(&table, |number, _| number < count))
    }
}
