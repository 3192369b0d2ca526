//! Cells of the page's tables.

use eigenshade_cli::output::number::grouped;
use std::fmt::Write;

/// Appends a row of a table.
pub fn line(text: &mut String, cells: &[String]) {
    writeln!(text, "| {} |", cells.join(" | ")).expect("a string takes everything");
}

/// A number with commas between thousands; a dash if there is none.
pub fn number(number: Option<u64>) -> String {
    number.map_or_else(|| "-".into(), |number| grouped(number as usize))
}

/// A percentage with two digits.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        zero if zero < 1e-10 => "0".into(),
        large if large >= 9.95 => format!("{large:.0}%"),
        middle if middle >= 0.995 => format!("{middle:.1}%"),
        small => format!("{small:.2}%"),
    }
}
