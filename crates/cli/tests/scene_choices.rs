//! Tables whose scene has a tolerance or is trimmed: what `basis` reports, what it keeps, and what
//! it refuses.

use crate::support::{
    BASIS, Folder, NEW_BASIS, PAIR, assert_fails, materials, repository_text, scene, shipped_scene,
};
use eigenshade_table::{Table, material};
use std::collections::HashMap;

/// The small scene with a tolerance, and these lines of `[basis]`.
fn with_tolerance(tolerance: &str, basis: &str) -> Folder {
    let folder = Folder::of_size(6, 5, [3, 4]);
    let lines = format!("tolerance = {tolerance}\n{basis}");
    folder.replace("scene.toml", "components = 10000\n", &lines);
    folder
}

/// What `basis` reports on standard error.
fn report(folder: &Folder) -> Vec<String> {
    folder.messages(BASIS).lines().map(str::to_owned).collect()
}

#[test]
fn basis_reports_its_choice() {
    for tolerance in ["0.3", "0.05", "1e-3"] {
        let folder = with_tolerance(tolerance, "");
        let lines = report(&folder);
        println!("{lines:#?}");
        let table = folder.table("b.bin");
        let (degree, order) = (table.gram.degree, table.gram.order);
        let (count, of) = (table.components.len(), table.spectrum.len());
        assert_eq!(lines.len(), 5);
        for (line, start) in lines.iter().zip([
            format!("degree {degree} of 6"),
            format!("order {order} of 5"),
            format!("components {count} of {of}"),
            "polynomial terms ".to_owned(),
            "in all at most ".to_owned(),
        ]) {
            assert!(line.starts_with(&start), "{line}: {start}");
        }
        let manifest = folder.read("b.manifest.csv");
        for row in [format!("degree,{degree},"), format!("order,{order},")] {
            assert!(manifest.lines().any(|line| line.starts_with(&row)), "{row}");
        }
        let info = folder.ok("info --table b.bin");
        let value = |what: &str| {
            let line = info.lines().find(|line| line.split_whitespace().next() == Some(what));
            line.and_then(|line| line.split_whitespace().last().map(str::to_owned))
        };
        assert_eq!(value("degree"), Some(degree.to_string()));
        assert_eq!(value("order"), Some(order.to_string()));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder.shaded("");
    }
    let coarse = with_tolerance("0.3", "");
    report(&coarse);
    let table = coarse.table("b.bin");
    assert!(table.gram.degree < 6 && table.gram.order < 5, "nothing was chosen");
}

/// The report for the shipped databases at degree 9, order 7 and this tolerance.
const REPORT: &str = "degree 6 of 9, leaves 9.1e-3 of the peak; 5 would leave 1.5e-2
order 7 of 7; 6 would leave 9.8e-3
components 47 of 138, leaves 3.9e-3 of the peak; 46 would leave 4.1e-3
polynomial terms 63 of 161, leaves 1.3e-3 of the peak
in all at most 1.0e-2 of the peak, 1.0e-2 asked for";

#[test]
fn the_shipped_databases_need_degree_6_for_a_hundredth() {
    let folder = Folder::new();
    let text = shipped_scene("curet").replace("components = 50", "tolerance = 1e-2");
    folder.write("scene.toml", text);
    assert_eq!(report(&folder).join("\n"), REPORT);
}

/// Where degree and order are not chosen, the report says so; components are chosen all the same.
#[test]
fn degree_and_order_stay_where_they_are_not_chosen() {
    let zeros = material::indices(5).map(|(o, p, q)| format!("black,{o},{p},{q},0\n"));
    let black = format!("name,o,p,q,value\n{}", zeros.collect::<String>());
    for (from, to, why) in [
        ("[basis]", "[basis]\nmodes = 60", "modes"),
        ("\"materials.csv\"", "\"black.csv\"", "black"),
    ] {
        let folder = with_tolerance("0.05", "");
        folder.write("black.csv", &black);
        folder.replace("scene.toml", from, to);
        let lines = report(&folder);
        println!("{lines:#?}");
        assert!(lines[0].starts_with("degree and order as asked: ") && lines[0].contains(why));
        assert!(lines[1].starts_with("components "), "{}", lines[1]);
        let table = folder.table("b.bin");
        assert_eq!([table.gram.degree, table.gram.order], [6, 5]);
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// Tables of transfers, and of sets of effects.
#[test]
fn tolerances_work_with_stores_and_effects() {
    for basis in [
        "store = \"materials\"\n",
        "store = \"projection\"\n",
        "[effects]\nuse = [\"ambient\"]\n",
        "[effects]\nuse = [\"gloss\"]\n",
        "[effects]\nuse = [\"ambient\", \"diffuse\"]\n",
    ] {
        let folder = with_tolerance("0.02", "");
        folder.write("scene.toml", folder.read("scene.toml") + basis);
        println!("{basis}{:#?}", report(&folder));
        folder.ok("basis --scene scene.toml --check b.bin");
        folder.ok("info --table b.bin");
    }
}

/// Settings of degree 9 and order 7 in `docs/accuracy-cost`, and their lines in a scene file.
const SETTINGS: [(&str, &str); 3] = [
    ("9/7 K25 trim3e-2 polynomial f32", "components = 25\ntrim = 3e-2"),
    ("9/7 K130 trim1e-3 polynomial f32", "components = 130\ntrim = 1e-3"),
    ("9/7 K50 polynomial f32", "components = 50"),
];

#[test]
fn settings_are_scene_files() {
    let folder = Folder::new();
    let shipped = shipped_scene("curet");
    let sheet = repository_text("docs/accuracy-cost/accuracy-cost.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(sheet.as_bytes());
    let rows: Vec<HashMap<String, String>> =
        reader.deserialize().map(|row| row.expect("a row")).collect();
    for (setting, lines) in SETTINGS {
        let row = rows.iter().find(|row| row["setting"] == setting);
        let row = row.unwrap_or_else(|| panic!("{setting} is in no row"));
        folder.write("scene.toml", shipped.replace("components = 50", lines));
        folder.ok(BASIS);
        folder.ok("pack --table b.bin --format f32 --out w.esw");
        assert_eq!(folder.bytes("w.esw").len().to_string(), row["table_bytes"], "{setting}");
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// A coarser trim leaves fewer terms of the same components, and `info` states it.
#[test]
fn trimmed_tables_have_fewer_terms() {
    let folder = Folder::new();
    let whole = folder.read("scene.toml");
    let table = |trim: &str| {
        folder.write("scene.toml", format!("{whole}{trim}\n"));
        folder.ok(BASIS);
        folder.table("b.bin")
    };
    let [all, fine, coarse] = ["", "trim = 1e-3", "trim = 0.1"].map(table);
    assert_eq!([&all.components, &fine.components], [&coarse.components; 2]);
    assert!(coarse.terms() < fine.terms() && fine.terms() < all.terms());
    let line = "requested                10000 components, trimmed to 1e-1";
    assert!(folder.ok("info --table b.bin").lines().any(|found| found == line));
}

/// Several databases are one database with all of their materials, to the lowest order.
#[test]
fn several_databases() {
    let folder = Folder::new();
    let all = folder.read("materials.csv");
    let (first, rest) = all.split_at(all.find("material-2").unwrap());
    folder.write("first.csv", first);
    folder.write("rest.csv", format!("name,o,p,q,value\n{rest}"));
    let with = |database: &str| {
        let text = scene("image-centered", 10_000, "[]");
        folder.write("scene.toml", text.replace("\"materials.csv\"", database));
    };
    let made = |database: &str, to: &str| {
        with(database);
        folder.ok(&format!("basis --scene scene.toml --out {to}"));
        folder.table(to)
    };
    let one = made("\"materials.csv\"", "one.bin");
    let listed = made("[\"materials.csv\"]", "listed.bin");
    assert_eq!(one, listed);
    let several = made("[\"first.csv\", \"rest.csv\"]", "several.bin");
    assert_eq!(several.scene.material.database, ["first.csv", "rest.csv"]);
    let scene = one.scene.clone();
    assert_eq!(Table { scene, ..several }, one);
    assert!(folder.ok("info --table several.bin").contains("first.csv rest.csv"));
    let d = |table: &str| folder.ok(&format!("project --table {table} {PAIR}"));
    assert_eq!(d("several.bin"), d("one.bin"));

    let refused = |database: &str, fragments: &[&str]| {
        with(database);
        assert_fails(&folder, NEW_BASIS, fragments);
    };
    refused("[]", &["material.database = []", "name at least one file"]);
    refused("[\"first.csv\", \"materials.csv\"]", &["materials.csv", "`material-0`", "rename"]);
    refused("[\"first.csv\", \"none.csv\"]", &["none.csv"]);
    refused("[\"first.csv\", 3]", &["a path or a list of paths"]);
    folder.write("low.csv", materials(2, 1).replace("material-0", "low"));
    refused("[\"materials.csv\", \"low.csv\"]", &["low.csv", "order 2"]);
}
