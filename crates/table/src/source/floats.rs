//! A record of floats as Rust source.

use super::{Constants, line, words};
use crate::layout;
use crate::record::floats::Parts;
use crate::record::{NONE, ProfilePlace, Row};
use alloc::format;
use alloc::string::String;
use alloc::vec::Vec;

/// The body of a module with the numbers of a table that projects. `command` is what made it, for
/// the first line.
#[must_use]
pub fn module(parts: &Parts<'_, f32>, command: &str) -> String {
    let mut constants = Constants::default();
    constants.add("PARTS", Parts::<f32>::PATH, |to| parts.visit(to));
    let mut text = constants.headed(command);
    line(&mut text, format_args!("eigenshade::table!({});", sphere(parts)));
    line(&mut text, format_args!("eigenshade::table!(project {});", project(parts)));
    line(&mut text, format_args!("eigenshade::table!(collapse {});", collapse(parts)));
    line(&mut text, format_args!("eigenshade::table!(shade {});", shade(parts)));
    text
}

/// The passes and runs of a transfer.
fn sphere(parts: &Parts<'_, f32>) -> String {
    let (mut passes, mut slots) = (Vec::new(), parts.slots);
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

/// The parts of a projection.
fn project(parts: &Parts<'_, f32>) -> String {
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

/// The azimuths of a scene and their profiles.
fn collapse(parts: &Parts<'_, f32>) -> String {
    let azimuths = parts.profiles.chunk_by(|a, b| a.azimuth == b.azimuth);
    words(azimuths.map(|profiles| format!("[{} {}]", profiles[0].azimuth, profiles.len())))
}

/// The azimuths of a pixel, from the highest downward.
fn shade(parts: &Parts<'_, f32>) -> String {
    let lengths = parts.lengths;
    let last = lengths.iter().rposition(|&length| length > 0).unwrap_or(0);
    words((1..=last).rev())
}
