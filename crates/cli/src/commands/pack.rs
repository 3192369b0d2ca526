//! `eigenshade pack`: writes a table as a wire file.

use super::options::Memory;
use clap::{Args, ValueEnum};
use eigenshade_cli::messages::{grouped, print_message};
use eigenshade_cli::output;
use eigenshade_cli::table::{self, rounding};
use eigenshade_model::error::{Error, Result};
use eigenshade_table::quantize;
use eigenshade_table::wire::{self, Endian};
use std::path::PathBuf;

/// Write a table as a wire file, which the runtime reads in place
///
/// Wire files are for tables that arrive at run time, from flash or over a network:
/// `Basis::from_bytes` reads them. `eigenshade info` describes them.
#[derive(Args, Debug)]
pub struct Pack {
    /// The table
    #[arg(value_name = "B.bin")]
    table: PathBuf,
    /// Number format of the file
    #[arg(long, value_enum, default_value_t = Format::F32)]
    format: Format,
    /// Write for a big-endian machine
    #[arg(long)]
    big_endian: bool,
    /// Write the wire file to this file
    #[arg(long, value_name = "W.esw")]
    out: PathBuf,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Format {
    F32,
    Q15,
    Q31,
}

impl Pack {
    pub fn run(self, memory: Memory) -> Result<()> {
        output::refuse_collisions([&self.out], [&self.table])?;
        let table = table::read(memory.file(&self.table))?;
        let format = match self.format {
            Format::F32 => wire::Format::F32,
            Format::Q15 => wire::Format::Integer(quantize::Format::Q15),
            Format::Q31 => wire::Format::Integer(quantize::Format::Q31),
        };
        let endian = if self.big_endian { Endian::Big } else { Endian::Little };
        let bytes = wire::encode(&table, format, endian).map_err(|error| {
            let line = error.to_string();
            let (what, remedy) = line.rsplit_once("; ").unwrap_or((&line, "pack it as f32"));
            Error::new(what, remedy).in_file(&self.table)
        })?;
        output::write_all(Some(&self.out), &bytes)?;
        let mut text = format!("{:<12} {}\n", "bytes", grouped(bytes.len()));
        if let Some(one) = table.rounding(format) {
            text += &format!(
                "{:<12} {:.1e} of the peak at most, rms {:.1e}\n",
                "error", one.largest, one.rms
            );
        }
        rounding::warning(&table, format).iter().for_each(print_message);
        output::write_all(None, text)
    }
}
