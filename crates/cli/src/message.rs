//! Messages and progress, on standard error.

use indicatif::{ProgressBar, ProgressStyle};
use std::fmt::Display;
use std::io::Write;
use std::time::Duration;

/// One line on standard error. If nobody can hear it, nothing happens.
pub fn say(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}

/// The line of a fault on standard error: one line, whatever it quotes.
pub fn say_fault(fault: impl Display) {
    let text = fault.to_string();
    let line = text.split(['\n', '\r']).map(str::trim).filter(|part| !part.is_empty());
    say(format_args!("error: {}", line.collect::<Vec<_>>().join(" ")));
}

/// A bar that counts to `count`; only a terminal shows it.
#[must_use]
pub fn bar(what: &'static str, count: usize) -> ProgressBar {
    let template = "{msg} [{bar:32}] {pos}/{len} {eta}";
    let style = ProgressStyle::with_template(template)
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .progress_chars("=> ");
    ProgressBar::new(count as u64).with_style(style).with_message(what)
}

/// A sign of life for work of unknown length; only a terminal shows it.
#[must_use]
pub fn spinner(what: &'static str) -> ProgressBar {
    let spinner = ProgressBar::new_spinner().with_message(what);
    spinner.enable_steady_tick(Duration::from_millis(100));
    spinner
}
