//! What a command that makes a page is asked for.

use clap::Args;
use std::path::PathBuf;

/// One of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Purpose {
    /// Folder for the files; it is made if need be
    #[arg(long, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Compares the files of this folder with what the program finds now
    #[arg(long, value_name = "DIR")]
    pub check: Option<PathBuf>,
}
