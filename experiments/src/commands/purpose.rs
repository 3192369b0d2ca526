//! Whether a command writes its output or compares it with an existing file.

use clap::Args;
use std::path::PathBuf;

/// Exactly one of the two is required.
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
