//! The CSV files of results, which `report pages` shows in README.md.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

/// What was found about one path or method.
pub struct Row {
    /// Its cells in the first columns.
    pub name: Vec<String>,
    /// Numbers by column.
    pub cells: Vec<(String, f64)>,
}

fn path(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(file)
}

/// The cells of a file by name and column. The first `names` columns are the name of a row.
fn read(file: &str, names: usize) -> HashMap<(Vec<String>, String), String> {
    let mut reader = csv::Reader::from_path(path(file)).expect("a file of results");
    let columns = reader.headers().expect("a header").clone();
    let mut cells = HashMap::new();
    for record in reader.records().map(|record| record.expect("a row")) {
        let name: Vec<String> = record.iter().take(names).map(str::to_owned).collect();
        for (column, cell) in columns.iter().zip(&record).skip(names) {
            cells.insert((name.clone(), column.to_owned()), cell.to_owned());
        }
    }
    cells
}

/// Replaces the rows of a file. Cells that were not measured keep their text.
pub fn write(file: &str, columns: &[&str], rows: &[Row], text: fn(f64) -> String) {
    let names = rows.first().map_or(0, |row| row.name.len());
    let old = read(file, names);
    let mut writer = csv::Writer::from_path(path(file)).expect("a file of results");
    writer.write_record(columns).expect("room");
    for row in rows {
        let cell = |column: &&str| {
            let found = row.cells.iter().find(|(name, _)| name == column);
            let kept = || old.get(&(row.name.clone(), (*column).to_owned())).cloned();
            found.map(|(_, value)| text(*value)).or_else(kept).unwrap_or_default()
        };
        let cells = columns[names..].iter().map(cell);
        writer.write_record(row.name.iter().cloned().chain(cells)).expect("room");
    }
    writer.flush().expect("room");
}

/// Compares with a file, and returns whether all numbers agree with it. Prints those that do not.
pub fn check(file: &str, rows: &[Row], agrees: fn(stated: f64, found: f64) -> bool) -> bool {
    let old = read(file, rows.first().map_or(0, |row| row.name.len()));
    let mut holds = true;
    for row in rows {
        for (column, found) in &row.cells {
            let stated = old.get(&(row.name.clone(), column.clone()));
            if !stated.and_then(|cell| cell.parse().ok()).is_some_and(|cell| agrees(cell, *found)) {
                let (name, stated) = (row.name.join(", "), stated.map_or("no cell", |cell| cell));
                eprintln!("{name}, {column}: {found:.4e}, but benches/{file} has {stated}");
                holds = false;
            }
        }
    }
    holds
}
