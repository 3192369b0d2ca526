//! eigenshade against other ways to the same numbers: errors, and times relative to ours. `cargo
//! bench` measures both and writes peers.csv; with `--check`, errors alone are compared with it.

mod dense;
mod harmonics;
mod node;
mod pixels;
mod projection;
mod view;

use eigenshade_benches::sheet::{self, Row};
use std::process::ExitCode;
use std::time::Instant;

const FILE: &str = "peers.csv";
const COLUMNS: [&str; 6] =
    ["comparison", "method", "time, SSE2", "time, AVX2", "median error", "largest error"];
/// The column of this build's times.
const TIME: &str = if cfg!(target_feature = "fma") { COLUMNS[3] } else { COLUMNS[2] };

/// Interleaved rounds, of which each form's fastest is taken: ratios then repeat within some per cent
/// on a busy machine, and methods timed one after the other do not.
const ROUNDS: usize = 101;

fn main() -> ExitCode {
    let timed = !std::env::args().any(|argument| argument == "--check");
    let rows: Vec<Row> = projection::compare(timed)
        .into_iter()
        .chain(pixels::compare(timed))
        .chain(harmonics::compare(timed))
        .chain(node::compare(timed))
        .collect();
    if timed {
        sheet::write(FILE, &COLUMNS, &rows, two_digits);
    } else if !sheet::check(FILE, &rows, agrees) {
        eprintln!("if this is intended, run `benches/run` and commit");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

fn two_digits(value: f64) -> String {
    let exponent = format!("{value:.1e}");
    let rounded: f64 = exponent.parse().expect("a number");
    if (0.01..1e4).contains(&rounded) { rounded.to_string() } else { exponent }
}

/// Two digits are at most a twentieth off. Below 1e-5 an error is rounding, which differs between
/// processors, since sums run in the order of their width, fused or not.
fn agrees(stated: f64, found: f64) -> bool {
    if stated < 1e-5 { found <= 3.0 * stated } else { (found - stated).abs() <= 0.051 * stated }
}

/// A method of a comparison.
struct Method<'a> {
    name: &'static str,
    /// Forms of it, of which the fastest is compared.
    forms: Vec<Box<dyn FnMut() + 'a>>,
    /// The part of the comparison's work that each does.
    part: f64,
    /// Of each case.
    errors: Vec<f64>,
}

impl<'a> Method<'a> {
    /// Of one form that does all the work.
    fn new(name: &'static str, run: impl FnMut() + 'a, errors: Vec<f64>) -> Self {
        Self { name, forms: vec![Box::new(run)], part: 1.0, errors }
    }

    /// Seconds of the fastest form of each.
    fn seconds(methods: &mut [Self]) -> Vec<f64> {
        let mut least = vec![f64::INFINITY; methods.len()];
        for _ in 0..ROUNDS {
            for (method, least) in methods.iter_mut().zip(&mut least) {
                for form in &mut method.forms {
                    let start = Instant::now();
                    form();
                    *least = least.min(start.elapsed().as_secs_f64() / method.part);
                }
            }
        }
        least
    }
}

/// Compares methods with the first of them.
fn rows(comparison: &str, mut methods: Vec<Method<'_>>, timed: bool) -> Vec<Row> {
    let seconds = if timed { Method::seconds(&mut methods) } else { Vec::new() };
    let errors = methods.into_iter().map(|method| (method.name, method.errors));
    errors
        .enumerate()
        .map(|(k, (name, errors))| {
            row(comparison, name, seconds.get(k).map(|one| one / seconds[0]), errors)
        })
        .collect()
}

fn row(comparison: &str, method: &str, time: Option<f64>, mut errors: Vec<f64>) -> Row {
    errors.sort_by(f64::total_cmp);
    let (middle, largest) = (errors[errors.len() / 2], errors[errors.len() - 1]);
    let errors = [(COLUMNS[4], middle), (COLUMNS[5], largest)];
    let cells = time.map(|time| (TIME, time)).into_iter().chain(errors);
    Row {
        name: vec![comparison.to_owned(), method.to_owned()],
        cells: cells.map(|(column, value)| (column.to_owned(), value)).collect(),
    }
}
