//! The tables whose pixel and new light are counted on boards: each is a setting of
//! `docs/accuracy-cost` with the same counts, and the firmware builds the setting's table.

use crate::support::repository;
use eigenshade_cli::table::compare::differences;
use eigenshade_table::Table;
use eigenshade_table::layout::LANES;
use eigenshade_table::reduce::with_components;
use eigenshade_table::trim::trim;
use report::accuracy_cost::scope::{Bases, Scope};
use report::accuracy_cost::settings::{self, Setting};
use report::sheet::{Counts, M0, M4F, Record, Sheet};
use std::fs;

/// Counts of four digits against those of the firmware, relative: half a last digit of 1,000.
const COUNTED: f64 = 5e-4;
/// Words that a program holds besides a setting's transferred material, d and scene: lengths and
/// exponents of each, and in 15 bits the room of a row that is padded.
const HELD_WORDS: f64 = 16.0;
/// Boards of the counts with their formats, and their columns in the settings' file.
const BOARDS: [([&str; 2], &str); 3] = [(M0, "m0"), (["mps2-an386", "q15"], "m4f"), (M4F, "m4f")];

fn sheet(path: &str) -> Vec<Record> {
    let text = fs::read_to_string(repository().join(path)).expect(path);
    Sheet::parse(&text, path).expect("rows").rows
}

fn benchmark_tables() -> Vec<Record> {
    sheet("firmware/tables/sizes.csv")
}

/// The name of this table's setting.
fn name(listed: &Record, format: &str) -> String {
    let trimmed = match listed.text("trim") {
        "" => String::new(),
        text => format!(" trim{:e}", text.parse::<f64>().expect("a tolerance")),
    };
    format!("9/7 K{}{trimmed} polynomial {format}", listed.text("components"))
}

fn number(row: &Record, column: &str) -> f64 {
    row.number(column).unwrap_or_else(|| panic!("{column}: {row:?}"))
}

/// The page shows every count: on every board in 15 bits, and in f32 where there is a float unit.
/// The programs hold what the setting's transferred material, d and scene take, and the lengths of
/// these; another cut or another number of components would take another number of bytes.
#[test]
fn each_counted_table_is_a_setting_with_its_counts() {
    let (settings, counts) = (sheet("docs/accuracy-cost/accuracy-cost.csv"), Counts::recorded());
    for listed in benchmark_tables() {
        let of_table = format!("{}/", listed.text("name"));
        let rows = counts.0.iter().filter(|row| row.text("operation").starts_with(&of_table));
        assert_eq!(rows.count(), 3 * BOARDS.len(), "{listed:?}");
        for ([board, format], key) in BOARDS {
            let count = |operation: &str, column| {
                let found = counts.get([board, format], &format!("{of_table}{operation}"), column);
                found.unwrap_or_else(|| panic!("{board} {format} {operation}")) as f64
            };
            let bytes = |column| count("scene", column);
            let name = name(&listed, format);
            let row = settings.iter().find(|row| row.text("setting") == name);
            let row = row.unwrap_or_else(|| panic!("no setting {name}"));
            for (column, expected) in [
                ("pixel", count("pixel", "instructions")),
                ("light", count("light", "instructions")),
                ("flash", bytes("flash_bytes")),
                ("ram", bytes("ram_bytes") + bytes("stack_bytes")),
            ] {
                // The file has four digits of counts.
                let found = number(row, &format!("{key}_{column}"));
                let near = (found / expected - 1.0).abs() <= COUNTED;
                assert!(near, "{name}, {key}_{column}: {found}, {expected} was counted");
            }
            let more = bytes("ram_bytes") - number(row, "state_bytes");
            let words = 4.0 * HELD_WORDS;
            assert!((0.0..=words).contains(&more), "{board}, {name}: {more} bytes more");
        }
    }
}

/// The firmware's tables are the settings' bases: the same components and trimmed polynomials.
#[test]
fn tables_of_the_firmware_are_those_of_the_settings() {
    let all = settings::all(false);
    let setting_of = |listed: &Record, format: &str| -> Setting {
        let name = name(listed, format);
        let found = all.iter().find(|one| one.setting.to_string() == name);
        found.unwrap_or_else(|| panic!("no setting {name}")).setting
    };
    let tables = benchmark_tables();
    let recipe = |listed: &Record| {
        let setting = setting_of(listed, "f32");
        assert_eq!(setting.recipe, setting_of(listed, "q15").recipe);
        setting.recipe
    };
    let scope = Scope::seen(9, 7).expect("the shipped data");
    let bases = Bases::new(&scope, tables.iter().map(recipe)).expect("bases");
    for listed in &tables {
        let path = repository().join("firmware/tables").join(listed.text("file"));
        let bytes = fs::read(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
        let whole = eigenshade_table::decode(&bytes).expect("a table");
        let components = number(listed, "components") as usize;
        let mut table = with_components(&whole, |number, _| number < components);
        assert_eq!(table.components.len(), components);
        let terms =
            |table: &Table| table.profiles.iter().map(|one| one.chebyshev.len()).sum::<usize>();
        if !listed.text("trim").is_empty() {
            let untrimmed = terms(&table);
            trim(&mut table, number(listed, "trim"));
            assert!(terms(&table) < untrimmed, "{listed:?}");
        }
        let expected = bases.table(&recipe(listed)).expect("a basis");
        // A file may keep modes besides.
        table.scene.clone_from(&expected.scene);
        for difference in differences(&table, &expected).expect("two tables of one recipe") {
            assert!(!difference.is_over(), "{listed:?}: {difference:?}");
        }
    }
}

/// A table that ends with +m has passes that serve nothing: its module must not compute them.
#[test]
fn modules_compute_only_passes_that_serve_a_component() {
    let path = repository().join("firmware/tables/full.bin");
    let whole = eigenshade_table::decode(&fs::read(path).expect("a file")).expect("a table");
    let mut without = 0;
    for components in [1, 8, 9, 25, 50, 130] {
        let table = with_components(&whole, |number, _| number < components);
        let parts = eigenshade_table::parts::floats(&table);
        let (mut expected, mut slots) = (Vec::new(), parts.slots.as_slice());
        for (index, pass) in parts.passes.iter().enumerate() {
            let (of_pass, rest) = slots.split_at(usize::from(pass.profiles) * LANES);
            if of_pass.iter().any(|&slot| usize::from(slot) < components) {
                expected.push(index);
            }
            slots = rest;
        }
        let text = eigenshade_table::statics::floats(&table, "a test").expect("it projects");
        let (_, listed) = text.split_once("table!(sphere passes ").expect("a line of passes");
        let (listed, _) = listed.split_once(" runs").expect("its end");
        let second = |pass: &str| pass.split(' ').nth(1).and_then(|index| index.parse().ok());
        let listed: Option<Vec<usize>> = listed.split("] ").map(second).collect();
        assert_eq!(listed.as_ref(), Some(&expected), "{components}");
        without += usize::from(parts.passes.len() > expected.len());
    }
    assert!(without > 0, "no table has such a pass");
}
