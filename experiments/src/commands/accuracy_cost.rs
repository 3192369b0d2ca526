//! `experiments accuracy-cost`: the error and the cost of every setting.

use clap::Args;
use eigenshade_cli::messages::{print_message, progress_bar};
use eigenshade_cli::output;
use eigenshade_model::error::{Error, Result};
use experiments::accuracy_cost::check::{Compared, compare};
use experiments::accuracy_cost::kept::Kept;
use experiments::accuracy_cost::sheet::POINTS;
use experiments::accuracy_cost::{Extent, Measured, Times};
use experiments::pages::Purpose;
use std::fs;
use std::path::{Path, PathBuf};

/// The cost of accuracy: error, bytes and time as every parameter varies
///
/// --out writes DIR/accuracy-cost.md, the numbers as CSV and the charts as SVG: errors against the
/// direct sum over the shipped lights and materials and over others, errors of a degree and an
/// order against direct integration under captured maps, times on this machine, and the
/// instructions that were counted on emulated boards. --check recomputes errors, bytes and counts
/// and compares them with the files of a folder; times are not compared. --quick does either for a
/// part of the settings. A full run takes some ten minutes on two cores, a quick check one minute.
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
    /// Folder of the project's environment maps
    #[arg(long, value_name = "DIR", default_value = "tables/inputs/maps")]
    maps: PathBuf,
}

impl AccuracyCost {
    pub fn run(self) -> Result<()> {
        // Done first, so that paths that cannot be read or written fail before the long
        // computation.
        if let Some(out) = &self.purpose.out {
            fs::create_dir_all(out).map_err(|error| Error::io(out, &error))?;
        }
        if let Some(folder) = &self.purpose.check {
            let numbers = folder.join(POINTS);
            fs::metadata(&numbers).map_err(|error| Error::io(&numbers, &error))?;
        }
        let kept = match &self.purpose.out {
            Some(out) if self.keep_times => Some(Kept::read(out)?),
            _ => None,
        };
        let times = match &kept {
            Some(kept) => Times::Kept(kept),
            None if self.purpose.out.is_some() => Times::Measured,
            None => Times::None,
        };
        let extent = Extent { quick: self.quick, times };
        let progress = progress_bar("settings", 0);
        let measured = Measured::new(extent, &self.maps, &progress);
        progress.finish_and_clear();
        let measured = measured?;
        if let Some(out) = &self.purpose.out {
            write(&measured, out)?;
        }
        if let Some(folder) = &self.purpose.check {
            let sheets = measured.sheets()?;
            let Compared { rows, numbers } =
                compare(&sheets, &measured.growths, folder, !self.quick)?;
            print_message(format_args!("{rows} rows are what they should be: {numbers} numbers"));
        }
        Ok(())
    }
}

fn write(measured: &Measured, out: &Path) -> Result<()> {
    let files = measured.files()?;
    let paths: Vec<PathBuf> = files.iter().map(|(name, _)| out.join(name)).collect();
    output::refuse_collisions(&paths, std::iter::empty::<&Path>())?;
    for ((_, text), path) in files.iter().zip(&paths) {
        output::write_all(Some(path), text)?;
    }
    print_message(format_args!(
        "{} settings, {} files in {}",
        measured.points.len(),
        files.len(),
        out.display()
    ));
    Ok(())
}
