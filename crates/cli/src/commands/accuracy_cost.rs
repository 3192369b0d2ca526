//! `eigenshade accuracy-cost`.

use clap::Args;
use eigenshade_cli::accuracy_cost::{model, points, sheet};
use eigenshade_cli::destination;
use eigenshade_cli::message::{bar, say};
use eigenshade_generator::error::Result;
use std::path::PathBuf;

/// trial
#[derive(Args, Debug)]
pub struct AccuracyCost {
    #[arg(long, value_name = "DIR")]
    out: PathBuf,
    #[arg(long)]
    quick: bool,
    #[arg(long, value_name = "DIR", default_value = "tables/inputs/maps")]
    maps: PathBuf,
}

impl AccuracyCost {
    pub fn run(self) -> Result<()> {
        let start = std::time::Instant::now();
        let progress = bar("settings", 0);
        let models = model::rows(&self.maps, self.quick, &progress)?;
        say(format_args!("models {:?}", start.elapsed()));
        std::fs::create_dir_all(&self.out).ok();
        destination::write_text(Some(&self.out.join(sheet::MODEL)), &sheet::model(&models)?)?;
        let found = points::measure(self.quick, true, &models, &progress)?;
        say(format_args!("points {:?}", start.elapsed()));
        destination::write_text(Some(&self.out.join(sheet::POINTS)), &sheet::points(&found)?)?;
        Ok(())
    }
}
