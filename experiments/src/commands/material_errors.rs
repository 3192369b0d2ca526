//! The total errors of the shipped materials in color, and of PTFE.

use super::{inputs, write_command_line};
use clap::Args;
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::output::{self, Rows};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped::ERROR_SIZES;
use experiments::material_errors::{self, Errors, SPACING};
use std::path::PathBuf;

/// Total errors of the shipped materials, tables/inputs/merl.errors.csv
///
/// The reference is direct integration of each BRDF under the environment maps, without degree or
/// order; PTFE, which was measured, is its own coefficients. The error of a map is the rms over a
/// sphere's picture and the channels, relative to the picture's peak. The CSV has its median and
/// its worst over the maps, the map of the worst, and the largest error of any pixel under any map,
/// for the coefficients that are shipped at 9/7 and for the same at 12/12. The normals are evenly
/// spaced ones, and others that mirror the lamps of the maps. Takes some ten minutes on two cores.
#[derive(Args, Debug)]
pub struct MaterialErrors {
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl MaterialErrors {
    pub fn run(self) -> Result<()> {
        let found = material_errors::errors(inputs(), &[], SPACING, &progress_bar("materials", 0))?;
        output::write(self.out.as_deref(), |out| {
            write_command_line(out)?;
            let mut rows = Rows::new(out, material_errors::COLUMNS)?;
            for (name, errors) in &found {
                for ((degree, order), Errors { median, worst, map, pixel }) in
                    ERROR_SIZES.iter().zip(errors)
                {
                    rows.row([
                        name.clone(),
                        degree.to_string(),
                        order.to_string(),
                        format!("{median:.5}"),
                        format!("{worst:.5}"),
                        map.clone(),
                        format!("{pixel:.4}"),
                    ])?;
                }
            }
            rows.finish()
        })
    }
}
