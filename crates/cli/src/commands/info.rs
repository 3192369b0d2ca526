//! `eigenshade info` and `eigenshade eigenvalues`: describe a table.

use super::options::Memory;
use clap::Args;
use eigenshade_cli::messages::{grouped, printable};
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_cli::table;
use eigenshade_model::error::Result;
use eigenshade_table::Table;
use eigenshade_table::file::manifest;
use eigenshade_table::scene::{Cut, Store};
use std::fmt::Write;
use std::path::PathBuf;

/// Describe a table: scene, orders, components, rank, energy, sections and bytes
///
/// For a wire file, which `pack` writes: version, format, orders, components, sections and bytes.
#[derive(Args, Debug)]
pub struct Info {
    /// Table or wire file
    #[arg(value_name = "B.bin")]
    table: PathBuf,
}

impl Info {
    pub fn run(self, memory: Memory) -> Result<()> {
        let bytes = memory.file(&self.table).bytes()?;
        let text = if table::is_wire(&bytes) {
            table::wire_description(&bytes)
        } else {
            table::decode(&bytes).map(|table| description(&table))
        };
        let text = text.map_err(|error| error.in_file(&self.table))?;
        output::write_all(None, &text)
    }
}

/// Write the eigenvalues of a table, as CSV `criterion,index,m,eigenvalue`
///
/// Includes the eigenvalues of components that the table does not keep. The constant of the
/// image-centered criterion, index 0, has none: its field is empty.
#[derive(Args, Debug)]
pub struct Eigenvalues {
    /// The table
    #[arg(value_name = "B.bin")]
    table: PathBuf,
    /// Write the CSV to this file instead of standard output
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
}

impl Eigenvalues {
    pub fn run(self, memory: Memory) -> Result<()> {
        output::refuse_collisions(&self.out, [&self.table])?;
        let table = table::read(memory.file(&self.table))?;
        let criterion = table.scene.basis.criterion.name();
        output::write(self.out.as_deref(), |out| {
            let mut rows = Rows::new(out, ["criterion", "index", "m", "eigenvalue"])?;
            for (index, (m, value)) in table.spectrum.iter().enumerate() {
                let value = value.map(exact).unwrap_or_default();
                let m = m.map(|m| m.to_string()).unwrap_or_default();
                rows.row([criterion, &index.to_string(), &m, &value])?;
            }
            rows.finish()
        })
    }
}

fn description(table: &Table) -> String {
    let scene = &table.scene;
    let names = match scene.material.names.len() {
        0 => "all".to_owned(),
        _ => scene.material.names.join(" "),
    };
    let mut requested = match (scene.basis.components, scene.basis.tolerance) {
        (Some(count), _) => format!("{count} components"),
        (None, Some(tolerance)) => format!("tolerance {tolerance:e}"),
        (None, None) => "all components".to_owned(),
    };
    if let Some(cut) = scene.basis.cut.filter(|&cut| cut != Cut::default()) {
        requested.push_str(&format!(", {cut}"));
    }
    let lines = [
        ("normals", scene.geometry.normals.clone()),
        ("light", scene.light.database.clone()),
        ("rotation", format!("{:?}", scene.light.rotation).to_lowercase()),
        ("material", format!("{}, {names}", scene.material.database.join(" "))),
        ("criterion", scene.basis.criterion.name().to_owned()),
        ("requested", requested),
        ("modes", eigenshade_index::mode::total(table.gram.degree, table.gram.order).to_string()),
        ("kept modes", kept_modes(table)),
        ("effects", effects(table)),
        ("store", stored(table).to_owned()),
        ("profiles", table.profiles.len().to_string()),
        ("spectrum", table.spectrum.len().to_string()),
        ("nodes", table.gram.nodes.len().to_string()),
    ];
    let mut text = String::new();
    for (what, value) in lines {
        let _ = writeln!(text, "{what:<24} {}", printable(&value));
    }
    for line in manifest(table, "").lines().skip(2) {
        let mut fields = line.split(',');
        let (Some(entry), Some(value)) = (fields.next(), fields.next()) else {
            continue;
        };
        let bytes = fields.next().and_then(|bytes| bytes.parse().ok());
        let _ = match bytes {
            Some(bytes) => writeln!(text, "{entry:<24} {:>9} bytes", grouped(bytes)),
            None => writeln!(text, "{entry:<24} {}", printable(value)),
        };
    }
    text
}

/// The effects, and whether color or rotation is left out.
fn effects(table: &Table) -> String {
    let effects = &table.scene.effects;
    let color = if effects.color { "" } else { ", no color" };
    let rotation = if effects.rotation { "" } else { ", fixed light" };
    table::effect_names(table.effects()) + color + rotation
}

/// The part of the basis that the table keeps.
fn stored(table: &Table) -> &'static str {
    match table.scene.basis.store {
        Store::Modes => "U over modes, the factors of U^T M",
        Store::Projection => "the factors of U^T M; U over modes is derived again from the scene",
        Store::Materials => {
            "the transfers of the scene's materials; U and U^T M are derived again from the scene"
        }
    }
}

fn kept_modes(table: &Table) -> String {
    if table.selection.is_empty() && table.effects().is_all() {
        return "all".to_owned();
    }
    let (degree, order) = (table.gram.degree, table.gram.order);
    let kept = (0..=degree).map(|azimuth| {
        let modes = eigenshade_index::mode::indices(degree, order, azimuth);
        let count = modes.filter(|&(l, o, p, q)| table.keeps(azimuth, l, o, p, q)).count();
        if azimuth == 0 { count } else { 2 * count }
    });
    kept.sum::<usize>().to_string()
}
