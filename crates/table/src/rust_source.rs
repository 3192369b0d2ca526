//! A table as Rust source: typed statics for the runtime.

use crate::parts;
use crate::rust_record::Constants;
use crate::table::Table;
use eigenshade_index::layout;
use eigenshade_index::record::floats::{GeneralParts, OwnedParts, Parts};
use eigenshade_index::record::{Coupling, NONE, ProfilePlace, Row};
use std::fmt::Write;

/// The body of a module with the table's numbers in f32, and the lines that name its shape; it names
/// the runtime as `eigenshade`.
///
/// `command` is what made it, for the first line. Domain: a table that
/// [projects](Table::has_projection).
#[must_use]
pub fn module(table: &Table, command: &str) -> String {
    let parts = parts::floats(table).convert(|&number| number as f32);
    let mut constants = Constants::default();
    constants.add("PARTS", Parts::<f32>::PATH, "f32", |to| parts.borrow().visit(to));
    if table.general.is_some() {
        let general = parts::general(table).convert(|&number| number as f32);
        let path = GeneralParts::<f32>::PATH;
        constants.add("GENERAL", path, "f32", |to| general.borrow().visit(to));
    }
    let Constants { text, bytes, .. } = constants;
    let mut text = format!("// {command}\n// {bytes} bytes of tables\n{text}");
    if table.general.is_none() {
        line(&mut text, format_args!("eigenshade::table!({});", sphere(&parts)));
        line(&mut text, format_args!("eigenshade::table!(project {});", project(&parts)));
        line(&mut text, format_args!("eigenshade::table!(collapse {});", collapse(&parts)));
    } else {
        line(&mut text, format_args!("eigenshade::table!(general);"));
    }
    line(&mut text, format_args!("eigenshade::table!(shade {});", shade(&parts)));
    if let Some(knots) = table.scene.basis.knots {
        line(&mut text, format_args!("eigenshade::table!(sampled {knots});"));
    }
    text
}

/// A line of text.
pub(crate) fn line(text: &mut String, line: std::fmt::Arguments<'_>) {
    writeln!(text, "{line}").expect("a string takes everything");
}

/// Items with spaces between them.
pub(crate) fn words(items: impl IntoIterator<Item: ToString>) -> String {
    let items: Vec<String> = items.into_iter().map(|item| item.to_string()).collect();
    items.join(" ")
}

/// The passes and runs of a transfer.
fn sphere(parts: &OwnedParts<f32>) -> String {
    let (mut passes, mut slots) = (Vec::new(), parts.slots.as_slice());
    for (index, pass) in parts.passes.iter().enumerate() {
        let (of_pass, rest) = slots.split_at(usize::from(pass.profiles) * layout::LANES);
        // Its profiles may serve other orders alone, where +m is the last component.
        if of_pass.iter().any(|&slot| slot != NONE) {
            passes.push(format!("[{} {index} {}]", passes.len(), pass.profiles));
        }
        slots = rest;
    }
    let mut runs = Vec::new();
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        let signs: [fn(&ProfilePlace) -> Row; 2] =
            [|place| place.plus_row, |place| place.minus_row];
        for row in &signs[..if profiles[0].azimuth == 0 { 1 } else { 2 }] {
            // Rows of one pass stand side by side.
            let next = |a: &ProfilePlace, b: &ProfilePlace| {
                let (a, b) = (row(a), row(b));
                b.step == a.step && b.start == a.start + layout::LANES as u32
            };
            for run in profiles.chunk_by(next) {
                runs.push(format!("[{} {}]", runs.len(), run.len()));
            }
        }
    }
    format!("sphere passes {} runs {}", words(passes), words(runs))
}

/// The parts of a projection. A table with a selection of modes is projected by its basis, since
/// its polar integrals differ from azimuth to azimuth; so is one of effects that leave out orders
/// between others, or whose ambient stands apart.
fn project(parts: &OwnedParts<f32>) -> String {
    let whole = parts.ambient.is_empty() && !parts.couplings.contains(&Coupling::NONE);
    if !whole || !parts.selection.is_empty() {
        return "by basis".into();
    }
    let order = parts.order;
    let scatter = (0..=order).map(|q| format!("[{q} {}]", (order - q) / 2 + 1));
    let mut text = format!("scatter {}", words(scatter));
    for profiles in parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth) {
        text += &format!(" azimuth {}", profiles[0].azimuth);
        for (number, four) in profiles.chunks(4).enumerate() {
            text += &format!(" [{} {}]", 4 * number, four.len().div_ceil(2));
        }
    }
    text
}

/// The azimuths of a scene and their profiles. A mean image is one summand more, and orthogonal
/// polynomials have recurrences: the basis takes both.
fn collapse(parts: &OwnedParts<f32>) -> String {
    if !parts.mean.is_empty() || !parts.recurrences.is_empty() {
        return "by basis".into();
    }
    let azimuths = parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth);
    words(azimuths.map(|profiles| format!("[{} {}]", profiles[0].azimuth, profiles.len())))
}

/// The azimuths of a pixel, from the highest downward.
fn shade(parts: &OwnedParts<f32>) -> String {
    let lengths = &parts.lengths;
    let last = lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    if !parts.recurrences.is_empty() {
        return "by scene".into();
    }
    // A scene of at most nine terms of the normal, and of more than azimuth 0.
    if matches!(lengths[..=last], [..=3, ..=2] | [..=3, ..=2, ..=1]) {
        return "nine terms".into();
    }
    words((1..=last).rev())
}
