//! How much memory a command may take.

use clap::Args;
use eigenshade_model::budget::Budget;
use eigenshade_model::inputs::input_file::InputFile;
use std::path::Path;

/// The budgets of a command.
#[derive(Args, Clone, Copy, Debug)]
pub struct Memory {
    /// Memory limit for reading an input file and for making a table, like 4GiB
    /// [default: 512MiB for a file, 2GiB for a table]
    #[arg(long = "memory", global = true, value_name = "SIZE")]
    budget: Option<Budget>,
}

impl Memory {
    /// For making a table.
    #[cfg(feature = "generate")]
    pub fn of_basis(self) -> Budget {
        self.budget.unwrap_or(Budget::BASIS)
    }

    /// A file that is read within its budget.
    pub fn file(self, path: impl AsRef<Path>) -> InputFile {
        InputFile::new(path, self.budget.unwrap_or(Budget::READING))
    }
}
