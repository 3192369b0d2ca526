//! `eigenshade info`: describes a table or a packed object. `eigenshade eigenvalues`: its eigenvalues.

use super::options::{Destination, TableChoice, input_file};
use clap::Args;
use eigenshade_cli::description::Description;
use eigenshade_cli::{object_description, output, table};
use eigenshade_model::error::Result;
use eigenshade_table::Table;
use eigenshade_table::file::manifest;
use eigenshade_table::scene::Store;
use serde::Serialize;

/// Describe a table: scene, orders, components, rank, energy, sections and bytes
///
/// For an object that `pack-object` or `basis` packed: pixels, and bytes of each section; with shadows
/// also degree, rank, codes and clusters.
///
/// For a wire file, which `pack` writes: version, byte order, format, orders, components, sections
/// and bytes, and the lengths of buffers if the byte order is that of this machine.
#[derive(Args, Debug)]
pub struct Info {
    #[command(flatten)]
    table: TableChoice,
    /// Write a JSON object
    #[arg(long)]
    json: bool,
}

impl Info {
    pub fn run(self) -> Result<()> {
        let bytes = table::bytes(&input_file(self.table.path()))?;
        let found = if table::is_wire(&bytes) {
            table::wire_description(&bytes)
        } else if let Some(of_object) = object_description::description(&bytes) {
            of_object
        } else {
            table::decode(&bytes).map(|table| description(&table))
        };
        let found = found.map_err(|error| error.in_file(self.table.path()))?;
        if self.json {
            output::write_json(None, &found)
        } else {
            output::write_all(None, found.to_string())
        }
    }
}

/// Write the eigenvalues of a table, as CSV `criterion,index,m,eigenvalue`
///
/// Includes the eigenvalues of components that the table does not keep. The constant of the
/// image-centered criterion, index 0, has none: its field is empty.
#[derive(Args, Debug)]
pub struct Eigenvalues {
    #[command(flatten)]
    table: TableChoice,
    /// Write a JSON array of objects
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    out: Destination,
}

#[derive(Serialize)]
struct Eigenvalue {
    criterion: &'static str,
    index: usize,
    m: i32,
    eigenvalue: Option<f64>,
}

impl Eigenvalues {
    pub fn run(self) -> Result<()> {
        output::refuse_collisions(&self.out.path, [self.table.path()])?;
        let table = self.table.read()?;
        let criterion = table.scene.basis.criterion.name();
        let of = |(index, &(m, eigenvalue))| Eigenvalue { criterion, index, m, eigenvalue };
        let rows: Vec<Eigenvalue> = table.spectrum.iter().enumerate().map(of).collect();
        output::write_records(self.out.path.as_deref(), self.json, &rows)
    }
}

fn description(table: &Table) -> Description {
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
    if let Some(share) = scene.basis.trim {
        requested.push_str(&format!(", trimmed to {share:e}"));
    }
    let modes = eigenshade_table::mode::total(table.gram.degree, table.gram.order);
    let mut found = Description::default();
    found.field("light", &scene.light.database);
    found.field("material", format!("{}, {names}", scene.material.database.join(" ")));
    found.field("criterion", scene.basis.criterion.name());
    found.field("requested", requested);
    found.field("modes", modes);
    found.field("kept modes", kept_modes(table));
    found.field("effects", effects(table));
    found.field("stored", stored(table));
    found.field("profiles", table.profiles.len());
    found.field("terms", table.terms());
    found.field("spectrum", table.spectrum.len());
    found.field("nodes", table.gram.nodes.len());
    for line in manifest(table).lines().skip(1) {
        let fields: Vec<&str> = line.split(',').collect();
        match fields[..] {
            [name, "", bytes, _] => found.part(name, bytes.parse().unwrap_or_default()),
            [name, value, ..] => found.field(name, value),
            _ => {}
        }
    }
    found
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
        let modes = eigenshade_table::mode::indices(degree, order, azimuth);
        let count = modes.filter(|&(l, o, p, q)| table.keeps(azimuth, l, o, p, q)).count();
        if azimuth == 0 { count } else { 2 * count }
    });
    kept.sum::<usize>().to_string()
}
