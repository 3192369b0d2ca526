//! The tables of docs/performance.md.

use crate::counts::Count;
use crate::limit::{LANES, TARGET};
use crate::times::Times;
use std::fmt::Write as _;
use std::path::PathBuf;

/// What the page's marks call the tables.
pub const TIMES: &str = "times";
/// See [`TIMES`].
pub const COUNTS: &str = "counts";

fn named(name: &str, lengths: &[u16]) -> String {
    if lengths.is_empty() {
        return name.to_owned();
    }
    let lengths: Vec<_> = lengths.iter().map(ToString::to_string).collect();
    format!("{name}: {}", lengths.join(" "))
}

/// The processor, as it calls itself.
fn processor() -> String {
    let told = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let of = |key: &str| {
        let line = told.lines().find(|line| line.starts_with(key))?;
        Some(line.split_once(':')?.1.trim().to_owned())
    };
    let named = of("model name").unwrap_or_else(|| std::env::consts::ARCH.to_owned());
    match (of("cpu family"), of("model\t")) {
        (Some(family), Some(model)) => format!("{named} (family {family}, model {model})"),
        _ => named,
    }
}

/// The table of instructions.
pub fn of_counts(counts: &[Count]) -> String {
    let mut page = String::from(
        "| path: terms of azimuths 0, 1, ... | multiply-adds | limit, instructions | found | of the limit |\n\
         |---|---:|---:|---:|---:|\n",
    );
    for count in counts {
        let Count { name, lengths, necessary, found } = count;
        let (name, limit, share) = (named(name, lengths), count.limit(), 100.0 * count.share());
        let _ = writeln!(page, "| {name} | {necessary} | {limit:.2} | {found:.2} | {share:.0} % |");
    }
    page
}

/// The table of times.
pub fn of_times(times: &Times) -> String {
    let Times { ways, multiply_add } = times;
    let mut page = format!(
        "{}: a multiply-add takes {multiply_add:.4} ns of {LANES} numbers at once.\n\n\
         | path: terms of azimuths 0, 1, ... | multiply-adds | limit, ns | found, ns | of the limit | nine-term pixels |\n\
         |---|---:|---:|---:|---:|---:|\n",
        processor()
    );
    let nine = ways.first().map_or(f64::NAN, |way| way.found);
    for way in ways {
        let limit = way.necessary as f64 * multiply_add / LANES as f64;
        let [limit, share] = if way.vectors {
            [format!("{limit:.3}"), format!("{:.0} %", 100.0 * limit / way.found)]
        } else {
            [(); 2].map(|()| String::new())
        };
        let of_nine = if way.pixels { format!("{:.2}", way.found / nine) } else { String::new() };
        let (name, necessary, found) = (named(&way.name, &way.lengths), way.necessary, way.found);
        let _ =
            writeln!(page, "| {name} | {necessary} | {limit} | {found:.3} | {share} | {of_nine} |");
    }
    page
}

/// A path takes no more than this times the instructions that the page says: other compilers
/// write other code.
const MORE: f64 = 1.1;

/// Fails, by telling them, if paths take more instructions than the page says.
pub fn check(counts: &[Count]) -> Result<(), String> {
    let page = std::fs::read_to_string(path()).map_err(|fault| fault.to_string())?;
    let [from, to] = between(&page, COUNTS)?;
    let stated = |name: &str| {
        let row =
            page[from..to].lines().find(|row| row.split('|').nth(1).map(str::trim) == Some(name));
        row.and_then(|row| row.split('|').nth(4)?.trim().parse::<f64>().ok())
    };
    let worse: Vec<_> = counts
        .iter()
        .filter_map(|count| {
            let (name, found) = (named(&count.name, &count.lengths), count.found);
            match stated(&name) {
                None => Some(format!("{TARGET}: {name} is not on the page")),
                Some(stated) if found > MORE * stated + 0.05 => {
                    Some(format!("{TARGET}: {name} takes {found:.2} instructions, not {stated}"))
                }
                Some(_) => None,
            }
        })
        .collect();
    if worse.is_empty() { Ok(()) } else { Err(worse.join("\n")) }
}

/// Puts a table between its marks.
pub fn write(kind: &str, table: &str) -> Result<(), String> {
    let page = std::fs::read_to_string(path()).map_err(|fault| fault.to_string())?;
    let [from, to] = between(&page, kind)?;
    let page = format!("{}{table}{}", &page[..from], &page[to..]);
    std::fs::write(path(), page).map_err(|fault| fault.to_string())
}

fn path() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../docs/performance.md")
}

/// Where the target's table of a kind begins and ends.
fn between(page: &str, kind: &str) -> Result<[usize; 2], String> {
    let find =
        |mark: &str| page.find(mark).ok_or_else(|| format!("docs/performance.md lacks {mark}"));
    let start = format!("<!-- {kind}, {TARGET} -->\n");
    Ok([find(&start)? + start.len(), find(&format!("<!-- end of {kind}, {TARGET} -->"))?])
}
