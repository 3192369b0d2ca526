//! The total errors of the shipped materials in color, and of PTFE.

use super::{inputs, write_command_line};
use eigenshade_cli::messages::progress_bar;
use eigenshade_cli::output::{self, Rows};
use eigenshade_model::error::Result;
use eigenshade_shading::shipped::ERROR_SIZES;
use experiments::material_errors::{self, Errors, SPACING};
use std::path::Path;

pub fn run(out: Option<&Path>) -> Result<()> {
    let found = material_errors::errors(inputs(), &[], SPACING, &progress_bar("materials", 0))?;
    output::write(out, |out| {
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
