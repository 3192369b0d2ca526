//! The manifest of a table: a summary of its content, which makes a change of data visible as a
//! readable diff.

use crate::file::{encode, section};
use crate::scene::Scene;
use crate::table::Table;
use std::fmt::Write;

/// A CSV of `entry,value,bytes,crc32`. Sections have their size in bytes and a checksum of their
/// encoded values in the file; figures have values.
///
/// The first line is a comment with `command`.
#[must_use]
pub fn manifest(table: &Table, command: &str) -> String {
    let mut text = format!("# {command}\nentry,value,bytes,crc32\n");
    let gram = &table.gram;
    let of_profiles = |part: fn(&crate::Profile) -> &Vec<f64>| {
        section(&table.profiles.iter().map(part).collect::<Vec<_>>())
    };
    let sections = [
        ("scene", section(&table.scene)),
        ("gram.nodes", section(&gram.nodes)),
        ("gram.root_weights", section(&gram.root_weights)),
        ("gram.gains", section(&gram.gains)),
        ("gram.polar_integrals", section(&gram.polar_integrals)),
        ("gram.radials", section(&gram.radials)),
        ("gram.rotations", section(&gram.rotations)),
        ("selection", section(&table.selection)),
        ("components", section(&table.components)),
        ("profiles.node_values", of_profiles(|profile| &profile.node_values)),
        ("profiles.chebyshev", of_profiles(|profile| &profile.chebyshev)),
        ("profiles.modes", of_profiles(|profile| &profile.modes)),
        ("profiles.factors", of_profiles(|profile| &profile.factors)),
        ("mean", section(&table.mean)),
        ("spectrum", section(&table.spectrum)),
        ("general", section(&table.general)),
        ("transfers", section(&table.transfers)),
        ("file", encode(table)),
    ];
    for (entry, bytes) in sections {
        row(&mut text, format_args!("{entry},,{},{:08x}", bytes.len(), crc32fast::hash(&bytes)));
    }
    let summary = &table.summary;
    let per_azimuth: Vec<String> = summary.ranks.iter().map(ToString::to_string).collect();
    let total: usize =
        summary.ranks.iter().enumerate().map(|(m, rank)| rank * if m == 0 { 1 } else { 2 }).sum();
    let figures = [
        ("degree", gram.degree.to_string()),
        ("order", gram.order.to_string()),
        ("lights", summary.lights.to_string()),
        ("materials", summary.materials.to_string()),
        ("store", table.scene.basis.store.name().to_owned()),
        ("components", table.count().to_string()),
        ("span", table.general.as_ref().map_or(0, |_| table.components.len()).to_string()),
        ("rank", table.general.as_ref().map_or(total, |general| general.rank).to_string()),
        ("rank of each |m|", per_azimuth.join(" ")),
        ("largest singular value", format!("{:.6e}", summary.largest_singular_value)),
        ("energy kept", format!("{:.9}", summary.energy_kept)),
        ("residual energy", format!("{:.3e}", 1.0 - summary.energy_kept)),
        ("orthonormality", format!("{:.0e}", summary.orthonormality)),
    ];
    for (entry, value) in figures {
        row(&mut text, format_args!("{entry},{value},,"));
    }
    for one in &summary.roundings {
        let format = one.format.name();
        row(&mut text, format_args!("largest error in {format},{:.1e},,", one.largest));
        row(&mut text, format_args!("rms error in {format},{:.1e},,", one.rms));
    }
    text
}

/// The checksum of a scene in a manifest; the same on every host.
#[must_use]
pub fn scene_checksum(scene: &Scene) -> u32 {
    crc32fast::hash(&section(scene))
}

fn row(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}
