//! `experiments accuracy-cost`: the error and the cost of every setting.

use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_model::error::{Error, Result};
use experiments::accuracy_cost::check;
use experiments::accuracy_cost::sheet::{FIGURES, SETTINGS};
use experiments::accuracy_cost::{Measured, report};
use experiments::pages::Purpose;
use std::fs;
use std::path::PathBuf;

/// The cost of accuracy: error, bytes and time as every parameter varies
///
/// --out writes the numbers as CSV and the charts as SVG to DIR, and the tables of
/// DIR/accuracy-cost.md: errors against the direct sum over the shipped lights and materials and
/// over others, errors of a degree and an order against direct integration under captured maps,
/// times on this machine, and the instructions that were counted on emulated boards. --check
/// recomputes errors, bytes and counts and compares them with the files of a folder; times are not
/// compared. It also compares the charts and tables there with the CSV files, and fails if the
/// folder has other files. --quick does either for a part of the settings. A full run takes some
/// ten minutes on two cores, a quick check a minute and a half.
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
    /// With --out: measure nothing, only make the charts and tables from DIR's CSV files
    #[arg(long, conflicts_with_all = ["quick", "check", "keep_times"])]
    from_csv: bool,
    /// Folder of the project's environment maps
    #[arg(long, value_name = "DIR", default_value = "tables/inputs/maps")]
    maps: PathBuf,
}

impl AccuracyCost {
    pub fn run(self) -> Result<()> {
        let measure = |timed| {
            let progress = progress_bar("settings", 0);
            let measured = Measured::new(self.quick, timed, &self.maps, &progress);
            progress.finish_and_clear();
            measured
        };
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
            FIGURES.write(&files, out)?;
            let (settings, files) = (measured.settings.len(), files.len());
            print_message(format_args!("{settings} settings, {files} files in {}", out.display()));
        }
        if let Some(folder) = &self.purpose.check {
            let numbers = folder.join(SETTINGS.name);
            fs::metadata(&numbers).map_err(|error| Error::io(&numbers, &error))?;
            let measured = measure(false)?;
            let [mut rows, mut numbers] = [0, 0];
            for (form, records) in measured.sheets() {
                let compared = check::compare(form, records, folder, !self.quick)?;
                rows += compared[0];
                numbers += compared[1];
            }
            check::exponents(&measured.growth)?;
            let shown = report::files(&Measured::read(folder)?, folder)?;
            FIGURES.compare(&shown, folder)?;
            print_message(format_args!("{rows} rows are what they should be: {numbers} numbers"));
        }
        Ok(())
    }
}
