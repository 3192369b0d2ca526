//! Messages and progress, on standard error.

use indicatif::{ProgressBar, ProgressStyle};
use std::fmt::Display;
use std::io::Write;
use std::time::Duration;

/// Writes one line to standard error. Does nothing if that fails.
pub fn say(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{}", printable(&line.to_string()));
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

/// Writes an error to standard error as a single line, whatever text it quotes.
pub fn say_fault(fault: impl Display) {
    let text = fault.to_string();
    let line = text.split(['\n', '\r']).map(str::trim).filter(|part| !part.is_empty());
    say(format_args!("error: {}", line.collect::<Vec<_>>().join(" ")));
}

/// A progress bar that counts to `count`, shown only on a terminal.
#[must_use]
pub fn bar(what: &'static str, count: usize) -> ProgressBar {
    let template = "{msg} [{bar:32}] {pos}/{len} {eta}";
    let style = ProgressStyle::with_template(template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    ProgressBar::new(count as u64).with_style(style).with_message(what)
}

/// A spinner for work of unknown length, shown only on a terminal.
#[must_use]
pub fn spinner(what: &'static str) -> ProgressBar {
    let spinner = ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(Duration::from_millis(100));
    spinner
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn control_characters_are_spelled_out() {
        let text = "na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n";
        assert_eq!(printable(text), r"na\u{1b}[31mme\u{7}\u{9b}2J\t\u{202e}\r\n");
        assert_eq!(printable("Größe `π` \"a\\b\" e\u{301} 面"), "Größe `π` \"a\\b\" e\u{301} 面");
    }
}
