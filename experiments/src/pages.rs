//! Generated parts of handwritten pages: inserting them, and comparing them with a new measurement.
//!
//! A part is enclosed by `<!-- NAME -->` and `<!-- end of NAME -->`, each on its own line.

use clap::Args;
use eigenshade_cli::output;
use eigenshade_model::error::{self, Error};
use std::fs;
use std::path::{Path, PathBuf};

/// A part's name and its text, which consists of whole lines.
pub type Part = (&'static str, String);

/// A page of `docs/` with generated parts.
pub struct Page {
    /// The page's name, which is also the name of the command that regenerates its parts.
    pub name: &'static str,
    /// Whether a recorded word is the same as a new one, given the recorded line.
    pub same: fn(line: &str, old: &str, new: &str) -> bool,
}

impl Page {
    /// Inserts the parts into the page of `--out`, or compares them with the page of `--check`.
    pub fn write_or_compare(&self, purpose: &Purpose, parts: &[Part]) -> error::Result<()> {
        let Some(path) = purpose.out.as_ref().or(purpose.check.as_ref()) else { return Ok(()) };
        let (text, name) = (filled(path, parts)?, self.name);
        let command = format!("cargo run --release -p experiments -- {name} --out docs/{name}.md");
        purpose.write_or_compare(&text, &command, |old, new| compare_words(old, new, self.same))
    }
}

/// Whether a command writes its output or compares it with an existing file: one of the two.
#[derive(Args, Debug)]
#[group(required = true, multiple = false)]
pub struct Purpose {
    /// Write to this folder or file
    #[arg(long, value_name = "PATH")]
    pub out: Option<PathBuf>,
    /// Compare this folder or file with the current measurements
    #[arg(long, value_name = "PATH")]
    pub check: Option<PathBuf>,
}

impl Purpose {
    /// Writes `text` to `--out`, or compares it with the file of `--check`: `compare(recorded,
    /// text)` returns the first difference. `command` is the command that rewrites the file.
    pub fn write_or_compare(
        &self,
        text: &str,
        command: &str,
        compare: impl Fn(&str, &str) -> Result<(), String>,
    ) -> error::Result<()> {
        if let Some(path) = &self.out {
            output::write_all(Some(path), text)?;
        }
        if let Some(path) = &self.check {
            let recorded = fs::read_to_string(path).map_err(|error| Error::io(path, &error))?;
            compare(&recorded, text).map_err(|fault| {
                Error::new(fault, format!("make it again with `{command}`")).in_file(path)
            })?;
        }
        Ok(())
    }
}

/// A table with these columns, which ` | ` separates. A colon at the end aligns one right.
pub fn table(columns: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut text = format!("| {} |\n|", columns.replace(": |", " |").trim_end_matches(':'));
    for name in columns.split(" | ") {
        text += if name.ends_with(':') { "---:|" } else { "---|" };
    }
    let rows = rows.into_iter().map(|cells| format!("\n| {} |", cells.join(" | ")));
    text + &rows.collect::<String>() + "\n"
}

/// The page in a file with the text of each part replaced.
pub fn filled(path: &Path, parts: &[Part]) -> error::Result<String> {
    let page = fs::read_to_string(path).map_err(|error| Error::io(path, &error))?;
    with_parts(&page, parts)
        .map_err(|fault| Error::new(fault, "restore these markers").in_file(path))
}

/// Returns the page with the text of each part replaced, or the markers that it lacks.
pub fn with_parts(page: &str, parts: &[Part]) -> Result<String, String> {
    let mut page = page.to_owned();
    for (name, text) in parts {
        let (begin, end) = (format!("<!-- {name} -->\n"), format!("<!-- end of {name} -->\n"));
        let places = page.find(&begin).map(|at| at + begin.len()).zip(page.find(&end));
        let (start, stop) = places.filter(|(start, stop)| start <= stop).ok_or_else(|| {
            format!("the lines `{}` and `{}` are missing", begin.trim(), end.trim())
        })?;
        page.replace_range(start..stop, text);
    }
    Ok(page)
}

/// Compares texts word by word: `same(recorded line, old, new)`. Fails at the first difference.
pub fn compare_words(
    recorded: &str,
    now: &str,
    mut same: impl FnMut(&str, &str, &str) -> bool,
) -> Result<(), String> {
    let (old, new): (Vec<_>, Vec<_>) = (recorded.lines().collect(), now.lines().collect());
    for (line, (old, new)) in old.iter().zip(&new).enumerate() {
        let fault = |old, new| Err(format!("line {}: recorded `{old}`, now `{new}`", line + 1));
        let [before, after] = [old, new].map(|line| line.split_whitespace().collect::<Vec<_>>());
        if let Some((a, b)) = before.iter().zip(&after).find(|(a, b)| !same(old, a, b)) {
            return fault(*a, *b);
        }
        if before.len() != after.len() {
            return fault(*old, *new);
        }
    }
    if old.len() == new.len() { Ok(()) } else { Err("the number of lines differs".into()) }
}

/// Whether a recorded word and the current one are the same. Words with an exponent or a percent
/// sign are numbers and must be `near` each other (recorded, now). Words that begin with × are
/// ratios of times and are not compared. All other words must be equal.
pub fn same_word(old: &str, new: &str, near: impl Fn(f64, f64) -> bool) -> bool {
    match (number(old), number(new)) {
        (Some(old), Some(new)) => near(old, new),
        _ => old == new || old.starts_with('×') && new.starts_with('×'),
    }
}

fn number(word: &str) -> Option<f64> {
    let word = word.trim_end_matches([',', '.', ';']);
    if let Some(share) = word.strip_suffix('%') {
        return share.parse::<f64>().ok().map(|share| 1e-2 * share);
    }
    if word.contains('e') { word.parse().ok() } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_replaced_between_their_markers() {
        let page = "a\n<!-- t -->\nold\n<!-- end of t -->\nb\n";
        let made = with_parts(page, &[("t", "new\nlines\n".into())]);
        assert_eq!(made.as_deref(), Ok("a\n<!-- t -->\nnew\nlines\n<!-- end of t -->\nb\n"));
        assert!(with_parts(page, &[("u", String::new())]).is_err());
    }

    #[test]
    fn a_table_has_a_row_for_each_list_of_cells() {
        let text =
            table("a | b:", [["x", "1"], ["y", "2"]].map(|row| row.map(Into::into).to_vec()));
        assert_eq!(text, "| a | b |\n|---|---:|\n| x | 1 |\n| y | 2 |\n");
    }

    #[test]
    fn words_are_equal_and_numbers_near() {
        let compare = |old: &str, new: &str| {
            let near = |old: f64, new: f64| (old - new).abs() <= 0.1 * old;
            compare_words(old, new, |_, old, new| same_word(old, new, near))
        };
        for (old, new) in [
            ("1.0e-3 a", "1.05e-3 a"),
            ("1e-3, b", "1.05e-3, b"),
            ("10 %", "10 %"),
            ("10%;", "10.5%;"),
        ] {
            assert_eq!(compare(old, new), Ok(()), "{old}");
        }
        assert_eq!(compare("×1.2 b", "×7 b"), Ok(()));
        for (old, new) in [("1e-3", "2e-3"), ("a", "b"), ("1", "2"), ("a", "a\nb"), ("1e-3", "x")] {
            assert!(compare(old, new).is_err(), "{old}");
        }
    }
}
