//! The recorded errors of the table of formulas in the manifest, in tables/README.md, and refused
//! beside another table. The tests of the experiments find those of three materials again.

use crate::support::{
    BASIS, Folder, assert_contains, assert_fails, error_line, repository_text, rows,
};
use eigenshade_testing::part;

/// The error of the shipped components against that of all, relative: what 250 components leave out
/// is small beside what the degree leaves out.
const ERROR_OF_COMPONENTS: f64 = 0.01;

/// The median error over the maps at degree 12 for rough materials, relative to the peak, as
/// documented.
const ERROR_WHERE_ROUGH: f64 = 0.01;

const HEADER: &str = "material,degree,order,components,median,worst,map,normals,scene,energy";

fn shipped() -> Vec<Vec<String>> {
    rows(&repository_text("tables/pbr.errors.csv"), HEADER)
}

/// The manifest repeats the recorded errors.
#[test]
fn the_manifest_holds_the_errors() {
    let manifest = repository_text("tables/pbr.manifest.csv");
    let rows = shipped();
    for row in &rows {
        let of = if row[3].is_empty() { "direct sum" } else { "table" };
        let entry = format!("error of {} {}/{} {of}", row[0], row[1], row[2]);
        let median = format!("\n{entry} median,{},,\n", row[4]);
        let worst = format!("\n{entry} worst,{} {},,\n", row[5], row[6]);
        assert_contains(&manifest, &[&median, &worst]);
    }
    let errors = manifest.lines().filter(|line| line.starts_with("error of "));
    assert_eq!(errors.count(), 2 * rows.len());
}

/// Figures that the documentation states.
#[test]
fn shipped_errors_are_small_from_roughness_one_half() {
    let rows = shipped();
    assert_eq!(rows.len(), 24 * 4);
    let number = |row: &Vec<String>, k: usize| row[k].parse::<f64>().unwrap();
    for pair in rows.chunks(4) {
        // The table's components are enough: its figures are those of all.
        for k in [4, 5] {
            let (table, all) = (number(&pair[0], k), number(&pair[1], k));
            assert!((table / all - 1.0).abs() < ERROR_OF_COMPONENTS, "{pair:?}");
        }
    }
    for row in rows.iter().filter(|row| row[1] == "12") {
        let roughness: f64 = row[0].rsplit_once('-').map_or(1.0, |(_, r)| r.parse().unwrap());
        let rough = roughness >= 0.5 || row[0].starts_with("oren") || row[0] == "lambertian";
        assert!(!rough || number(row, 4) < ERROR_WHERE_ROUGH, "{row:?}");
        assert!(number(row, 4) <= number(row, 5), "{row:?}");
    }
}

/// The table of tables/README.md has the file's figures in percent.
#[test]
fn the_readme_shows_the_errors() {
    let readme = repository_text("tables/README.md");
    let shown = part(&readme, "errors");
    let percent = |text: &str| {
        let value = 100.0 * text.parse::<f64>().unwrap();
        if value < 0.1 { "< 0.1".into() } else { format!("{value:.2}") }
    };
    for of_material in shipped().chunks(4) {
        let [table, _, middle, high] = of_material else { panic!() };
        let both = |row: &Vec<String>| format!("{}, {}", percent(&row[4]), percent(&row[5]));
        let (name, map) = (&table[0], &table[6]);
        let line =
            format!("| {name} | {} ({map}) | {} | {} |\n", both(table), both(middle), both(high));
        print!("{line}");
        assert!(shown.contains(&line), "{line}");
    }
}

/// Errors of another table are not repeated in a manifest.
#[test]
fn errors_of_another_table_are_refused() {
    let folder = Folder::with_table();
    let manifest = folder.read("b.manifest.csv");
    let scene = manifest.lines().find(|line| line.starts_with("scene,")).unwrap();
    let stamp = scene.rsplit(',').next().unwrap().to_owned();
    // A section has the same name as the number of components.
    let count = |name: &str| {
        let mut values =
            manifest.lines().filter_map(|line| line.strip_prefix(name)?.split(',').next());
        values.find(|value| !value.is_empty()).unwrap().to_owned()
    };
    let (degree, order, components) = (count("degree,"), count("order,"), count("components,"));
    let row = |material: &str, map: &str, scene: &str, energy: &str| {
        format!(
            "{HEADER}\n{material},{degree},{order},{components},0.1,0.2,{map},9,{scene},{energy}\n"
        )
    };
    let refused = |text: String, fragments: &[&str]| {
        folder.write("b.errors.csv", text);
        let all = [&["b.errors.csv:2", "remove the file"][..], fragments].concat();
        assert_fails(&folder, BASIS, &all);
        assert_eq!(folder.read("b.manifest.csv"), manifest);
    };
    let (material, map) = ("material-0", "light-0");
    refused(row(material, map, "00000000", "1"), &["scene `00000000`", &stamp]);
    refused(row(material, map, &stamp, "1"), &["energy 1,", "lights or materials differ"]);
    // The error message contains the energy.
    let report = error_line(&folder.run(BASIS));
    let energy = report.split("this one has ").nth(1).unwrap().split(':').next().unwrap();
    refused(row("other", map, &stamp, energy), &["no material `other`"]);
    refused(row(material, "other", &stamp, energy), &["no light `other`"]);
    let good = row(material, map, &stamp, energy);
    refused(good.replace(",0.1,0.2,", "0,0.1,0.2,"), &["0 components"]);
    folder.write("b.errors.csv", "material,degree,order,components,median,worst,map,normals\n");
    assert_fails(&folder, BASIS, &["b.errors.csv:1", "scene,energy"]);
    folder.write("b.errors.csv", good);
    folder.ok(BASIS);
    let line = format!("error of {material} {degree}/{order} table worst,0.2 {map},,");
    assert_eq!(folder.read("b.manifest.csv").lines().next_back(), Some(line.as_str()));
}
