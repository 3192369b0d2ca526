//! What the page shows: its tables against the file, its charts and its links.

use super::{MACHINES, docs, number, read, sheet};
use crate::tolerances;
use std::collections::HashMap;
use std::fs;

/// The errors that the page's tables ask for.
const LIMITS: [f64; 7] = [0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4, 1e-5];

/// Columns of the file, as the page's tables show them from the third column on.
const ERRORS: [&str; 4] =
    ["unseen_rms_median", "unseen_rms_most", "unseen_rms_worst", "unseen_largest_worst"];

/// The part of the page below a title.
fn section<'a>(page: &'a str, title: &str) -> &'a str {
    let start = page.find(&format!("\n## {title}\n")).unwrap_or_else(|| panic!("no {title}"));
    let rest = &page[start + 4..];
    rest.find("\n## ").map_or(rest, |end| &rest[..end])
}

/// Tables of a part of the page, by row.
fn tables(text: &str) -> Vec<Vec<Vec<String>>> {
    let mut tables: Vec<Vec<Vec<String>>> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if !line.starts_with("| ") {
            inside = false;
            continue;
        }
        if !inside {
            tables.push(Vec::new());
            inside = true;
        }
        let fields = line.trim_matches('|').split(" | ").map(|field| field.trim().to_owned());
        tables.last_mut().expect("a table").push(fields.collect());
    }
    tables
}

/// A number of the page: grouped, or in per cent.
fn stated(text: &str) -> f64 {
    let (text, scale) = text.strip_suffix(" %").map_or((text, 1.0), |text| (text, 0.01));
    scale * text.replace(',', "").parse::<f64>().unwrap_or_else(|_| panic!("{text}"))
}

/// Each row of the page's tables is in the file, its error is below the limit, nothing in the
/// file does it for less, and nothing better for as much.
#[test]
fn the_page_takes_the_cheapest_that_suffices() {
    let (page, rows) = (read("accuracy-cost.md"), sheet("accuracy-cost.csv"));
    let mut checked = 0;
    for (title, key) in MACHINES {
        for (number_of_table, table) in tables(section(&page, title)).iter().enumerate() {
            assert_eq!(table.len(), 2 + LIMITS.len(), "{title}");
            for (fields, limit) in table[2..].iter().zip(LIMITS) {
                assert!((stated(&fields[0]) / limit - 1.0).abs() < 1e-9, "{title}: {fields:?}");
                let frame = |row: &HashMap<String, String>| {
                    let pixels = 9216.0 * number(row, &format!("{key}_pixel"))?;
                    match number_of_table {
                        0 => Some(pixels),
                        _ => Some(pixels + number(row, &format!("{key}_light"))?),
                    }
                };
                let suffices = |row: &&HashMap<String, String>| {
                    let of_paper = row["degree"] == "9" && row["order"] == "7";
                    let modelled = number(row, "model_median").is_some_and(|one| one <= limit);
                    let error = number(row, "unseen_rms_most").expect("an error");
                    row["knob"] != "mathematics" && error <= limit && (of_paper || modelled)
                };
                let able = rows.iter().filter(suffices);
                let costs = able.filter_map(|row| frame(row).map(|cost| (cost, row)));
                let least = costs.min_by(|a, b| a.0.total_cmp(&b.0));
                let Some((cost, _)) = least else {
                    assert_eq!(fields[2], "—", "{title}: {fields:?}");
                    continue;
                };
                // The file has four digits, the page two of errors.
                let near = |a: f64, b: f64| (a / b - 1.0).abs() <= tolerances::STATED;
                let taken = rows.iter().filter(suffices).find(|row| {
                    frame(row).is_some_and(|other| (stated(&fields[9]) / other - 1.0).abs() < 1e-3)
                        && ERRORS.iter().zip(&fields[2..]).all(|(column, field)| {
                            near(stated(field), number(row, column).expect("an error"))
                        })
                        && number(row, "table_bytes") == Some(stated(&fields[10]))
                });
                let taken = taken.unwrap_or_else(|| panic!("{title}: {fields:?}"));
                // Times that are nearly the least are as good; the least error decides.
                let tie = if ["host", "wasm"].contains(&key) { 1.05 } else { 1.0 };
                assert!(frame(taken).expect("a cost") < tie * cost * 1.001, "{title}: {fields:?}");
                let error = |row: &HashMap<String, String>| {
                    let model = number(row, "model_median").unwrap_or(f64::INFINITY);
                    model.max(number(row, "unseen_rms_most").expect("an error"))
                };
                for row in rows.iter().filter(suffices) {
                    let ties = frame(row).is_some_and(|other| other < tie * cost / 1.001);
                    assert!(
                        !ties || error(row) > error(taken) * 0.999,
                        "{title}: {}",
                        row["setting"]
                    );
                }
                assert!(stated(&fields[3]) <= limit * (1.0 + tolerances::STATED));
                checked += 1;
            }
        }
    }
    assert!(checked > 30, "{checked}");
}

/// What a reader does who has the page alone: a Cortex-M4F, pictures of 96 x 96 pixels with an
/// error below one per cent. 60 a second where the light stands still; 20 at least where it moves.
#[test]
fn a_reader_finds_a_setting_for_a_board() {
    let page = read("accuracy-cost.md");
    let tables = tables(section(&page, "Cortex-M4F"));
    assert_eq!(tables.len(), 2);
    let minute = section(&page, "In a minute");
    assert!(minute.contains("1,066,667"));
    for (table, moves) in tables.iter().zip([false, true]) {
        let header = table[0].join(" ");
        assert!(header.contains("instructions") && header.contains("96 x 96 pixels"));
        let row = table.iter().find(|row| row[0] == "1 %").expect("a row");
        let (instructions, error) = (stated(&row[9]), stated(&row[3]));
        let pictures = if moves { 20.0 } else { 60.0 };
        assert!(instructions <= 64e6 / pictures && error <= 0.01, "{row:?}");
        let light = if moves { stated(&row[8]) } else { 0.0 };
        assert_eq!(instructions, 9216.0 * stated(&row[7]) + light, "{row:?}");
        let share =
            format!("{}: {:.0} % of the cycles", row[9], 100.0 * instructions * 60.0 / 64e6);
        assert!(minute.contains(&row[1]) && minute.contains(&share), "{share}: {minute}");
    }
}

/// Every board has an answer down to 0.1 % for light that changes with every picture, and says
/// what the program takes.
#[test]
fn boards_have_rows_for_moving_light() {
    let page = read("accuracy-cost.md");
    for (title, _) in &MACHINES[1..5] {
        let table = &tables(section(&page, title))[1];
        assert_eq!(table[0][12..], ["program: flash", "RAM and stack"], "{title}");
        for row in &table[2..] {
            let is_there = row[8] != "—";
            assert!(is_there || ["1e-4", "1e-5"].contains(&&*row[0]), "{title}: {row:?}");
            if is_there {
                let [light, flash, ram] = [8, 12, 13].map(|column| stated(&row[column]));
                assert!(light > 100.0 && flash > 1e4 && ram > 300.0, "{title}: {row:?}");
            }
        }
    }
}

/// No words of a chart lie upon others, and all are within it.
#[test]
fn words_of_charts_keep_apart() {
    let attribute = |line: &str, name: &str| -> Option<f64> {
        line.split(&format!(" {name}=\"")).nth(1)?.split('"').next()?.parse().ok()
    };
    let mut seen = 0;
    for (_, key) in MACHINES {
        let svg = read(&format!("{key}.svg"));
        let mut frames: Vec<([f64; 4], String)> = Vec::new();
        let mut lines = svg.lines();
        while let Some(line) = lines.next() {
            if !line.starts_with("<text") || line.contains("rotate") {
                continue;
            }
            let word = lines.next().unwrap_or_default().to_owned();
            let (x, y) = (attribute(line, "x").unwrap(), attribute(line, "y").unwrap());
            let (size, width) = (15.3, 0.5 * 15.3 * word.chars().count() as f64);
            let left = match line {
                line if line.contains("\"middle\"") => x - 0.5 * width,
                line if line.contains("\"end\"") => x - width,
                _ => x,
            };
            assert!(left > -2.0 && left + width < 730.0, "{key}: {word}");
            let frame = [left, y - 0.5 * size, left + width, y + 0.5 * size];
            for ([a, b, c, d], other) in &frames {
                let [e, f, g, h] = frame;
                let meet = *a < g && e < *c && *b < h - 4.0 && f + 4.0 < *d;
                assert!(!meet, "{key}: `{word}` upon `{other}`");
            }
            frames.push((frame, word));
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
}

#[test]
fn all_that_the_page_shows_is_there_and_signed() {
    let page = read("accuracy-cost.md");
    let links = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        let file = link.split('#').next().unwrap_or_default();
        assert!(docs().join(file).is_file(), "{link}");
    }
    for entry in fs::read_dir(docs()).expect("a folder") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(name == "accuracy-cost.md" || page.contains(&name), "{name}");
        let first = read(&name).lines().next().unwrap_or_default().to_owned();
        assert!(first.contains("experiments accuracy-cost"), "{name}");
    }
}
