//! Whether a command writes its output or compares it with what is there.

use clap::Args;
use std::path::PathBuf;

/// One of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Purpose {
    /// Write to this folder or file
    #[arg(long, value_name = "PATH")]
    pub out: Option<PathBuf>,
    /// Compare this folder or file with what is measured now
    #[arg(long, value_name = "PATH")]
    pub check: Option<PathBuf>,
}
