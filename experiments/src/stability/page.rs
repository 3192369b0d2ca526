//! The generated part of `docs/stability.md`.

use super::{Bound, CASES, Case, Figure};
use crate::pages::{self, Part};
use std::fmt::Write;

/// Factor by which a figure on the page may differ from one measured now: errors are a few last
/// bits, which depend on a host's library and vector width.
const PAGE_FACTOR: f64 = 8.0;

/// Errors on that page below this may be zero on another host.
const PAGE_ROUNDING: f64 = 1e-13;

/// The command that regenerates the part.
pub const COMMAND: &str = "cargo run --release -p experiments -- stability --out docs/stability.md";

/// Measures every case.
///
/// # Errors
///
/// The figures that exceed their bounds.
pub fn parts(progress: impl Fn(&str)) -> Result<Vec<Part>, String> {
    let mut text = "| case | naively | here | measured (bound) |\n|---|---|---|---|\n".to_owned();
    let mut broken = Vec::new();
    for case in CASES {
        progress(case.name);
        let figures = (case.measure)();
        for figure in figures.iter().filter(|figure| !figure.holds()) {
            let Figure { what, found, .. } = figure;
            broken.push(format!("{}: {what} is {found:e}, not {}", case.name, bound(figure)));
        }
        row(&mut text, case, &figures);
    }
    if broken.is_empty() { Ok(vec![("cases", text)]) } else { Err(broken.join("; ")) }
}

/// Applies [`pages::compare`]: hosts differ in the last bits, so a figure may differ by
/// [`PAGE_FACTOR`], or both may be below [`PAGE_ROUNDING`].
///
/// # Errors
///
/// The first line that differs.
pub fn compare(recorded: &str, now: &str) -> Result<(), String> {
    pages::compare(recorded, now, |old, new| {
        let within = old / new <= PAGE_FACTOR && new / old <= PAGE_FACTOR;
        within || old.max(new) < PAGE_ROUNDING
    })
}

fn row(text: &mut String, case: &Case, figures: &[Figure]) {
    let cells: Vec<String> = figures.iter().map(cell).collect();
    let texts = [case.name, case.naively, case.here, &cells.join("<br>")];
    // An unescaped bar would end the table cell.
    let texts = texts.map(|text| text.replace('|', "\\|"));
    let _ = writeln!(text, "| {} |", texts.join(" | "));
}

/// `what: found (bound)`, with one digit of the error.
fn cell(figure: &Figure) -> String {
    let found = match figure.bound {
        Bound::Exactly(_) => figure.found.to_string(),
        Bound::Told => format!("×{:.1}", figure.found),
        _ => format!("{:.0e}", figure.found),
    };
    format!("{}: {found} ({})", figure.what, bound(figure))
}

fn bound(figure: &Figure) -> String {
    match figure.bound {
        Bound::Most(bound) => format!("≤ {bound:e}"),
        Bound::Least(bound) => format!("≥ {bound:e}"),
        Bound::Exactly(bound) => format!("= {bound}"),
        Bound::Told => "not asserted".to_owned(),
    }
}
