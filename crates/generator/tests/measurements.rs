//! Measured BRDFs as text: both layouts, and every fault with its file, its
//! line and a remedy.

use eigenshade_generator::material::measurements::{Measured, read_material_path};
use eigenshade_model::error::Result;
use std::f64::consts::FRAC_PI_2;
use std::fmt::Debug;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A folder with these files.
fn folder(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn plain(text: &str) -> Result<Vec<Measured>> {
    let folder = folder(&[("wool.csv", text)]);
    read_material_path(folder.path().join("wool.csv"))
}

fn curet(table: &str, values: &str) -> Result<Vec<Measured>> {
    let folder = folder(&[("table.txt", table), ("abrdf.dat", values)]);
    read_material_path(folder.path())
}

/// Asserts one line with the place, the fault, and a remedy after it.
fn assert_fault<T: Debug>(result: Result<T>, place: &str, fault: &str) {
    let text = result.unwrap_err().to_string();
    assert!(text.contains(&format!("{place}: ")), "`{text}`: {place}");
    assert!(text.contains(fault), "`{text}`: {fault}");
    assert!(!text.contains('\n') && text.split("; ").count() >= 2, "{text}");
}

const HEADER: &str = "theta_i,phi_i,theta_r,phi_r,r,g,b\n";
const DIRECTIONS: &str = "1 0.5 0.25 1.0 1.25\r\n2 0.0 0.0 0.75 0.0";

#[test]
fn plain_csv_is_read() {
    let text = "# by hand\nnote,theta_i,phi_i,theta_r,phi_r,g,r,b\n\
        x,0.5,1,0.25,3,0.2,0.1,0.3\ny, 1.5707963268 ,0,0,0,-0.01,0,0\n";
    let [wool] = &plain(text).unwrap()[..] else { panic!("one material") };
    let [first, second] = wool.samples[..] else { panic!("two measurements") };
    assert_eq!(wool.name, "wool");
    assert_eq!((first.theta_i, first.theta_r), (0.5, 0.25));
    assert_eq!((first.delta_phi, first.rgb), (-2.0, [0.1, 0.2, 0.3]));
    // A little beyond the rim is the rim, and noise may be negative.
    assert_eq!(second.theta_i, FRAC_PI_2);
    assert_eq!(second.rgb, [0.0, -0.01, 0.0]);
}

#[test]
fn grey_values_are_three_channels() {
    let wool = plain("theta_i,phi_i,theta_r,phi_r,value\n0,0,0,0,0.5\n").unwrap();
    assert_eq!(wool[0].samples[0].rgb, [0.5; 3]);
}

#[test]
fn folder_is_all_its_csv_files_by_name() {
    let text = format!("{HEADER}0,0,0,0,1,1,1\n");
    let folder = folder(&[("b.csv", &text), ("a.CSV", &text), ("notes.txt", "none")]);
    let names: Vec<String> = read_material_path(folder.path())
        .unwrap()
        .into_iter()
        .map(|material| material.name)
        .collect();
    assert_eq!(names, ["a", "b"]);
}

#[test]
fn faults_of_plain_csv_are_named() {
    let row = |row: &str| plain(&format!("# one\n{HEADER}# two\n0,0,0,0,1,1,1\n{row}\n"));
    assert_fault(plain("theta_i,phi_i\n"), "wool.csv:1", "theta_i,phi_i");
    assert_fault(plain("theta_i,phi_i,theta_r,phi_r,r,g\n"), "wool.csv:1", "header");
    assert_fault(plain(""), "wool.csv", "nothing in it");
    assert_fault(plain(HEADER), "wool.csv", "no measurement");
    assert_fault(row("0,0,0,0,1,1"), "wool.csv:5", "7 fields, this row 6");
    assert_fault(row("0,0,0,0,1,1,1,1"), "wool.csv:5", "7 fields, this row 8");
    assert_fault(row("0,0,0,0,1,NaN,1"), "wool.csv:5", "`NaN`");
    assert_fault(row("0,inf,0,0,1,1,1"), "wool.csv:5", "`inf`");
    assert_fault(row("0,0,0,0,1,1,dark"), "wool.csv:5", "`dark`");
    assert_fault(row("1.58,0,0,0,1,1,1"), "wool.csv:5", "theta_i = 1.58 is outside");
    assert_fault(row("0,0,45,0,1,1,1"), "wool.csv:5", "theta_r = 45 is outside");
    assert_fault(row("-0.1,0,0,0,1,1,1"), "wool.csv:5", "theta_i = -0.1 is outside");
}

#[test]
fn faults_of_paths_are_named() {
    let empty = folder(&[("notes.txt", "none")]);
    assert_fault(read_material_path(empty.path()), "", "no measurements in this folder");
    let missing = Path::new("no-such-folder").join("wool.csv");
    assert_fault(read_material_path(missing), "wool.csv", "o such file");
    let lone = folder(&[("abrdf.dat", "1 0.1")]);
    assert_fault(read_material_path(lone.path()), "table.txt", "o such file");
}

#[test]
fn curet_is_read() {
    let folder = folder(&[
        ("table.txt", DIRECTIONS),
        ("abrdf.dat", "3 0.1 0.2\n11   0.3 -1e-3\n29 1 1\n4 1 1\n"),
        ("samples.csv", "id,name\n3,Plaster_b\n29,Polyester (2 zoomed)\n4,\n"),
    ]);
    let materials = read_material_path(folder.path()).unwrap();
    let names: Vec<&str> = materials.iter().map(|m| m.name.as_str()).collect();
    assert_eq!(names, ["03-plaster-b", "sample-11", "29-polyester-2-zoomed", "sample-04"]);
    let [first, second] = materials[1].samples[..] else { panic!("two measurements") };
    // The table gives the view first.
    assert_eq!((first.theta_i, first.theta_r, first.delta_phi), (1.0, 0.5, 1.0));
    assert_eq!((first.rgb, second.rgb), ([0.3; 3], [-1e-3; 3]));
}

#[test]
fn faults_of_curet_are_named() {
    let table = |table| curet(table, "1 0.1 0.2");
    let values = |values| curet(DIRECTIONS, values);
    assert_fault(table(""), "table.txt", "no rows");
    assert_fault(table("1 0 0 0"), "table.txt:1", "4 fields");
    assert_fault(table("1 0 0 0 0\n\n3 0 0 0 0"), "table.txt:3", "index 3 where 2");
    assert_fault(table("one 0 0 0 0"), "table.txt:1", "`one`");
    assert_fault(table("1 0 0 nan 0"), "table.txt:1", "`nan`");
    assert_fault(table("1 0 0 1.6 0"), "table.txt:1", "theta_i = 1.6 is outside");
    assert_fault(table("1 -1 0 0 0"), "table.txt:1", "theta_v = -1 is outside");
    assert_fault(values(""), "abrdf.dat", "no rows");
    assert_fault(values("1 0.1 0.2\n2 0.1"), "abrdf.dat:2", "1 values where table.txt has 2");
    assert_fault(values("1 0.1 inf"), "abrdf.dat:1", "`inf`");
    assert_fault(values("wool 0.1 0.2"), "abrdf.dat:1", "`wool`");
    assert_fault(values("1 0 1\n2 0 1\n1 0 1"), "abrdf.dat:3", "given in line 1");
}

#[test]
fn faults_of_sample_names_are_named() {
    let named = |names| {
        let folder = folder(&[
            ("table.txt", DIRECTIONS),
            ("abrdf.dat", "1 0.1 0.2"),
            ("samples.csv", names),
        ]);
        read_material_path(folder.path())
    };
    assert_fault(named("number,name\n1,Felt\n"), "samples.csv:1", "number,name");
    assert_fault(named("id,name\n1,Felt\n1,Wool\n"), "samples.csv:3", "two names");
    assert_fault(named("id,name\n-1,Felt\n"), "samples.csv:2", "negative");
    assert_fault(named("id,name\none,Felt\n"), "samples.csv:2", "`one`");
}
