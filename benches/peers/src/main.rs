//! eigenshade against other ways to the same numbers, in one run.
//!
//! `benches/peers/run` measures and writes the tables of `README.md`;
//! `benches/peers/run --check` compares their errors alone.

mod browser;
mod dense;
mod harmonics;
mod pixels;
mod projection;
mod report;
mod shipped;
mod subject;

use std::error::Error;
use std::process::ExitCode;

/// A figure that a page gives with two digits, relative: half a unit of the second is at
/// most a twentieth.
const STATED: f64 = 0.051;

/// An error that is rounding, of what the page of peers states for it: their sums run in the order
/// of the processor's width, ours with fused products or without.
const PEERS_ROUNDING: f64 = 3.0;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let done = match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => measure(),
        ["--check"] => check(),
        _ => {
            eprintln!("usage: benches/peers/run [--check]");
            return ExitCode::from(2);
        }
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn tables(measured: bool) -> Result<Vec<report::Table>, Box<dyn Error>> {
    let shipped = shipped::Shipped::read()?;
    Ok(vec![
        projection::table(&shipped, measured),
        pixels::measured(&shipped, measured),
        pixels::matte(&shipped, measured),
        harmonics::table(measured)?,
        browser::table(&shipped, measured)?,
    ])
}

/// Measures all and writes this build's part of the page.
fn measure() -> Result<(), Box<dyn Error>> {
    let tables: Vec<String> = tables(true)?.iter().map(report::Table::markdown).collect();
    let text = format!("{}\n\n{}", report::described(), tables.join("\n"));
    print!("{text}");
    let path = shipped::root().join("benches/peers/README.md");
    let page = std::fs::read_to_string(&path)?;
    let (before, _, after) = parts(&page)?;
    let temporary = path.with_extension("md.new");
    std::fs::write(&temporary, format!("{before}\n{text}{after}"))?;
    std::fs::rename(&temporary, &path)?;
    Ok(())
}

/// Compares the errors with those that the page states.
fn check() -> Result<(), Box<dyn Error>> {
    let page = std::fs::read_to_string(shipped::root().join("benches/peers/README.md"))?;
    let (_, stated, _) = parts(&page)?;
    let faults: Vec<String> = tables(false)?
        .iter()
        .flat_map(|table| table.faults(stated, STATED, PEERS_ROUNDING))
        .collect();
    if faults.is_empty() {
        println!("every error is what benches/peers/README.md states");
        return Ok(());
    }
    let faults = faults.join("\n  ");
    Err(format!("errors differ from the page; benches/peers/run measures anew\n  {faults}").into())
}

/// The page up to this build's first mark, between the two, and from the second on.
fn parts(page: &str) -> Result<(&str, &str, &str), Box<dyn Error>> {
    let [start, end] = report::marks();
    let missing = || format!("benches/peers/README.md has no `{start}` .. `{end}`; put them back");
    let from = page.find(start).ok_or_else(missing)? + start.len();
    let to = page.find(end).filter(|&to| to > from).ok_or_else(missing)?;
    Ok((&page[..from], &page[from..to], &page[to..]))
}
