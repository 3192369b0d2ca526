//! `experiments paper`: the figures of the paper, on the shipped data.

use clap::Args;
use eigenshade_cli::messages::{print_message, spinner};
use eigenshade_model::error::Result;
use experiments::pages::Purpose;
use experiments::paper::{FIGURES, make};

/// The figures of Nillius and Eklundh (2003) and their numbers, on the shipped data
///
/// --out replaces the tables of DIR/paper.md and writes the files that it shows to DIR/paper: CSV,
/// SVG charts and PNG pictures. --check recomputes everything and compares every file: counts and
/// words must be equal, other numbers within two units of six digits, or one of the last digit
/// where there are fewer; coordinates of charts within a pixel; pictures within one of 255 levels,
/// and in no more than a thousandth of their pixels. A missing figure and a file that is not a
/// figure are errors too. Both take a minute.
#[derive(Args, Debug)]
pub struct Paper {
    #[command(flatten)]
    purpose: Purpose,
}

impl Paper {
    pub fn run(self) -> Result<()> {
        let Purpose { out, check } = &self.purpose;
        let Some(folder) = out.as_ref().or(check.as_ref()) else { return Ok(()) };
        let progress = spinner("figures");
        let made = make(folder, &progress);
        progress.finish_and_clear();
        let files = made?;
        if let Some(folder) = out {
            FIGURES.write(&files, folder)?;
            print_message(format_args!("{} files in {}", files.len(), folder.display()));
        }
        if let Some(folder) = check {
            let [numbers, pixels] = FIGURES.compare(&files, folder)?;
            let count = files.len();
            print_message(format_args!(
                "{count} files are up to date: {numbers} numbers, {pixels} pixels"
            ));
        }
        Ok(())
    }
}
