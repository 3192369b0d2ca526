//! The commands whose files fill a folder: `experiments paper` and `experiments accuracy-cost`.

use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar, spinner};
use eigenshade_cli::output;
use eigenshade_model::error::{Error, Result};
use experiments::accuracy_cost::sheet::{self, SETTINGS, compare};
use experiments::accuracy_cost::{Measured, report};
use experiments::pages::{Purpose, filled};
use experiments::paper;
use std::fs;
use std::path::PathBuf;

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
        let made = paper::make(folder);
        progress.finish_and_clear();
        let files = made?;
        if let Some(folder) = out {
            paper::FIGURES.write(&files, folder)?;
            print_message(format_args!("{} files in {}", files.len(), folder.display()));
        }
        if let Some(folder) = check {
            let [numbers, pixels] = paper::FIGURES.compare(&files, folder)?;
            let count = files.len();
            print_message(format_args!(
                "{count} files are up to date: {numbers} numbers, {pixels} pixels"
            ));
        }
        Ok(())
    }
}

/// The cost of accuracy: error, bytes and time as every parameter varies
///
/// --out writes the numbers as CSV and the charts as SVG to DIR, and the tables of
/// DIR/accuracy-cost.md: errors against the direct sum over the shipped lights and materials and
/// over others, errors of a degree and an order against direct integration under captured maps,
/// total errors of pictures against direct integration, times on this machine, and the instructions
/// that were counted on emulated boards. --check recomputes errors, bytes and counts and compares
/// them with the files of a folder; times are not compared. It also compares the charts and tables
/// there with the CSV files, and fails if the folder has other files. --quick does either for a part
/// of the settings. A full run takes some ten minutes on two cores, a quick check one.
#[derive(Args, Debug)]
pub struct AccuracyCost {
    #[command(flatten)]
    purpose: Purpose,
    /// Only a part of the settings, surfaces and sizes
    #[arg(long)]
    quick: bool,
    /// With --out: keep the times of DIR's files and recompute the rest
    #[arg(long, conflicts_with_all = ["quick", "check"])]
    keep_times: bool,
    /// Also write, or compare, the choices of a setting in this page
    #[arg(long, value_name = "FILE")]
    page: Option<PathBuf>,
    /// With --out: measure nothing, only make the charts and tables from DIR's CSV files
    #[arg(long, conflicts_with_all = ["quick", "check", "keep_times"])]
    from_csv: bool,
    /// Folder of the project's environment maps
    #[arg(long, value_name = "DIR", default_value = "tables/inputs/maps")]
    maps: PathBuf,
}

impl AccuracyCost {
    pub fn run(self) -> Result<()> {
        let measure =
            |timed| Measured::new(self.quick, timed, &self.maps, &progress_bar("settings", 0));
        // Paths that cannot be read or written fail before the long computation.
        if let Some(out) = &self.purpose.out {
            fs::create_dir_all(out).map_err(|error| Error::io(out, &error))?;
            let earlier = (self.keep_times || self.from_csv).then(|| Measured::read(out));
            let measured = match earlier.transpose()? {
                Some(earlier) if self.from_csv => earlier,
                Some(earlier) => {
                    let mut measured = measure(false)?;
                    measured.keep_times(&earlier)?;
                    measured
                }
                None => measure(true)?,
            };
            let files = report::files(&measured, out)?;
            sheet::FIGURES.write(&files, out)?;
            if let Some(page) = &self.page {
                let text = filled(page, &[report::choice(&measured)])?;
                output::write_all(Some(page), &text)?;
            }
            let (settings, files) = (measured.settings.len(), files.len());
            print_message(format_args!("{settings} settings, {files} files in {}", out.display()));
        }
        if let Some(folder) = &self.purpose.check {
            let numbers = folder.join(SETTINGS.name);
            fs::metadata(&numbers).map_err(|error| Error::io(&numbers, &error))?;
            let measured = measure(false)?;
            let [mut rows, mut numbers] = [0, 0];
            for (form, records) in measured.sheets() {
                let compared = compare(form, records, folder, !self.quick)?;
                rows += compared[0];
                numbers += compared[1];
            }
            let recorded = Measured::read(folder)?;
            let shown = report::files(&recorded, folder)?;
            sheet::FIGURES.compare(&shown, folder)?;
            if let Some(page) = &self.page {
                let text = fs::read_to_string(page).map_err(|error| Error::io(page, &error))?;
                if text != filled(page, &[report::choice(&recorded)])? {
                    let what = "its choices are not those of the files";
                    let remedy = "run it with --from-csv --out instead of --check";
                    return Err(Error::new(what, remedy).in_file(page));
                }
            }
            print_message(format_args!("{rows} rows are what they should be: {numbers} numbers"));
        }
        Ok(())
    }
}
