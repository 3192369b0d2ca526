//! `eigenshade basis`: makes a table from a scene file.

use super::object_scene::ObjectScene;
use super::options::input_file;
use clap::Args;
use eigenshade_cli::messages::{albedo_warning, grouped, print_message, spinner};
use eigenshade_cli::output;
use eigenshade_cli::table::compare::{Difference, differences};
use eigenshade_cli::table::{self, rounding};
use eigenshade_generator::basis::estimate::Estimate;
use eigenshade_generator::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::writable;
use eigenshade_shading::shader::of_higher_order;
use eigenshade_table::file::manifest;
use eigenshade_table::wire::NumberFormat;
use eigenshade_table::{Table, encode};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// The ending of a table's manifest.
const MANIFEST: &str = "manifest.csv";

/// Make the table of a scene: its eigenimages
///
/// A scene with `geometry.object` becomes an object with shadows, as `pack-object --shadows` writes it.
///
/// The command estimates its memory first, and refuses a table that would take more than 8 GiB. If
/// the scene has a tolerance, standard error reports the choice for it. With `--out B.bin`, it
/// writes the table to B.bin and its manifest to B.manifest.csv. --check makes the table again and
/// compares eigenvalues, profiles, mode means, rows of U^T M and the images A U, each to 1e-9 of its
/// largest number. Terms that only one of two polynomials has may be as large as profile_tolerance
/// allows.
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
    #[arg(short, long, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Compare this table with a new one
    #[arg(long, value_name = "FILE")]
    check: Option<PathBuf>,
}

impl Basis {
    pub fn run(self) -> Result<()> {
        let scene = input_file(&self.scene).with_text()?;
        if let Some(object) = ObjectScene::read(&scene)? {
            let Some(out) = &self.purpose.out else {
                let what = "--check is for tables, and the scene has an object with shadows";
                return Err(Error::new(what, "pack it again with --out").in_file(&self.scene));
            };
            return object.pack(&scene, out);
        }
        if let Some(path) = &self.purpose.out {
            let inputs = scene_file::inputs(&self.scene);
            output::refuse_collisions([path, &path.with_extension(MANIFEST)], inputs)?;
            writable(path)?;
            writable(&path.with_extension(MANIFEST))?;
        }
        // Read first, so that a broken table is reported before the new one is made.
        let old = match &self.purpose.check {
            Some(path) => Some((path, table::read(input_file(path))?)),
            None => None,
        };
        let start = Instant::now();
        let progress = spinner("eigenimages");
        let loaded = scene_file::load(scene)?;
        let estimate = Estimate::of(&loaded);
        estimate.check().map_err(|error| error.in_file(&self.scene))?;
        if let Some(time) = estimate.minutes() {
            progress.suspend(|| print_message(format_args!("this takes {time} or less")));
        }
        let chosen = loaded.chosen();
        progress.finish_and_clear();
        let (mut table, choice) = chosen.map_err(|error| error.in_file(&self.scene))?;
        choice.iter().for_each(|choice| choice.to_string().lines().for_each(print_message));
        if let Some((path, old)) = old {
            return check(&self.scene, path, &old, &table);
        }
        table.summary.roundings =
            rounding::measure(&table, &loaded.lights, &loaded.materials, &NumberFormat::ALL);
        let bytes = encode(&table);
        if let Some(path) = &self.purpose.out {
            output::write_all(Some(path), &bytes)?;
            output::write_all(Some(&path.with_extension(MANIFEST)), manifest(&table))?;
        }
        let folder = self.scene.parent().unwrap_or(Path::new("."));
        let database = folder.join(loaded.scene.material.database.join(", "));
        let order = loaded.scene.material.order;
        let warnings = [
            of_higher_order((&database, false), loaded.order_of_file, order),
            albedo_warning(&loaded.materials),
            rounding::warning(&table, NumberFormat::F32),
        ];
        warnings.into_iter().flatten().for_each(print_message);
        output::report(report(&table, bytes.len(), start.elapsed()))
    }
}

fn report(table: &Table, bytes: usize, time: Duration) -> String {
    let summary = &table.summary;
    let both_signs = |(azimuth, rank): (usize, &usize)| if azimuth == 0 { *rank } else { 2 * rank };
    let rank: usize = summary.ranks.iter().enumerate().map(both_signs).sum();
    let (found, requested) = (table.count(), table.scene.basis.components);
    let fewer = match requested {
        Some(requested) if requested > found => {
            format!(" of {requested} requested: there are no more")
        }
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
        let (what, found, allowed) = (one.what, one.found, one.allowed);
        let _ = writeln!(text, "{what:<24} {found:>9.1e} of {allowed:.0e} allowed{verdict}");
    }
    output::report(&text)?;
    let over: Vec<&str> =
        found.iter().filter(|one| one.is_over()).map(|one: &Difference| one.what).collect();
    if over.is_empty() {
        return Ok(());
    }
    let what = format!("it is not the table of the scene: {} differ", over.join(", "));
    Err(Error::new(what, remedy).in_file(path))
}
