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

pub fn paper(Purpose { out, check }: &Purpose) -> Result<()> {
    let Some(folder) = out.as_ref().or(check.as_ref()) else { return Ok(()) };
    let progress = spinner("figures");
    let made = paper::make(folder);
    progress.finish_and_clear();
    let files = made?;
    let count = files.len();
    if check.is_none() {
        paper::FIGURES.write(&files, folder)?;
        print_message(format_args!("{count} files in {}", folder.display()));
    } else {
        let [numbers, pixels] = paper::FIGURES.compare(&files, folder)?;
        print_message(format_args!(
            "{count} files are up to date: {numbers} numbers, {pixels} pixels"
        ));
    }
    Ok(())
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
            let measured = if self.from_csv {
                Measured::read(out)?
            } else if self.keep_times {
                let earlier = Measured::read(out)?;
                let mut measured = measure(false)?;
                measured.keep_times(&earlier)?;
                measured
            } else {
                measure(true)?
            };
            let files = report::files(&measured, out)?;
            sheet::FIGURES.write(&files, out)?;
            if let Some(page) = &self.page {
                output::write_all(Some(page), filled(page, &[report::choice(&measured)])?)?;
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
                let [more_rows, more_numbers] = compare(form, records, folder, !self.quick)?;
                (rows, numbers) = (rows + more_rows, numbers + more_numbers);
            }
            let recorded = Measured::read(folder)?;
            sheet::FIGURES.compare(&report::files(&recorded, folder)?, folder)?;
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
