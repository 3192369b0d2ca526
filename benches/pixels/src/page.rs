//! The tables of docs/performance.md.

use crate::color::WAYS;
use crate::images::MATTE;
use crate::inputs::{NINE, PROJECT, WITHIN};
use crate::limit::{LANES, TARGET};
use crate::measured::Path;
use std::fmt::Write as _;

/// What the page's marks call the tables.
pub const TIMES: &str = "times";
pub const COUNTS: &str = "counts";

fn named(Path { name, lengths, .. }: &Path) -> String {
    if lengths.is_empty() {
        return name.clone();
    }
    let lengths: Vec<_> = lengths.iter().map(ToString::to_string).collect();
    format!("{name}: {}", lengths.join(" "))
}

/// The processor, as it calls itself.
fn processor() -> String {
    let cpuinfo = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let of = |key: &str| {
        let line = cpuinfo.lines().find(|line| line.starts_with(key))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let named = of("model name").unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    match (of("cpu family"), of("model\t")) {
        (Some(family), Some(model)) => format!("{named} (family {family}, model {model})"),
        _ => named,
    }
}

pub fn of_counts(paths: &[Path]) -> String {
    let mut page = String::from(
        "| path: terms of azimuths 0, 1, ... | multiply-adds | limit, instructions | found | of the limit |\n\
         |---|---:|---:|---:|---:|\n",
    );
    for path in paths {
        let Path { necessary, found, .. } = path;
        let (name, limit) = (named(path), path.instructions());
        let share = 100.0 * (limit / found);
        let _ = writeln!(page, "| {name} | {necessary} | {limit:.2} | {found:.2} | {share:.0} % |");
    }
    page
}

/// The table of times: beside limits where what was measured as the limit is one, at least as
/// fast as every path.
pub fn of_times(paths: &[Path], multiply_add: f64) -> String {
    let limits = || paths.iter().map(|path| path.nanoseconds(multiply_add));
    let is_limit =
        limits().zip(paths).all(|(limit, path)| limit.is_none_or(|one| one <= path.found));
    let mut page = format!("{}: ", processor());
    let (heads, rule) = if is_limit {
        let _ = writeln!(
            page,
            "a multiply-add takes {multiply_add:.4} ns of {LANES} numbers at once.\n"
        );
        (" limit, ns | of the limit |", "---:|---:|")
    } else {
        let _ = writeln!(
            page,
            "a path was faster than the multiply-adds that were measured as the limit, so no limit is shown.\n"
        );
        ("", "")
    };
    let _ = writeln!(
        page,
        "| path: terms of azimuths 0, 1, ... | multiply-adds | found, ns |{heads} nine-term pixels |\n\
         |---|---:|---:|{rule}---:|"
    );
    let nine = paths.first().map_or(f64::NAN, |path| path.found);
    for (path, limit) in paths.iter().zip(limits()) {
        let (name, necessary, found) = (named(path), path.necessary, path.found);
        let limit = match limit {
            _ if !is_limit => String::new(),
            Some(limit) => format!(" {limit:.3} | {:.0} % |", 100.0 * limit / found),
            None => "  |  |".to_owned(),
        };
        let of_nine = if path.pixels { format!("{:.2}", found / nine) } else { String::new() };
        let _ = writeln!(page, "| {name} | {necessary} | {found:.3} |{limit} {of_nine} |");
    }
    page
}

/// A path takes no more than this times the instructions that the page says: other compilers
/// write other code.
const MORE: f64 = 1.1;

/// A matte under light of degree 2 takes no more than this times the instructions of the nine-term
/// formula.
const OF_NINE_TERMS: f64 = 1.1;

/// Pixels in color take no more than this times the instructions of three calls and a loop.
const OF_THREE_CALLS: f64 = 1.01;

/// Limit on the instructions of a scene within a tolerance, in projections, on the default target.
const PROJECTIONS: f64 = 3.0;

/// Fails, by telling them, if paths take more instructions than the page says, or a matte under
/// light of degree 2 or pixels in color more than is promised.
pub fn check(paths: &[Path]) -> Result<(), String> {
    let page = read()?;
    let [from, to] = between(&page, COUNTS)?;
    let stated = |name: &str| {
        let row =
            page[from..to].lines().find(|row| row.split('|').nth(1).map(str::trim) == Some(name));
        row.and_then(|row| row.split('|').nth(4)?.trim().parse::<f64>().ok())
    };
    let found = |name: &str| paths.iter().find(|path| path.name == name).map(|one| one.found);
    let (Some(nine), Some(matte)) = (found(NINE), found(MATTE)) else {
        return Err(format!("{TARGET}: {NINE} and {MATTE} were not counted"));
    };
    if matte > OF_NINE_TERMS * nine {
        return Err(format!(
            "{TARGET}: {MATTE} takes {matte:.2} instructions, more than {OF_NINE_TERMS} times the {nine:.2} of {NINE}"
        ));
    }
    let (Some(within), Some(project)) = (found(WITHIN), found(PROJECT)) else {
        return Err(format!("{TARGET}: {WITHIN} and {PROJECT} were not counted"));
    };
    if LANES == 4 && within > PROJECTIONS * project {
        return Err(format!(
            "{TARGET}: {WITHIN} takes {within:.0} instructions, more than {PROJECTIONS} times the {project:.0} of {PROJECT}"
        ));
    }
    for colored in paths.iter().filter(|path| path.name.ends_with(WAYS[0])) {
        let image = colored.name.trim_end_matches(WAYS[0]);
        let three = found(&format!("{image}{}", WAYS[1]));
        if three.is_none_or(|three| colored.found > OF_THREE_CALLS * three) {
            let Path { name, found, .. } = colored;
            return Err(format!(
                "{TARGET}: {name} takes {found:.2} instructions, more than {OF_THREE_CALLS} times {three:?}"
            ));
        }
    }
    let worse = paths.iter().filter_map(|path| {
        let (name, found) = (named(path), path.found);
        match stated(&name) {
            None => Some(format!("{TARGET}: {name} is not on the page")),
            Some(stated) if found > MORE * stated + 0.05 => {
                Some(format!("{TARGET}: {name} takes {found:.2} instructions, not {stated}"))
            }
            Some(_) => None,
        }
    });
    let worse: Vec<_> = worse.collect();
    if worse.is_empty() { Ok(()) } else { Err(worse.join("\n")) }
}

/// Puts a table between its marks.
pub fn write(kind: &str, table: &str) -> Result<(), String> {
    let page = read()?;
    let [from, to] = between(&page, kind)?;
    let page = format!("{}{table}{}", &page[..from], &page[to..]);
    std::fs::write(PAGE, page).map_err(|fault| fault.to_string())
}

const PAGE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/performance.md");

fn read() -> Result<String, String> {
    std::fs::read_to_string(PAGE).map_err(|fault| fault.to_string())
}

/// Where the target's table of a kind begins and ends.
fn between(page: &str, kind: &str) -> Result<[usize; 2], String> {
    let find =
        |mark: &str| page.find(mark).ok_or_else(|| format!("docs/performance.md lacks {mark}"));
    let start = format!("<!-- {kind}, {TARGET} -->\n");
    Ok([find(&start)? + start.len(), find(&format!("<!-- end of {kind}, {TARGET} -->"))?])
}
