//! `eigenshade basis`: makes a table from a scene file.

use super::Memory;
use clap::Args;
use eigenshade_cli::notes::albedo;
use eigenshade_cli::output::message::{say, spinner};
use eigenshade_cli::output::number::grouped;
use eigenshade_cli::output::{collision, destination, invocation};
use eigenshade_cli::table::compare::{Difference, differences};
use eigenshade_cli::table::recorded_errors::manifest_rows;
use eigenshade_cli::table::{rounding, table_file};
use eigenshade_generator::basis::estimate::Estimate;
use eigenshade_generator::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::{writable, write_atomically};
use eigenshade_shading::shader::of_higher_order;
use eigenshade_table::file::manifest;
use eigenshade_table::wire::Format;
use eigenshade_table::{Table, encode};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The ending of a table's manifest.
const MANIFEST: &str = "manifest.csv";

/// The ending of the file of a table's recorded errors.
const ERRORS: &str = "errors.csv";

/// Make the table of a scene: its eigenimages
///
/// Memory is estimated first, and a table that would take more than --memory is refused. If the
/// scene has a tolerance, the choice for it is reported on standard error. --out writes the table
/// and its manifest, B.manifest.csv. Errors recorded in B.errors.csv are repeated in the manifest,
/// and refused if they belong to another table. --check makes the table again and compares
/// eigenvalues, profiles, mode means, rows of U^T M and the images A U, each to 1e-9 of its largest
/// number. Terms that only one of two polynomials has may be as large as profile_tolerance allows.
#[derive(Args, Debug)]
pub struct Basis {
    /// Scene file; paths in it are relative to the file
    #[arg(long, value_name = "FILE")]
    scene: PathBuf,
    #[command(flatten)]
    purpose: Purpose,
}

#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
struct Purpose {
    /// Write the table to this file
    #[arg(long, value_name = "B.bin")]
    out: Option<PathBuf>,
    /// Compare this table with a new one
    #[arg(long, value_name = "B.bin")]
    check: Option<PathBuf>,
}

impl Basis {
    pub fn run(self, memory: Memory) -> Result<()> {
        if let Some(path) = &self.purpose.out {
            let mut inputs = scene_file::inputs(&self.scene);
            inputs.push(path.with_extension(ERRORS));
            collision::refuse([path, &path.with_extension(MANIFEST)], inputs)?;
            writable(path)?;
            writable(&path.with_extension(MANIFEST))?;
        }
        // Read first: a broken table need not wait for a good one.
        let old = match &self.purpose.check {
            Some(path) => Some((path, table_file::read(memory.file(path))?)),
            None => None,
        };
        let start = Instant::now();
        let progress = spinner("eigenimages");
        let loaded = scene_file::load(memory.file(&self.scene))?;
        let estimate = Estimate::of(&loaded);
        estimate.admit(memory.of_basis()).map_err(|error| error.in_file(&self.scene))?;
        if let Some(time) = estimate.minutes() {
            progress.suspend(|| say(format_args!("this takes {time} or less")));
        }
        let chosen = loaded.chosen();
        progress.finish_and_clear();
        let (mut table, choice) = chosen.map_err(|error| error.in_file(&self.scene))?;
        choice.iter().for_each(|choice| choice.to_string().lines().for_each(say));
        if let Some((path, old)) = old {
            return check(&self.scene, path, &old, &table);
        }
        table.summary.roundings = rounding::measure(&table, &loaded.lights, &loaded.materials);
        let errors = match &self.purpose.out {
            Some(path) => manifest_rows(&path.with_extension(ERRORS), &table, &loaded)?,
            None => String::new(),
        };
        let bytes = encode(&table);
        if let Some(path) = &self.purpose.out {
            let put = |path: &Path, bytes: &[u8]| {
                write_atomically(path, |out| {
                    out.write_all(bytes).map_err(|error| destination::fault(&error))
                })
            };
            put(path, &bytes)?;
            let text = manifest(&table, &invocation::command_line());
            let text = text + &errors;
            put(&path.with_extension(MANIFEST), text.as_bytes())?;
        }
        let database = self.scene.parent().unwrap_or(Path::new("."));
        let database = database.join(&loaded.scene.material.database);
        let order = loaded.scene.material.order;
        let warnings = [
            of_higher_order(&database, loaded.order_of_file, order),
            albedo::warning(&loaded.materials),
            rounding::warning(&table, Format::F32),
        ];
        warnings.into_iter().flatten().for_each(say);
        destination::write_text(None, &report(&table, bytes.len(), start.elapsed()))
    }
}

/// A summary of the table.
fn report(table: &Table, bytes: usize, time: Duration) -> String {
    let summary = &table.summary;
    let both_signs = |(azimuth, rank): (usize, &usize)| if azimuth == 0 { *rank } else { 2 * rank };
    let of_sphere: usize = summary.ranks.iter().enumerate().map(both_signs).sum();
    let rank = table.general.as_ref().map_or(of_sphere, |general| general.rank);
    let (found, asked) = (table.count(), table.scene.basis.components);
    let fewer = match asked {
        Some(asked) if asked > found => format!(" of {asked} asked for: there are no more"),
        _ => String::new(),
    };
    let mut text = String::new();
    let lines = [
        ("rank", rank.to_string()),
        ("components", format!("{found}{fewer}")),
        ("energy kept", format!("{:.9}", summary.energy_kept)),
        ("bytes", grouped(bytes)),
        ("time", format!("{:.2} s", time.as_secs_f64())),
    ];
    for (what, value) in lines {
        let _ = writeln!(text, "{what:<12} {value}");
    }
    text
}

fn check(scene: &Path, path: &Path, old: &Table, new: &Table) -> Result<()> {
    let remedy = format!(
        "make it again with `eigenshade basis --scene {} --out {}`",
        scene.display(),
        path.display()
    );
    let found =
        differences(old, new).map_err(|what| Error::new(what, remedy.clone()).in_file(path))?;
    let mut text = String::new();
    for one in &found {
        let verdict = if one.is_over() { "  OVER" } else { "" };
        let (what, apart, allowed) = (one.what, one.found, one.allowed);
        let _ = writeln!(text, "{what:<24} {apart:>9.1e} of {allowed:.0e} allowed{verdict}");
    }
    destination::write_text(None, &text)?;
    let over: Vec<&str> =
        found.iter().filter(|one| one.is_over()).map(|one: &Difference| one.what).collect();
    if over.is_empty() {
        return Ok(());
    }
    let what = format!("it is not what the scene gives: {} differ", over.join(", "));
    Err(Error::new(what, remedy).in_file(path))
}
