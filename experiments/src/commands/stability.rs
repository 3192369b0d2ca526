//! `experiments stability`: the numerically hard cases.

use super::page;
use super::purpose::Purpose;
use clap::Args;
use eigenshade_cli::output::message::spinner;
use eigenshade_model::error::{Error, Result};
use experiments::stability::page as stability;

/// The numerically hard cases, measured, docs/stability.md; ratios of times are not compared
#[derive(Args, Debug)]
pub struct Stability {
    #[command(flatten)]
    purpose: Purpose,
}

impl Stability {
    pub fn run(self) -> Result<()> {
        let progress = spinner("cases");
        let parts = stability::parts(|name| progress.set_message(name.to_owned()));
        progress.finish_and_clear();
        let parts = parts.map_err(|fault| Error::new(fault, "every bound has to hold"))?;
        page::insert_or_compare(&self.purpose, &parts, stability::COMMAND, stability::compare)
    }
}
