//! The tables of counts in the documentation, written between two marks and compared by `--check`;
//! and the list of the programs for cargo.

use crate::Result;
use crate::frames;
use crate::list;
use crate::program::{Board, COUNTED};
use crate::row::{self, Row};

const START: &str = "<!-- counts: firmware/run all --update writes them -->\n";
const END: &str = "<!-- end of counts -->\n";

/// The pages, and the formats that each shows. An empty list means the table of
/// frames.
const PAGES: [(&str, &[&str]); 2] = [("../README.md", &[]), ("../docs/costs.md", &["f32", "q15"])];

/// The page with the descriptions of the operations.
const DESCRIPTIONS: &str = "../docs/costs.md";
const DESCRIPTIONS_START: &str = "<!-- operations: firmware/run pages writes them -->\n";
const DESCRIPTIONS_END: &str = "<!-- end of operations -->\n";

/// The list of the programs, and what is before and after it.
const PROGRAMS: [&str; 3] = ["programs/Cargo.toml", "bin = [\n", "]\n"];

/// The page of the watch's frames, and its marks.
const WATCH: &str = "../crates/embedded-graphics/README.md";
const WATCH_START: &str = "<!-- frames: firmware/run all --update writes them -->\n";
const WATCH_END: &str = "<!-- end of frames -->\n";

/// Writes the recorded counts into the pages, and the list of the programs.
pub fn write() -> Result<()> {
    write_programs()?;
    for (path, text) in pages()? {
        std::fs::write(path, text).map_err(|error| format!("{path}: {error}"))?;
    }
    Ok(())
}

/// Writes the list of the programs, which cargo needs to build them.
pub fn write_programs() -> Result<()> {
    let [path, ..] = PROGRAMS;
    let (old, new) = (read(path)?, programs()?);
    if old == new {
        return Ok(());
    }
    std::fs::write(path, new).map_err(|error| format!("{path}: {error}"))
}

/// The manifest with the list of the programs.
fn programs() -> Result<String> {
    let [path, start, end] = PROGRAMS;
    let line = |one: &list::Program| {
        format!("    {{ name = \"{}\", path = \"src/{}\" }},\n", one.name(), one.file())
    };
    let lines: String = list::programs().iter().map(line).collect();
    between(path, &read(path)?, [start, end], &lines)
}

fn pages() -> Result<Vec<(&'static str, String)>> {
    let (_, rows) = row::read(row::RECORD)?;
    let mut pages = Vec::new();
    for (path, formats) in PAGES {
        let table = if formats.is_empty() { frames::ways(&rows)? } else { table(&rows, formats) };
        let mut page = between(path, &read(path)?, [START, END], &table)?;
        if path == DESCRIPTIONS {
            page = between(path, &page, [DESCRIPTIONS_START, DESCRIPTIONS_END], &descriptions())?;
        }
        pages.push((path, page));
    }
    let of_objects =
        between(WATCH, &read(WATCH)?, [WATCH_START, WATCH_END], &frames::objects(&rows))?;
    pages.push((WATCH, of_objects));
    Ok(pages)
}

/// Compares the pages with the recorded counts.
pub fn check() -> Result<()> {
    for (path, text) in pages()? {
        if text != read(path)? {
            return Err(format!(
                "{path}: the counts differ from counts.csv; run `firmware/run pages`"
            ));
        }
    }
    Ok(())
}

fn read(path: &str) -> Result<String> {
    std::fs::read_to_string(path).map_err(|error| format!("{path}: {error}"))
}

/// A page with this table between two marks.
fn between(path: &str, page: &str, [start, end]: [&str; 2], table: &str) -> Result<String> {
    let parts = page
        .split_once(start)
        .and_then(|(before, rest)| rest.split_once(end).map(|(_, after)| (before, after)));
    let (before, after) =
        parts.ok_or(format!("{path}: the marks around the counts are missing"))?;
    Ok(format!("{before}{start}{table}{end}{after}"))
}

/// A line for each operation and format: instructions on each board, and memory.
fn table(rows: &[Row], formats: &[&str]) -> String {
    let mut text = String::from("| operation | format |");
    for board in COUNTED {
        text += &format!(" {} |", board.processor);
    }
    text += " flash | RAM | stack |\n|---|---|---:|---:|---:|---:|---:|\n";
    let mut keys: Vec<&[String]> = Vec::new();
    let shown = |row: &&Row| !row.is_of_scene() && formats.contains(&row.key[2].as_str());
    for row in rows.iter().filter(shown) {
        if !keys.contains(&&row.key[1..]) {
            keys.push(&row.key[1..]);
        }
    }
    keys.sort_by_key(|key| formats.iter().position(|format| *format == key[1]));
    for key in keys {
        let on =
            |board: Board| rows.iter().find(|row| row.key[0] == board.name && row.key[1..] == *key);
        text += &format!("| `{}` | `{}` |", key[0], key[1]);
        for board in COUNTED {
            text += &cell(on(board).and_then(|row| row.numbers[0]));
        }
        let memory = COUNTED.into_iter().find_map(on).map_or([None; 4], |row| row.numbers);
        text += &memory[1..].iter().map(|number| cell(*number)).collect::<String>();
        text += "\n";
    }
    text
}

/// A line for each operation that is counted.
fn descriptions() -> String {
    let counted =
        list::operations().filter(|one| !["empty", "golden", "readme"].contains(&one.source));
    let lines = counted.map(|one| format!("| `{}` | {} |\n", one.name, one.description));
    ["| operation | |\n|---|---|\n".into()].into_iter().chain(lines).collect()
}

/// A number with commas between thousands.
fn cell(number: Option<u64>) -> String {
    let digits = number.map_or(String::new(), |number| number.to_string());
    let mut text = String::new();
    for (place, digit) in digits.chars().enumerate() {
        if place > 0 && (digits.len() - place).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    format!(" {text} |")
}

#[cfg(test)]
mod tests {
    use super::{END, PROGRAMS, START, between, programs, read, table};
    use crate::row::Row;

    #[test]
    fn a_line_has_each_board_and_the_memory_of_the_smallest() {
        let rows: Vec<Row> =
            ["microbit,shade,q15,811,9928,604,224", "mps2-an386,shade,q15,1873,8196,5,6"]
                .map(|line| line.parse().unwrap())
                .into();
        let page = format!("a\n{START}old\n{END}b\n");
        let page = between("page", &page, [START, END], &table(&rows, &["q15"])).unwrap();
        assert!(page.contains("| `shade` | `q15` | 811 | 1,873 | 9,928 | 604 | 224 |\n"), "{page}");
        assert!(page.starts_with("a\n") && page.ends_with("b\n") && !page.contains("old"));
        assert_eq!(table(&rows, &["f32"]).lines().count(), 2);
        let of_scene = ["microbit,sun/pixel,q15,811,,,224".parse().unwrap()];
        assert_eq!(table(&of_scene, &["q15"]).lines().count(), 2);
        assert!(between("page", "no marks", [START, END], "").unwrap_err().contains("page"));
    }

    #[test]
    fn the_manifest_lists_the_programs() {
        std::env::set_current_dir("..").unwrap();
        assert_eq!(read(PROGRAMS[0]), programs(), "run `firmware/run pages`");
    }
}
