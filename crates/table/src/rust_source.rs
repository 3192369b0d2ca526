//! A table as Rust source: typed statics for the runtime.

use crate::parts::{NONE, Parts, ProfilePlace, Row};
use crate::table::{General, Table};
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::layout;
use std::fmt::Write;

/// The body of a module with the table's numbers in f32, and the lines that name its shape; it names
/// the runtime as `eigenshade`.
///
/// `command` is what made it, for the first line. Domain: a table that
/// [projects](Table::has_projection).
#[must_use]
pub fn module(table: &Table, command: &str) -> String {
    let parts = Parts::new(table);
    let mut text =
        format!("// {command}\n// {} bytes of tables\n", bytes(&parts) + general_bytes(table));
    for (name, values) in floats(&parts) {
        array(&mut text, name, "f32", values.iter().map(|&value| format!("{:?}", value as f32)));
    }
    let pairs = parts.recurrences.iter().map(|[at, below]| format!("[{at:?}, {below:?}]"));
    array(&mut text, "RECURRENCES", "[f32; 2]", pairs);
    array(&mut text, "LENGTHS", "u16", parts.lengths.iter().map(u16::to_string));
    array(&mut text, "SLOTS", "u16", parts.slots.iter().map(u16::to_string));
    array(&mut text, "SELECTION", "bool", parts.selection.iter().map(bool::to_string));
    let passes = parts.passes.iter();
    let passes =
        passes.map(|pass| format!("eigenshade::Pass::new({}, {})", pass.first, pass.profiles));
    array(&mut text, "PASSES", "eigenshade::Pass", passes);
    let couplings = parts.couplings.iter();
    let couplings = couplings.map(|[o, p]| format!("eigenshade::Coupling::new({o}, {p})"));
    array(&mut text, "COUPLINGS", "eigenshade::Coupling", couplings);
    array(&mut text, "PROFILES", "eigenshade::ProfilePlace", parts.profiles.iter().map(place));
    text.push_str(&record(&parts));
    match &table.general {
        None => {
            line(&mut text, format_args!("eigenshade::table!({});", sphere(&parts)));
            line(&mut text, format_args!("eigenshade::table!(project {});", project(&parts)));
            line(&mut text, format_args!("eigenshade::table!(collapse {});", collapse(&parts)));
        }
        Some(general) => {
            for (name, values) in general_floats(general) {
                let values = values.iter().map(|&value| format!("{:?}", value as f32));
                array(&mut text, name, "f32", values);
            }
            line(&mut text, format_args!("{}", general_record(table.count())));
            line(&mut text, format_args!("eigenshade::table!(general);"));
        }
    }
    line(&mut text, format_args!("eigenshade::table!(shade {});", shade(&parts)));
    if let Some(knots) = table.scene.basis.knots {
        line(&mut text, format_args!("eigenshade::table!(sampled {knots});"));
    }
    text
}

/// The arrays of the number format.
fn floats(parts: &Parts) -> [(&'static str, &[f64]); 6] {
    [
        ("POLAR", &parts.polar),
        ("FACTORS", &parts.factors),
        ("AMBIENT", &parts.ambient),
        ("TERMS", &parts.terms),
        ("MEAN", &parts.mean),
        ("MEAN_COEFFICIENTS", &parts.mean_coefficients),
    ]
}

/// Bytes of all statics: f32 and u16 arrays, bools, 4 bytes a pass or a
/// coupling, 24 a profile.
fn bytes(parts: &Parts) -> usize {
    let floats: usize = floats(parts).iter().map(|(_, values)| values.len()).sum();
    let shorts = parts.lengths.len() + parts.slots.len();
    let records = 4 * parts.passes.len() + 4 * parts.couplings.len() + 24 * parts.profiles.len();
    4 * floats + 8 * parts.recurrences.len() + 2 * shorts + parts.selection.len() + records
}

/// The arrays of a general basis.
fn general_floats(general: &General) -> [(&'static str, &[f64]); 4] {
    [
        ("PROJECTION", &general.projection),
        ("SYNTHESIS", &general.synthesis),
        ("SPAN_MEAN", &general.mean),
        ("IMAGE_MEAN", &general.mean_coefficients),
    ]
}

fn general_bytes(table: &Table) -> usize {
    let Some(general) = &table.general else { return 0 };
    general_floats(general).iter().map(|(_, values)| 4 * values.len()).sum()
}

fn place(place: &ProfilePlace) -> String {
    let number = |index: u16| {
        if index == NONE { "None".into() } else { format!("Some({index})") }
    };
    let row = |row: Row| format!("eigenshade::Row::new({}, {})", row.start, row.step);
    format!(
        "eigenshade::ProfilePlace::new({}, {}, {}, {}, {})",
        place.azimuth,
        number(place.plus),
        number(place.minus),
        row(place.plus_row),
        row(place.minus_row)
    )
}

/// A static array of these items.
pub(crate) fn array(
    text: &mut String,
    name: &str,
    kind: &str,
    items: impl Iterator<Item = String>,
) {
    let items: Vec<String> = items.collect();
    let count = items.len();
    line(text, format_args!("static {name}: [{kind}; {count}] = [{}];", items.join(", ")));
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

/// A set of effects as an expression.
pub(crate) fn effects(effects: Effects) -> String {
    let mut text = String::from("eigenshade::Effects::NONE");
    if effects.is_all() {
        return "eigenshade::Effects::ALL".into();
    }
    for effect in Effect::ALL.into_iter().filter(|&effect| effects.has(effect)) {
        let _ = write!(text, ".with(eigenshade::Effect::{effect:?})");
    }
    text
}

/// The record of the parts.
fn record(parts: &Parts) -> String {
    let Parts { degree, order, components, .. } = parts;
    let effects = effects(parts.effects);
    format!(
        "const PARTS: eigenshade::Parts<'static, f32> = eigenshade::Parts {{
    degree: {degree},
    order: {order},
    effects: {effects},
    components: {components},
    profiles: &PROFILES,
    passes: &PASSES,
    slots: &SLOTS,
    couplings: &COUPLINGS,
    lengths: &LENGTHS,
    polar: &POLAR,
    factors: &FACTORS,
    ambient: &AMBIENT,
    terms: &TERMS,
    recurrences: &RECURRENCES,
    mean: &MEAN,
    mean_coefficients: &MEAN_COEFFICIENTS,
    selection: &SELECTION,
}};
"
    )
}

/// The record of the parts of a general basis.
fn general_record(components: usize) -> String {
    format!(
        "const GENERAL: eigenshade::GeneralParts<'static, f32> = eigenshade::GeneralParts {{
    components: {components},
    projection: &PROJECTION,
    synthesis: &SYNTHESIS,
    mean: &SPAN_MEAN,
    mean_coefficients: &IMAGE_MEAN,
}};"
    )
}

/// The passes and runs of a transfer.
fn sphere(parts: &Parts) -> String {
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
fn project(parts: &Parts) -> String {
    let whole = parts.ambient.is_empty() && !parts.couplings.contains(&[NONE; 2]);
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
fn collapse(parts: &Parts) -> String {
    if !parts.mean.is_empty() || !parts.recurrences.is_empty() {
        return "by basis".into();
    }
    let azimuths = parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth);
    words(azimuths.map(|profiles| format!("[{} {}]", profiles[0].azimuth, profiles.len())))
}

/// The azimuths of a pixel, from the highest downward.
fn shade(parts: &Parts) -> String {
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
