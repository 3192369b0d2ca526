//! `experiments reading`: estimates of light and material from damaged images.

use super::page;
use super::purpose::Purpose;
use clap::Args;
use eigenshade_model::error::Result;
use experiments::reading::{figures, report};
use std::path::PathBuf;

/// Errors of estimates from damaged images, docs/reading.md
#[derive(Args, Debug)]
pub struct Reading {
    #[command(flatten)]
    purpose: Purpose,
    /// Folder of the shipped tables
    #[arg(long, value_name = "DIR", default_value = "tables")]
    tables: PathBuf,
}

impl Reading {
    pub fn run(self) -> Result<()> {
        let parts = report::parts(&self.tables)?;
        page::insert_or_compare(&self.purpose, &parts, report::COMMAND, figures::compare)
    }
}
