//! `eigenshade material`: converts measured, tabulated or analytic BRDFs to coefficients.

use super::material_formula::{Formula, Nearness};
use super::{Memory, count};
use clap::Args;
use eigenshade_cli::notes::albedo;
use eigenshade_cli::output::message::{bar, say};
use eigenshade_cli::output::{collision, destination, invocation};
use eigenshade_generator::material;
use eigenshade_generator::material::brdf::{Measure, Projected};
use eigenshade_generator::material::files::Source;
use eigenshade_generator::material::fit::{Fit, LOWEST, fit, write_figures};
use eigenshade_model::database::{Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_materials;
use eigenshade_shading::parallel;
use std::collections::HashSet;
use std::io::Write;
use std::path::PathBuf;

/// Convert BRDFs (measurements, tables or formulas) to material coefficients
///
/// Writes the CSV `name,o,p,q,r,g,b` (`name,o,p,q,value` if all are gray). Measurements are fitted.
/// For each fit, standard error shows the residual relative to the measurements, the range of the
/// fitted values relative to the largest measured one, and the condition number. MERL files and
/// formulas are projected by quadrature. For each projection, standard error shows the share of the
/// energy, f^2 cos theta_i cos theta_r over both hemispheres, that the order leaves out. The files
/// of --out and --report begin with a comment line, `#` and the command.
#[derive(Args, Debug)]
#[command(args_conflicts_with_subcommands = true, subcommand_negates_reqs = true)]
pub struct Material {
    #[command(subcommand)]
    formula: Option<Formula>,
    /// A CUReT folder (abrdf.dat, table.txt), a CSV
    /// `theta_i,phi_i,theta_r,phi_r,r,g,b`, a MERL .binary, a .toml of formulas, or a
    /// folder of such files; several are combined
    #[arg(value_name = "PATH", required = true)]
    paths: Vec<PathBuf>,
    /// Largest order o of the coefficients, 0 to 64
    #[arg(long, value_name = "O", value_parser = count(0, 64), required = true)]
    order: Option<usize>,
    /// Measure under which projected coefficients approximate the function best
    #[arg(long, value_enum, default_value_t)]
    measure: Nearness,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Also write the quality of the fits to this file:
    /// `name,samples,maximum,residual,lowest,highest,condition`, the maximum in 1/sr
    #[arg(long, value_name = "FILE")]
    report: Option<PathBuf>,
}

impl Material {
    pub fn run(self, memory: Memory) -> Result<()> {
        let (sources, order, measure, out) = match self.formula {
            Some(formula) => {
                let (surface, answer) = formula.surface()?;
                (vec![Source::Surface(surface)], answer.order, answer.measure, answer.out)
            }
            None => {
                let inputs = self.paths.iter().flat_map(|path| material::files::files(path));
                collision::refuse([&self.out, &self.report].into_iter().flatten(), inputs)?;
                let mut sources = Vec::new();
                for path in &self.paths {
                    sources.extend(material::files::read(memory.file(path))?);
                }
                (sources, self.order.unwrap_or_default(), self.measure, self.out)
            }
        };
        let negative = negative_values(&sources);
        let (materials, fits) = coefficients(sources, order, measure.into())?;
        let by_command = |out: &mut dyn Write, is_file: bool| {
            if is_file {
                writeln!(out, "# {}", invocation::command_line())
                    .map_err(|error| destination::fault(&error))?;
            }
            Ok(())
        };
        destination::write(out.as_deref(), |to| {
            by_command(to, out.is_some())?;
            write_materials(&materials, to)
        })?;
        if let Some(path) = &self.report {
            destination::write(Some(path), |out| {
                by_command(out, true)?;
                write_figures(&fits, out)
            })?;
        }
        albedo::warning(&materials).into_iter().chain(negative).for_each(say);
        Ok(())
    }
}

/// The coefficients of all sources, in order, and the fits among them.
fn coefficients(
    sources: Vec<Source>,
    order: usize,
    measure: Measure,
) -> Result<(Materials, Vec<Fit>)> {
    let mut names = HashSet::new();
    if let Some(source) = sources.iter().find(|source| !names.insert(source.name())) {
        return Err(Error::new(
            format!("two materials are called `{}`", source.name()),
            "rename one of the two",
        ));
    }
    let (mut measured, mut surfaces, mut places) = (Vec::new(), Vec::new(), Vec::new());
    for source in sources {
        places.push(matches!(source, Source::Measured(_)));
        match source {
            Source::Measured(samples) => measured.push(samples),
            Source::Surface(surface) => surfaces.push(surface),
        }
    }
    let progress = bar("fits", measured.len());
    let (_, fits) = fit(&measured, order, &mut |done, _| progress.set_position(done as u64))?;
    progress.finish_and_clear();
    let progress = bar("projections", surfaces.len());
    let projected: Vec<Projected> =
        parallel::map(surfaces.len(), &progress, |k| surfaces[k].project(order, measure));
    progress.finish_and_clear();
    for fit in &fits {
        say(fit_line(fit));
    }
    for one in &projected {
        let (name, left) = (&one.material.name, one.left_out);
        say(format_args!("{name}: order {order} leaves out {left:.2e} of the energy"));
    }
    let (mut fitted, mut others) = (
        fits.iter().map(|fit| fit.material.clone()),
        projected.into_iter().map(|one| one.material),
    );
    let entries: Vec<Named> = places
        .into_iter()
        .filter_map(|is_fit| if is_fit { fitted.next() } else { others.next() })
        .collect();
    Ok((Materials { order, entries }, fits))
}

/// A warning of measurements that are further below zero than a fit may be.
fn negative_values(sources: &[Source]) -> Option<String> {
    let range = |source: &Source| {
        let Source::Measured(measured) = source else { return None };
        let values = measured.samples.iter().flat_map(|sample| sample.rgb);
        let (lowest, highest) = values.fold((0.0f64, 0.0f64), |(a, b), v| (a.min(v), b.max(v)));
        (lowest < LOWEST * highest).then(|| (measured.name.clone(), lowest, highest))
    };
    let found: Vec<(String, f64, f64)> = sources.iter().filter_map(range).collect();
    let (name, lowest, highest) =
        found.iter().min_by(|a, b| (a.1 / a.2).total_cmp(&(b.1 / b.2)))?;
    let (count, all) = (found.len(), sources.len());
    Some(format!(
        "warning: material `{name}` has measurements down to {lowest:.4}, where the largest is \
         {highest:.4} ({count} of {all} materials are as negative): no BRDF is below zero but for \
         noise"
    ))
}

fn fit_line(fit: &Fit) -> String {
    format!(
        "{}: {} samples, residual {:.4}, range {:.3} to {:.3}, condition {:.1}",
        fit.material.name, fit.samples, fit.residual, fit.lowest, fit.highest, fit.condition
    )
}
