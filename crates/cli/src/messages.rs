//! Messages and progress on standard error.

use std::fmt::Display;
use std::io::Write;

/// Writes one line to standard error. Does nothing if that fails.
pub fn print_message(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(&line.to_string()));
}

/// Writes an error to standard error as a single line, whatever text it quotes.
pub fn report_error(error: impl Display) {
    let text = error.to_string();
    let line = text.split(['\n', '\r']).map(str::trim).filter(|part| !part.is_empty());
    print_message(format_args!("error: {}", line.collect::<Vec<_>>().join(" ")));
}

/// Escapes control characters, which may come from names in files, because a terminal would
/// interpret them.
#[must_use]
pub fn printable(text: &str) -> String {
    // Also escapes characters that change the writing direction or end a line.
    let is_control = |letter: char| {
        letter.is_control()
            || matches!(letter, '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}')
            || matches!(letter, '\u{2066}'..='\u{2069}')
    };
    let mut shown = String::with_capacity(text.len());
    for letter in text.chars() {
        if is_control(letter) {
            shown.extend(letter.escape_default());
        } else {
            shown.push(letter);
        }
    }
    shown
}

/// A number of bytes with its digits in groups of three.
#[must_use]
pub fn grouped(count: usize) -> String {
    let digits = count.to_string();
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// A progress bar that counts to `count`, shown only on a terminal.
#[cfg(feature = "generate")]
#[must_use]
pub fn progress_bar(what: &'static str, count: usize) -> indicatif::ProgressBar {
    let template = "{msg} [{bar:32}] {pos}/{len} {eta}";
    let style = indicatif::ProgressStyle::with_template(template)
        .unwrap_or_else(|_| indicatif::ProgressStyle::default_bar())
        .progress_chars("=> ");
    indicatif::ProgressBar::new(count as u64).with_style(style).with_message(what)
}

/// A spinner for work of unknown length, shown only on a terminal.
#[cfg(feature = "generate")]
#[must_use]
pub fn spinner(what: &'static str) -> indicatif::ProgressBar {
    let spinner = indicatif::ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(std::time::Duration::from_millis(100));
    spinner
}

/// Stands in for a progress bar: without the feature `generate` there is none.
#[cfg(not(feature = "generate"))]
#[derive(Clone, Copy, Debug)]
pub struct NoProgress;

#[cfg(not(feature = "generate"))]
impl eigenshade_shading::parallel::Progress for NoProgress {
    fn advance(&self) {}
}

#[cfg(not(feature = "generate"))]
impl NoProgress {
    /// Does nothing.
    pub fn inc(self, _steps: u64) {}

    /// Does nothing.
    pub fn finish_and_clear(self) {}
}

/// Shows nothing: progress bars need the feature `generate`.
#[cfg(not(feature = "generate"))]
#[must_use]
pub fn progress_bar(_what: &'static str, _count: usize) -> NoProgress {
    NoProgress
}

#[cfg(test)]
mod tests {
    use super::{grouped, printable};

    #[test]
    fn control_characters_are_escaped() {
        let text = "na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n";
        assert_eq!(printable(text), r"na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n");
        assert_eq!(printable("Größe `π` \"a\\b\" e\u{301} 面"), "Größe `π` \"a\\b\" e\u{301} 面");
    }

    #[test]
    fn digits_are_grouped() {
        let texts = [0, 999, 1000, 1_234_567].map(grouped);
        assert_eq!(texts, ["0", "999", "1,000", "1,234,567"]);
    }
}
