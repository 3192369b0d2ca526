//! `experiments paper`: the figures of the paper, on the shipped data.

use super::purpose::Purpose;
use clap::Args;
use eigenshade_cli::output::message::{say, spinner};
use eigenshade_model::error::{Error, Result};
use experiments::paper::comparison::{Compared, compare};
use experiments::paper::{FOLDER, PAGE, make};
use std::fs;

/// The figures of Nillius and Eklundh (2003) and their numbers, on the shipped data
///
/// --out writes DIR/paper.md, and the files that it shows to DIR/paper: CSV, SVG charts and PNG
/// pictures. --check recomputes everything and compares every file: counts and words must be equal,
/// other numbers within two units of six digits, or one of the last digit where there are fewer;
/// coordinates of charts within a pixel; pictures within one of 255 levels, and in no more than a
/// thousandth of their pixels. A missing figure and a file that is not a figure are errors too.
#[derive(Args, Debug)]
pub struct Paper {
    #[command(flatten)]
    purpose: Purpose,
}

impl Paper {
    pub fn run(self) -> Result<()> {
        if let Some(out) = &self.purpose.out {
            // Done first, so that a folder that cannot be created fails before the long
            // computation.
            let folder = out.join(FOLDER);
            fs::create_dir_all(&folder).map_err(|error| Error::io(&folder, &error))?;
        }
        if let Some(folder) = &self.purpose.check {
            let page = folder.join(PAGE);
            fs::metadata(&page).map_err(|error| Error::io(&page, &error))?;
        }
        let progress = spinner("figures");
        let made = make(&progress);
        progress.finish_and_clear();
        let artefacts = made?;
        if let Some(out) = &self.purpose.out {
            for artefact in &artefacts {
                artefact.write(out)?;
            }
            let page = out.join(PAGE);
            say(format_args!("{} and {} figures' files", page.display(), artefacts.len() - 1));
        }
        if let Some(folder) = &self.purpose.check {
            let Compared { files, numbers, marks, pixels } = compare(&artefacts, folder)?;
            say(format_args!(
                "{files} files are what they should be: {numbers} numbers, {marks} coordinates \
                 and colours of charts, {pixels} pixels"
            ));
        }
        Ok(())
    }
}
