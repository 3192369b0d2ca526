//! Times of several ways, run in turn, so that what disturbs one disturbs all; tables of methods,
//! time ratios and errors as Markdown; and a description of the machine.

use std::fmt::Write;
use std::time::Instant;

/// Seconds that one measurement takes, if one call does not take longer: so short that where
/// other programs run few measurements are interrupted, and the median is of none.
const MEASUREMENT: f64 = 3e-4;

/// A method to be timed. Its argument is the number of the round.
pub struct Way<'a>(Box<dyn FnMut(usize) + 'a>);

impl<'a> Way<'a> {
    pub fn new(run: impl FnMut(usize) + 'a) -> Self {
        Self(Box::new(run))
    }

    /// Seconds of `calls` together.
    fn seconds(&mut self, calls: usize, round: usize) -> f64 {
        let start = Instant::now();
        for _ in 0..calls {
            (self.0)(round);
        }
        start.elapsed().as_secs_f64()
    }

    /// How many calls make a measurement.
    fn calls(&mut self) -> usize {
        let mut calls = 1;
        while self.seconds(calls, 0) < MEASUREMENT {
            calls *= 2;
        }
        calls
    }
}

/// What each way takes, in calls of the first: the median over the rounds of what each gives.
pub fn ratios(rounds: usize, ways: &mut [Way<'_>]) -> Vec<f64> {
    let calls: Vec<usize> = ways.iter_mut().map(Way::calls).collect();
    let mut seconds = vec![Vec::with_capacity(rounds); ways.len()];
    for round in 0..rounds {
        for ((way, &calls), seconds) in ways.iter_mut().zip(&calls).zip(&mut seconds) {
            // What it reads is near from the first call on.
            way.seconds(1, round);
            seconds.push(way.seconds(calls, round) / calls as f64);
        }
    }
    let first = seconds[0].clone();
    let ratio = |of: Vec<f64>| median(of.iter().zip(&first).map(|(one, first)| one / first));
    seconds.into_iter().map(ratio).collect()
}

/// The middle of some numbers, the upper of two.
pub fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut numbers: Vec<f64> = numbers.collect();
    numbers.sort_by(f64::total_cmp);
    numbers[numbers.len() / 2]
}

/// The middle and the largest of some errors.
pub fn median_and_worst(errors: &[f64]) -> [Option<f64>; 2] {
    let worst = errors.iter().fold(0.0, |most: f64, &error| most.max(error));
    [Some(median(errors.iter().copied())), Some(worst)]
}

/// One comparison.
pub struct Table {
    title: &'static str,
    /// Headers of the columns after the method: times first, then errors.
    heads: &'static [&'static str],
    rows: Vec<Row>,
}

struct Row {
    way: String,
    ratio: Option<f64>,
    standing: String,
    errors: Vec<Option<f64>>,
}

/// Below this an error is rounding, which differs from host to host.
pub const ROUNDING: f64 = 1e-5;

/// Two digits, as people write them.
pub fn two_digits(value: f64) -> String {
    if !value.is_finite() {
        "no number".into()
    } else if value == 0.0 {
        "0".into()
    } else if !(0.01..1e6).contains(&value) {
        format!("{value:.1e}")
    } else {
        let decimals = 1 - value.log10().floor() as i32;
        let power = 10f64.powi(decimals);
        let text = format!("{:.*}", decimals.max(0) as usize, (value * power).round() / power);
        match text.len() {
            thousands @ 4.. if decimals <= 0 => {
                let (front, back) = text.split_at(thousands - 3);
                format!("{front},{back}")
            }
            _ => text,
        }
    }
}

/// Who is ahead, `factor` being their time in ours; empty where there is nothing to say.
pub fn standing(ours: &str, theirs: &str, factor: Option<f64>) -> String {
    let Some(factor) = factor else { return String::new() };
    if factor > 1.05 {
        format!("{ours} is {} times as fast", two_digits(factor))
    } else if factor < 1.0 / 1.05 {
        format!("**we are not ahead**: {theirs} is {} times as fast", two_digits(1.0 / factor))
    } else {
        format!("{ours} and {theirs} are as fast")
    }
}

impl Table {
    pub fn new(title: &'static str, heads: &'static [&'static str]) -> Self {
        Self { title, heads, rows: Vec::new() }
    }

    /// Adds a way: its time in the comparison's unit, if times were measured, and an error for each
    /// head of errors, None where there is nothing to compare, NaN where it gives no number.
    pub fn row(
        &mut self,
        way: impl Into<String>,
        ratio: Option<f64>,
        standing: String,
        errors: impl Into<Vec<Option<f64>>>,
    ) {
        self.rows.push(Row { way: way.into(), ratio, standing, errors: errors.into() });
    }

    pub fn markdown(&self) -> String {
        let (heads, rule) = (self.heads.join(" | "), "|---:".repeat(self.heads.len() - 2));
        let mut text =
            format!("### {}\n\n| method | {heads} |\n|---|---:|---{rule}|\n", self.title);
        for row in &self.rows {
            let ratio = row.ratio.map_or(String::new(), two_digits);
            write!(text, "| {} | {ratio} | {} |", row.way, row.standing).expect("a string grows");
            for &error in &row.errors {
                let error = error.map_or(String::new(), two_digits);
                write!(text, " {error} |").expect("a string grows");
            }
            text.push('\n');
        }
        text
    }

    /// What differs from the errors that a page states: `stated` is the part of it between the
    /// marks of some build.
    pub fn faults(&self, stated: &str, relative: f64, rounding: f64) -> Vec<String> {
        let lines = stated.split("\n### ").find_map(|part| part.strip_prefix(self.title));
        let Some(lines) = lines else { return vec![format!("{}: not on the page", self.title)] };
        let mut faults = Vec::new();
        for row in &self.rows {
            let start = format!("\n| {} |", row.way);
            let line = lines.split_once(&start).and_then(|(_, rest)| rest.lines().next());
            let Some(line) = line else {
                faults.push(format!("{}, {}: not on the page", self.title, row.way));
                continue;
            };
            let cells: Vec<&str> = line.trim_end_matches('|').split('|').map(str::trim).collect();
            for (k, error) in row.errors.iter().enumerate() {
                let Some(error) = *error else { continue };
                let cell = cells.get(2 + k).copied().unwrap_or_default();
                if !agrees(cell, error, relative, rounding) {
                    let (title, way, head) = (self.title, &row.way, self.heads[2 + k]);
                    faults.push(format!(
                        "{title}, {way}, {head}: {error:.3e}, the page has `{cell}`"
                    ));
                }
            }
        }
        faults
    }
}

fn agrees(cell: &str, error: f64, relative: f64, rounding: f64) -> bool {
    match cell.parse::<f64>() {
        Err(_) => cell == two_digits(error),
        Ok(stated) if stated < ROUNDING => error <= rounding * stated,
        Ok(stated) => (error - stated).abs() <= relative * stated,
    }
}

/// Instruction sets, from the widest on.
macro_rules! widest {
    ($has:ident) => {
        [
            ("AVX-512", $has!("avx512f")),
            ("AVX2 with FMA", $has!("avx2") && $has!("fma")),
            ("AVX", $has!("avx")),
            ("SSE4.2", $has!("sse4.2")),
            ("SSE2", $has!("sse2")),
        ]
        .into_iter()
        .find_map(|(name, has)| has.then_some(name))
        .unwrap_or("none")
    };
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
fn of_processor() -> &'static str {
    macro_rules! has {
        ($feature:tt) => {
            is_x86_feature_detected!($feature)
        };
    }
    widest!(has)
}

#[cfg(any(target_arch = "x86_64", target_arch = "x86"))]
fn of_build() -> &'static str {
    macro_rules! has {
        ($feature:tt) => {
            cfg!(target_feature = $feature)
        };
    }
    widest!(has)
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86")))]
fn of_processor() -> &'static str {
    of_build()
}

#[cfg(not(any(target_arch = "x86_64", target_arch = "x86")))]
fn of_build() -> &'static str {
    if cfg!(target_feature = "neon") { "NEON" } else { "its own" }
}

/// The machine, and the versions of the libraries and of Node.
pub fn described() -> String {
    let libraries = ["faer", "nalgebra", "ndarray", "sphrs"].map(|name| {
        let version = version(name).unwrap_or("?");
        format!("{name} {version}")
    });
    format!(
        "{}, one core. The processor has {}; the build uses {}, and faer and ndarray choose at\n\
         run time. {}; ndarray without BLAS.\n\
         three.js {}, Node {}.",
        std::env::consts::ARCH,
        of_processor(),
        of_build(),
        libraries.join(", "),
        three().unwrap_or("?"),
        node().unwrap_or("?".into())
    )
}

/// As locked.
fn version(name: &str) -> Option<&'static str> {
    let lock = include_str!("../Cargo.lock");
    let (_, after) = lock.split_once(&format!("name = \"{name}\"\nversion = \""))?;
    after.split('"').next()
}

fn three() -> Option<&'static str> {
    let package = include_str!("../node/package.json");
    package.split_once("\"three\": \"")?.1.split('"').next()
}

fn node() -> Option<String> {
    let output = std::process::Command::new("node").arg("--version").output().ok()?;
    Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// Marks of this build's part of the page.
pub fn marks() -> [&'static str; 2] {
    if of_build() == "SSE2" || cfg!(not(target_arch = "x86_64")) {
        ["<!-- default target -->", "<!-- end of default target -->"]
    } else {
        ["<!-- target-cpu=native -->", "<!-- end of target-cpu=native -->"]
    }
}
