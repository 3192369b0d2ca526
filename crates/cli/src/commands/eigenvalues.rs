//! `eigenshade eigenvalues`: writes the spectrum of a table.

use super::Memory;
use clap::Args;
use eigenshade_cli::output::number::exact;
use eigenshade_cli::output::rows::Rows;
use eigenshade_cli::output::{collision, destination};
use eigenshade_cli::table::table_file;
use eigenshade_model::error::Result;
use std::path::PathBuf;

/// Write the eigenvalues of a table, as CSV `criterion,index,m,eigenvalue`
///
/// Includes the eigenvalues of components that the table does not keep. The constant of the
/// image-centered criterion, index 0, has none: its field is empty.
#[derive(Args, Debug)]
pub struct Eigenvalues {
    /// The table
    #[arg(value_name = "B.bin")]
    table: PathBuf,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Eigenvalues {
    pub fn run(self, memory: Memory) -> Result<()> {
        collision::refuse(&self.out, [&self.table])?;
        let table = table_file::read(memory.file(&self.table))?;
        let criterion = table.scene.basis.criterion.name();
        destination::write(self.out.as_deref(), |out| {
            let mut rows = Rows::new(out, ["criterion", "index", "m", "eigenvalue"])?;
            for (index, (m, value)) in table.spectrum.iter().enumerate() {
                let value = value.map(exact).unwrap_or_default();
                let m = m.map(|m| m.to_string()).unwrap_or_default();
                rows.row([criterion, &index.to_string(), &m, &value])?;
            }
            rows.finish()
        })
    }
}
