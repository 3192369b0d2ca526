//! What `accuracy-cost` recommends can be had: a scene file's words make the tables of its
//! settings, and the sphere's alone are cut.

use crate::support::{Folder, assert_fails, repository};
use crate::tolerances;
use eigenshade_table::decode;
use std::collections::HashMap;
use std::fs;

/// Settings of degree 9 and order 7 in `docs/accuracy-cost`, and what a scene file says of them.
const SETTINGS: [(&str, &str); 5] = [
    ("9/7 K25 trim3e-2 polynomial f32", "components = 25\ncut = { trim = 3e-2 }"),
    ("9/7 K130 trim1e-3 polynomial f32", "components = 130\ncut = { trim = 1e-3 }"),
    ("9/7 all terms12 polynomial f32", "components = 1000\ncut = { terms = 12 }"),
    ("9/7 all m3 polynomial f32", "components = 1000\ncut = { azimuths = 3 }"),
    ("9/7 K50 polynomial f32", "components = 50"),
];

#[test]
fn settings_are_scene_files() {
    let folder = Folder::new();
    let inputs = repository().join("tables/inputs");
    let shipped = fs::read_to_string(repository().join("tables/sphere.toml")).unwrap();
    let shipped = shipped.replace("inputs/", &format!("{}/", inputs.display()));
    let path = repository().join("docs/accuracy-cost/accuracy-cost.csv");
    let sheet = fs::read(path).unwrap();
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(&sheet[..]);
    let rows: Vec<HashMap<String, String>> =
        reader.deserialize().map(|row| row.expect("a row")).collect();
    for (setting, words) in SETTINGS {
        let row = rows.iter().find(|row| row["setting"] == setting);
        let row = row.unwrap_or_else(|| panic!("{setting} is in no row"));
        folder.write("scene.toml", shipped.replace("components = 50", words));
        folder.ok("basis --scene scene.toml --out b.bin");
        folder.ok("pack b.bin --format f32 --out w.esw");
        let bytes = fs::metadata(folder.path("w.esw")).unwrap().len();
        assert_eq!(bytes.to_string(), row["table_bytes"], "{setting}");
        folder.ok("basis --scene scene.toml --check b.bin");
    }
}

/// Each cut leaves out more, and what is kept of the energy says so.
#[test]
fn cuts_go_together() {
    let folder = Folder::new();
    let whole = folder.read("scene.toml");
    let table = |cut: &str| {
        folder.write("scene.toml", format!("{whole}{cut}\n"));
        folder.ok("basis --scene scene.toml --out b.bin");
        decode(&fs::read(folder.path("b.bin")).unwrap()).unwrap()
    };
    let (all, same) = (table(""), table("cut = {}"));
    assert_eq!((&all.profiles, &all.components), (&same.profiles, &same.components));
    let longest = |table: &eigenshade_table::Table| {
        table.profiles.iter().map(|profile| profile.chebyshev.len()).max()
    };
    let (short, both) = (table("cut = { terms = 5 }"), table("cut = { terms = 5, azimuths = 2 }"));
    assert!(longest(&all) > Some(5) && longest(&short) == Some(5));
    assert_eq!(all.components.len(), short.components.len());
    assert!(both.components.len() < all.components.len());
    assert!(both.components.iter().all(|one| one.order.abs() <= 2));
    let eigenvalues = both.components.iter().filter_map(|one| one.eigenvalue);
    let kept = eigenvalues.sum::<f64>() / both.summary.energy;
    assert!(kept < short.summary.energy_kept, "{kept}");
    assert!((both.summary.energy_kept - kept).abs() < tolerances::RESIDUAL_ENERGY);
    let trimmed = table("cut = { terms = 5, azimuths = 2, trim = 0.1 }");
    let terms = |table: &eigenshade_table::Table| -> usize {
        table.profiles.iter().map(|profile| profile.chebyshev.len()).sum()
    };
    assert!(terms(&trimmed) < terms(&both) && terms(&both) < terms(&short));
    let told = "asked for                10000 components, azimuths to 2, polynomials of 5 terms, trimmed to 1e-1";
    assert!(folder.ok("info b.bin").lines().any(|line| line == told));
}

#[test]
fn what_cannot_be_cut_is_refused() {
    let folder = Folder::new();
    let good = folder.read("scene.toml");
    folder.write("scene.toml", good.replace("\"any\"", "\"vertical\"") + "cut = { terms = 5 }\n");
    assert_fails(&folder, "basis --scene scene.toml --out b.bin", &["basis.cut", "leave it out"]);
    let tolerance = good.replace("components = 10000", "tolerance = 1e-2\ncut = { terms = 5 }");
    folder.write("scene.toml", tolerance);
    assert_fails(&folder, "basis --scene scene.toml --out b.bin", &["tolerance and cut"]);
}
