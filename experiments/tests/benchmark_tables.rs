//! The tables whose pixel and new light are counted on boards: each is a setting of
//! `docs/accuracy-cost` with the same counts, and the firmware builds the setting's table.

use crate::support::repository;
use eigenshade_cli::table::compare::differences;
use eigenshade_table::reduce::with_components;
use eigenshade_table::trim::trim;
use experiments::accuracy_cost::bases::Bases;
use experiments::accuracy_cost::materials::Scope;
use experiments::accuracy_cost::setting::Setting;
use experiments::accuracy_cost::settings;
use std::collections::{BTreeSet, HashMap};
use std::fs;

/// Counts in the settings' file, of four digits, against those of the firmware, relative: half of
/// the last digit of 1,000.
const COUNTED: f64 = 5e-4;

/// Words that a program holds besides a setting's folded material, d and scene: lengths and
/// exponents of each, and in 15 bits the room of a row that is padded.
const HELD_WORDS: f64 = 16.0;

type Row = HashMap<String, String>;

/// Boards of the counts, and their columns in the settings' file.
const BOARDS: [(&str, &str); 4] =
    [("microbit", "m0"), ("mps2-an385", "m3"), ("mps2-an386", "m4f"), ("riscv32", "rv32")];

fn sheet(path: &str) -> Vec<Row> {
    let path = repository().join(path);
    let text = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(&text[..]);
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

fn benchmark_tables() -> Vec<Row> {
    sheet("firmware/tables/ladder.csv")
}

/// The name of this table's setting.
fn name(listed: &Row, format: &str) -> String {
    let trimmed = match listed["trim"].as_str() {
        "" => String::new(),
        text => format!(" trim{:e}", text.parse::<f64>().expect("a tolerance")),
    };
    format!("9/7 K{}{trimmed} polynomial {format}", listed["components"])
}

fn count(row: &Row, column: &str) -> f64 {
    row[column].parse().unwrap_or_else(|_| panic!("{column}: {row:?}"))
}

/// The counts of a table: board and format; a pixel, a new light, flash, RAM, stack.
fn counts(name: &str) -> Vec<(String, String, [f64; 5])> {
    let all = sheet("firmware/counts.csv");
    let of = |operation: &str| -> Vec<&Row> {
        let operation = format!("{name}/{operation}");
        all.iter().filter(|row| row["operation"] == operation).collect()
    };
    let [pixels, lights, programs] = ["pixel", "light", "scene"].map(of);
    assert!(pixels.len() == lights.len() && lights.len() == programs.len(), "{name}");
    let rows = pixels.into_iter().zip(lights).zip(programs);
    rows.map(|((pixel, light), program)| {
        let key = |row: &Row| (row["board"].clone(), row["format"].clone());
        assert!(key(pixel) == key(light) && key(light) == key(program), "{name}");
        let instructions = [pixel, light].map(|row| count(row, "instructions"));
        let bytes = ["flash_bytes", "ram_bytes", "stack_bytes"].map(|one| count(program, one));
        let [pixel, light, flash, ram, stack] =
            [instructions[0], instructions[1], bytes[0], bytes[1], bytes[2]];
        let (board, format) = key(program);
        (board, format, [pixel, light, flash, ram, stack])
    })
    .collect()
}

/// The page shows every count: on every board in 15 bits, and in f32 where there is a float unit.
#[test]
fn each_counted_table_is_a_setting_with_its_counts() {
    let settings = sheet("docs/accuracy-cost/accuracy-cost.csv");
    for listed in benchmark_tables() {
        let counts = counts(&listed["name"]);
        let found: BTreeSet<[&str; 2]> =
            counts.iter().map(|(board, format, _)| [board.as_str(), format.as_str()]).collect();
        let mut expected: BTreeSet<[&str; 2]> = BOARDS.map(|(board, _)| [board, "q15"]).into();
        expected.insert(["mps2-an386", "f32"]);
        assert_eq!(found, expected, "{listed:?}");
        for (board, format, [pixel, light, flash, ram, stack]) in &counts {
            let name = name(&listed, format);
            let row = settings.iter().find(|row| row["setting"] == name);
            let row = row.unwrap_or_else(|| panic!("no setting {name}"));
            let (_, key) = BOARDS.iter().find(|(one, _)| one == board).expect("a board");
            for (column, expected) in
                [("pixel", *pixel), ("light", *light), ("flash", *flash), ("ram", ram + stack)]
            {
                // The file has four digits of counts.
                let found = count(row, &format!("{key}_{column}"));
                let near = (found / expected - 1.0).abs() <= COUNTED;
                assert!(near, "{name}, {key}_{column}: {found}, {expected} was counted");
            }
        }
    }
}

/// The programs hold what the setting's folded material, d and scene take, and the lengths of
/// these; another cut or another number of components would take another number of bytes.
#[test]
fn programs_hold_what_the_settings_say() {
    let settings = sheet("docs/accuracy-cost/accuracy-cost.csv");
    for listed in benchmark_tables() {
        for (board, format, [_, _, _, ram, _]) in counts(&listed["name"]) {
            let name = name(&listed, &format);
            let row = settings.iter().find(|row| row["setting"] == name).expect("a setting");
            let more = ram - count(row, "state_bytes");
            let words = 4.0 * HELD_WORDS;
            assert!((0.0..=words).contains(&more), "{board}, {name}: {more} bytes more");
        }
    }
}

/// The firmware's tables are the settings' bases: the same components, the same polynomials
/// trimmed to the same lengths.
#[test]
fn tables_of_the_firmware_are_those_of_the_settings() {
    let all = settings::all(false);
    let setting_of = |listed: &Row, format: &str| -> Setting {
        let name = name(listed, format);
        let found = all.iter().find(|one| one.setting.to_string() == name);
        found.unwrap_or_else(|| panic!("no setting {name}")).setting
    };
    let tables: Vec<(Row, Setting)> = benchmark_tables()
        .into_iter()
        .map(|listed| {
            let setting = setting_of(&listed, "f32");
            assert_eq!(setting.recipe, setting_of(&listed, "q15").recipe);
            (listed, setting)
        })
        .collect();
    let scope = Scope::seen(9, 7).expect("the shipped data");
    let bases = Bases::new(&scope, tables.iter().map(|(_, setting)| setting.recipe));
    let bases = bases.expect("bases");
    for (listed, setting) in &tables {
        let path = repository().join("firmware/tables").join(&listed["file"]);
        let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let whole = eigenshade_table::decode(&bytes).expect("a table");
        let components = count(listed, "components") as usize;
        let mut table = with_components(&whole, |number, _| number < components);
        assert_eq!(table.components.len(), components);
        let untrimmed: usize = table.profiles.iter().map(|one| one.chebyshev.len()).sum();
        if !listed["trim"].is_empty() {
            trim(&mut table, count(listed, "trim"));
            let terms: usize = table.profiles.iter().map(|one| one.chebyshev.len()).sum();
            assert!(terms < untrimmed, "{setting}");
        }
        let expected = bases.table(&setting.recipe).expect("a basis");
        // A file may keep modes besides.
        table.scene.clone_from(&expected.scene);
        for difference in differences(&table, &expected).expect("two tables of one recipe") {
            assert!(!difference.is_over(), "{setting}: {difference:?}");
        }
    }
}

/// A table that ends with +m has passes that serve nothing: its module must not compute them,
/// or a user's build warns.
#[test]
fn modules_use_every_pass_that_they_compute() {
    let path = repository().join("firmware/tables/full.bin");
    let whole = eigenshade_table::decode(&fs::read(path).expect("a file")).expect("a table");
    let mut odd = 0;
    for components in [1, 8, 9, 25, 50, 130] {
        let table = with_components(&whole, |number, _| number < components);
        let text = eigenshade_table::rust_source::module(&table, "a test");
        let passes = text.lines().filter_map(|line| line.trim().strip_prefix("let p"));
        let names =
            passes.filter_map(|rest| rest.split_once(" = eigenshade::specialized::pass::<"));
        let names: Vec<String> = names.map(|(number, _)| format!("p{number}[")).collect();
        assert!(!names.is_empty(), "{components}");
        assert!(names.iter().all(|name| text.contains(name.as_str())), "{components}: {names:?}");
        odd += usize::from(eigenshade_table::Parts::new(&table).passes.len() > names.len());
    }
    assert!(odd > 0, "no table has such a pass");
}
