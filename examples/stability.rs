//! The hard cases, measured, as a page:
//! `cargo run --release --example stability -- --out docs/stability.md`, or with
//! `--check` instead of `--out` to compare the page with what is measured now.
//!
//! Hosts differ in the last bits. So a figure that was recorded may be another by a
//! factor of eight, or a rounding; all else has to be the same, and every bound has to hold.

#[path = "../tests/stability/mod.rs"]
mod stability;

use stability::{Bound, CASES, Case, Figure};
use std::fmt::Write;
use std::process::ExitCode;

const COMMAND: &str = "cargo run --release --example stability -- --out docs/stability.md";

/// Factor by which a figure may differ from the recorded one.
const FACTOR: f64 = 8.0;

/// Errors below this are a few last bits, which one host may have and another not.
const ROUNDING: f64 = 1e-13;

const HEAD: &str = "\
# Stability

Cases in which arithmetic goes wrong if nobody looks: what goes wrong, what is done about it, and how far off the answer is, measured
against an oracle. Images are measured against the direct sum (15), and that in `tests/paper.rs` against quadrature of (3). `tests/hard_cases.rs`
asserts every bound; the bounds and their reasons stand in `tests/tolerances/mod.rs`. An error of the naive way has to be at least its bound, or
the case is none; a count has to be exact.

| case | naively | here | measured (bound) |
|---|---|---|---|
";

const TAIL: &str = "\
";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let (purpose, path) = match arguments.as_slice() {
        [purpose, path] if purpose == "--out" || purpose == "--check" => (purpose, path),
        _ => {
            eprintln!("usage: stability --out FILE | --check FILE");
            return ExitCode::from(2);
        }
    };
    let measured: Vec<(&Case, Vec<Figure>)> = CASES
        .iter()
        .map(|case| {
            eprintln!("{}", case.name);
            (case, (case.measure)())
        })
        .collect();
    let mut broken = false;
    for (case, figures) in &measured {
        for figure in figures.iter().filter(|figure| !figure.holds()) {
            eprintln!(
                "error: {}: {} is {:e}, not {}",
                case.name,
                figure.what,
                figure.found,
                bound(figure)
            );
            broken = true;
        }
    }
    if broken {
        return ExitCode::from(1);
    }
    let page = page(&measured);
    let answer = if purpose == "--out" {
        std::fs::write(path, page).map_err(|error| format!("{path}: {error}"))
    } else {
        std::fs::read_to_string(path)
            .map_err(|error| format!("{path}: {error}"))
            .and_then(|recorded| compare(path, &recorded, &page))
    };
    match answer {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("error: {fault}; make it again with `{COMMAND}`");
            ExitCode::from(1)
        }
    }
}

fn page(measured: &[(&Case, Vec<Figure>)]) -> String {
    let mut page = format!("<!-- {COMMAND} -->\n{HEAD}");
    for (case, figures) in measured {
        let cells: Vec<String> = figures.iter().map(cell).collect();
        let texts = [case.name, case.naively, case.here, &cells.join("<br>")];
        // A bar would end the table's cell.
        let texts = texts.map(|text| text.replace('|', "\\|"));
        writeln!(page, "| {} |", texts.join(" | ")).expect("a string takes everything");
    }
    page + TAIL
}

/// `what: found (bound)`, the error with one digit.
fn cell(figure: &Figure) -> String {
    let found = match figure.bound {
        Bound::Exactly(_) => figure.found.to_string(),
        _ => format!("{:.0e}", figure.found),
    };
    format!("{}: {found} ({})", figure.what, bound(figure))
}

fn bound(figure: &Figure) -> String {
    match figure.bound {
        Bound::Most(bound) => format!("≤ {bound:e}"),
        Bound::Least(bound) => format!("≥ {bound:e}"),
        Bound::Exactly(bound) => format!("= {bound}"),
    }
}

/// Word by word; where both words are numbers with an exponent, they may differ by
/// [`FACTOR`], or both be [`ROUNDING`].
fn compare(path: &str, recorded: &str, page: &str) -> Result<(), String> {
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), page.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let (old, new) = (old.split_whitespace(), new.split_whitespace());
        let same = old.clone().count() == new.clone().count()
            && old.zip(new).all(|(old, new)| old == new || near(old, new));
        if !same {
            return Err(format!("{path}:{}: it says something else than is measured", line + 1));
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err(format!("{path}: it has other cases")) }
}

fn near(old: &str, new: &str) -> bool {
    let number = |word: &str| word.contains('e').then(|| word.parse::<f64>().ok()).flatten();
    match (number(old), number(new)) {
        (Some(old), Some(new)) => {
            let within = old / new <= FACTOR && new / old <= FACTOR;
            within || old.max(new) < ROUNDING
        }
        _ => false,
    }
}
