//! Generated tables of handwritten pages.
//!
//! A table is enclosed by `<!-- NAME -->` and `<!-- end of NAME -->`, each on its own line.

use crate::sheet::{Record, Sheet};
use eigenshade_cli::output;
use eigenshade_model::error::{self, Error};
use std::fs;
use std::path::Path;

/// A table's name and its text, which consists of whole lines.
pub type Part = (&'static str, String);

/// A table with these columns, which ` | ` separates. A colon at the end aligns one right.
pub fn table(columns: &str, rows: impl IntoIterator<Item = Vec<String>>) -> String {
    let mut text = format!("| {} |\n|", columns.replace(": |", " |").trim_end_matches(':'));
    for name in columns.split(" | ") {
        text += if name.ends_with(':') { "---:|" } else { "---|" };
    }
    for cells in rows {
        // An unescaped bar would end the cell.
        let cells: Vec<String> = cells.iter().map(|cell| cell.replace('|', "\\|")).collect();
        text += &format!("\n| {} |", cells.join(" | "));
    }
    text + "\n"
}

/// The table of a CSV as it is. Columns without words are aligned right.
pub fn table_of(sheet: &Sheet) -> String {
    let is_number =
        |cell: &&str| !cell.starts_with(|letter: char| letter.is_alphabetic() || letter == '`');
    let column = |name: &String| {
        let is_right = sheet.texts(name).iter().all(is_number);
        format!("{name}{}", if is_right { ":" } else { "" })
    };
    let columns: Vec<String> = sheet.columns.iter().map(column).collect();
    let cells = |row: &Record| sheet.columns.iter().map(|name| row.text(name).to_owned()).collect();
    table(&columns.join(" | "), sheet.rows.iter().map(cells))
}

/// Writes the tables into the page.
pub fn fill(page: &Path, parts: &[Part]) -> error::Result<()> {
    let text = fs::read_to_string(page).map_err(|error| Error::io(page, &error))?;
    let text = with_parts(&text, parts)
        .map_err(|fault| Error::new(fault, "restore these markers").in_file(page))?;
    output::write_all(Some(page), text)
}

/// Returns the page with the text of each part replaced, or the markers that it lacks.
fn with_parts(page: &str, parts: &[Part]) -> Result<String, String> {
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
    fn a_table_has_the_rows_of_its_csv() {
        let sheet = Sheet::parse("# c\na,b,c\nx,1,|u|\n,< 2,3\n", "a.csv").unwrap();
        let text = "| a | b | c |\n|---|---:|---:|\n| x | 1 | \\|u\\| |\n|  | < 2 | 3 |\n";
        assert_eq!(table_of(&sheet), text);
    }
}
