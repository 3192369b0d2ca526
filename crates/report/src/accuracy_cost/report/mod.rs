//! The charts, and the tables of the page.

pub mod charts;
mod tables;

use super::Measured;
use super::machines::MACHINES;
use crate::numbers;
use crate::pages::Part;
use eigenshade_cli::messages::grouped;

/// A number that was not measured.
const MISSING: &str = "-";

/// The tables of the page.
pub fn tables(measured: &Measured) -> Vec<Part> {
    let mut parts: Vec<Part> = MACHINES
        .iter()
        .map(|machine| (machine.key, tables::of_machine(&measured.settings, machine)))
        .collect();
    parts.push(("choice", tables::choice(&measured.settings)));
    parts.push(("total", tables::total(measured)));
    parts.push(("rivals", tables::rivals(measured)));
    parts.push(("components", tables::components(measured)));
    parts.push(("model", tables::model(&measured.model)));
    parts.push(("mathematics", tables::mathematics(&measured.settings)));
    parts.push(("effects", tables::effects(&measured.settings)));
    parts
}

/// An error in percent with two digits, or as a power of ten below 0.01 %.
fn percent(error: f64) -> String {
    match error {
        _ if !error.is_finite() => MISSING.into(),
        ..1e-4 => format!("{error:.1e}"),
        _ => numbers::percent(error, 2),
    }
}

/// A cost with three digits, or four if it is large.
fn cost(value: f64) -> String {
    match value {
        1000.0.. => {
            let unit = 10f64.powi(value.log10() as i32 - 3);
            grouped((unit * (value / unit).round()) as usize)
        }
        100.0.. => format!("{value:.0}"),
        10.0.. => format!("{value:.1}"),
        _ => format!("{value:.2}"),
    }
}

/// Counted instructions: all digits of small counts.
fn instructions(value: f64) -> String {
    if value < 1000.0 { grouped(value as usize) } else { cost(value) }
}

fn difference(value: f64) -> String {
    format!("{value:.1}")
}
