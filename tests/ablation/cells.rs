//! Cells of the page's tables.

use std::fmt::Write;

/// A row of a table.
pub fn line(text: &mut String, cells: &[String]) {
    writeln!(text, "| {} |", cells.join(" | ")).expect("a string takes everything");
}

/// With commas between thousands; a dash for nothing.
pub fn number(number: Option<u64>) -> String {
    let Some(number) = number else { return "-".into() };
    let digits = number.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Two digits.
pub fn percent(share: f64) -> String {
    match 100.0 * share {
        zero if zero < 1e-10 => "0".into(),
        large if large >= 9.95 => format!("{large:.0}%"),
        middle if middle >= 0.995 => format!("{middle:.1}%"),
        small => format!("{small:.2}%"),
    }
}
