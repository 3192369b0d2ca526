//! `eigenshade material`: measured BRDFs to coefficients.

use super::count;
use clap::Args;
use eigenshade_cli::message::{bar, say};
use eigenshade_cli::{destination, invocation};
use eigenshade_generator::error::Result;
use eigenshade_generator::inputs::coefficient_csv::write_materials;
use eigenshade_generator::inputs::fit::{Fit, fit, write_figures};
use eigenshade_generator::inputs::measurements::read_material_path;
use std::io::Write;
use std::path::PathBuf;

/// Material coefficients fitted to measured BRDFs
///
/// Writes the CSV `name,o,p,q,r,g,b` (`name,o,p,q,value` if all are grey). On
/// standard error stands how good each fit is: the residual relative to the
/// measurements, the range of the fitted values relative to the largest measured
/// one, and the condition number. A file that --out or --report names begins with a
/// comment line, `#` and the command.
#[derive(Args, Debug)]
pub struct Material {
    /// A CUReT folder (abrdf.dat, table.txt), a CSV
    /// `theta_i,phi_i,theta_r,phi_r,r,g,b`, or a folder of such CSVs; several are
    /// put together
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,
    /// Largest order o of the coefficients, 0 to 64
    #[arg(long, value_name = "O", value_parser = count(0, 64))]
    order: usize,
    /// Where the CSV goes, instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Also writes how good the fits are:
    /// `name,samples,maximum,residual,lowest,highest,condition`, the maximum in 1/sr
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

impl Material {
    pub fn run(self) -> Result<()> {
        let mut measured = Vec::new();
        for path in &self.paths {
            measured.extend(read_material_path(path)?);
        }
        let progress = bar("fits", measured.len());
        let (materials, fits) =
            fit(&measured, self.order, &mut |done, _| progress.set_position(done as u64))?;
        progress.finish_and_clear();
        for fit in &fits {
            say(line(fit));
        }
        let by_command = |out: &mut dyn Write, is_file: bool| {
            if is_file {
                writeln!(out, "# {}", invocation::command_line())
                    .map_err(|error| destination::fault(&error))?;
            }
            Ok(())
        };
        destination::write(self.out.as_deref(), |out| {
            by_command(out, self.out.is_some())?;
            write_materials(&materials, out)
        })?;
        self.report.as_deref().map_or(Ok(()), |path| {
            destination::write(Some(path), |out| {
                by_command(out, true)?;
                write_figures(&fits, out)
            })
        })
    }
}

fn line(fit: &Fit) -> String {
    format!(
        "{}: {} samples, residual {:.4}, range {:.3} to {:.3}, condition {:.1}",
        fit.material.name, fit.samples, fit.residual, fit.lowest, fit.highest, fit.condition
    )
}
