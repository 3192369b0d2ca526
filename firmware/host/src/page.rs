//! The tables of counts in the documentation, written between two marks and compared by `--check`;
//! and the list of the programs for cargo.

use crate::Result;
use crate::list;
use crate::program::{AN386, Board, COUNTED, MICROBIT};
use crate::row::{self, Row};

const START: &str = "<!-- counts: firmware/run all --update writes them -->\n";
const END: &str = "<!-- end of counts -->\n";

/// The pages, and the formats that each shows. An empty list means the [`SHORT`] table.
const PAGES: [(&str, &[&str]); 2] = [("../README.md", &[]), ("../docs/costs.md", &["f32", "q15"])];

/// The rows of the short table: an operation and its description.
const SHORT: [(&str, &str); 7] = [
    ("nine_terms", "a pixel, matte material, light of degree 2, no table"),
    ("shade", "a pixel of any material, 130 components to 1e-4"),
    ("gold", "a pixel of the gold sphere, in color, to RGB565"),
    ("palette_row", "240 pixels of an object from a palette of its normals, to RGB565"),
    ("frame", "a frame of the gold sphere of 240 x 240 pixels under a turned light"),
    ("relight_collapse", "a new light on a transferred material, 46 components"),
    ("transfer", "a new material, 46 components"),
];

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

/// Chips with the processors of the boards: name, board, number format, clock in MHz.
const CHIPS: [(&str, Board, &str, u64); 3] = [
    ("RP2040, Cortex-M0+", MICROBIT, "q15", 133),
    ("nRF52840, Cortex-M4F", AN386, "f32", 64),
    ("STM32F411, Cortex-M4F", AN386, "f32", 100),
];

/// The operations that are a frame, and their objects.
const FRAMES: [(&str, &str); 6] = [
    ("watch", "the watch, 128 x 128"),
    ("watch_240", "240 x 240"),
    ("watch_240_still", "light at rest"),
    ("frame", "a sphere of gold, 240 x 240"),
    ("frame_sources", "with 4 sources"),
    ("frame_textured", "textured"),
];

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
        let feature = if one.needs_tables() { ", required-features = [\"tables\"]" } else { "" };
        format!("    {{ name = \"{}\", path = \"src/{}\"{feature} }},\n", one.name(), one.file())
    };
    let lines: String = list::programs().iter().map(line).collect();
    between(path, &read(path)?, [start, end], &lines)
}

fn pages() -> Result<Vec<(&'static str, String)>> {
    let (_, rows) = row::read(row::RECORD)?;
    let mut pages = Vec::new();
    for (path, formats) in PAGES {
        let table = if formats.is_empty() { short(&rows) } else { table(&rows, formats) };
        let mut page = between(path, &read(path)?, [START, END], &table)?;
        if path == DESCRIPTIONS {
            page = between(path, &page, [DESCRIPTIONS_START, DESCRIPTIONS_END], &descriptions())?;
        }
        pages.push((path, page));
    }
    let frames = between(WATCH, &read(WATCH)?, [WATCH_START, WATCH_END], &frames(&rows))?;
    pages.push((WATCH, frames));
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

/// Frames per second if an instruction takes a cycle.
fn frames(rows: &[Row]) -> String {
    let mut text = String::from("| frames a second, at most |");
    text.extend(FRAMES.map(|(_, object)| format!(" {object} |")));
    text += &format!("\n|---|{}\n", "---:|".repeat(FRAMES.len()));
    for (chip, board, format, megahertz) in CHIPS {
        text += &format!(
            "| {chip}, {megahertz} MHz, {} |",
            if format == "f32" { "f32" } else { "Q15" }
        );
        for (operation, _) in FRAMES {
            let instructions = row::instructions(rows, [board.name, operation, format]);
            let rate =
                instructions.map(|instructions| megahertz as f64 * 1e6 / instructions as f64);
            text += &rate.map_or(" |".into(), |rate| format!(" {rate:.1} |"));
        }
        text.push('\n');
    }
    text
}

/// Instructions of a few operations, in Q15 without a float unit and in f32 with one.
fn short(rows: &[Row]) -> String {
    let mut text = String::from(
        "| instructions, one channel where not stated | Cortex-M0, Q15 | Cortex-M4F, f32 |\n|---|---:|---:|\n",
    );
    for (operation, what) in SHORT {
        text += &format!("| {what} |");
        for (board, format) in COUNTED.into_iter().zip(["q15", "f32"]) {
            text += &cell(row::instructions(rows, [board.name, operation, format]));
        }
        text += "\n";
    }
    text
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
    use super::{END, PROGRAMS, START, between, frames, programs, read, table};
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

    #[test]
    fn frames_are_the_clock_by_the_instructions() {
        let rows = ["microbit,watch,q15,26600000,1,1,1".parse().unwrap()];
        let text = frames(&rows);
        assert!(text.contains("| RP2040, Cortex-M0+, 133 MHz, Q15 | 5.0 | |\n"), "{text}");
        assert!(text.contains("| nRF52840, Cortex-M4F, 64 MHz, f32 | | |\n"), "{text}");
    }
}
