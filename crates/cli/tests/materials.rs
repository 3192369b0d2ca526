//! `material` on formulas, tables and folders of files; and bad ones of each.

use crate::support::{Folder, assert_fails, assert_usage_errors, numbers, rows, shipped_path};
use crate::tolerances;
use std::f64::consts::{FRAC_PI_2, PI};

const GRAY: &str = "name,o,p,q,value";

#[test]
fn formulas_on_the_command_line() {
    let folder = Folder::new();
    let text = folder.ok("material lambertian --albedo 0.8 --order 12");
    let found = rows(&text, GRAY);
    assert_eq!((found.len(), found[0][0].as_str()), (140, "lambertian"));
    let values = numbers(&found, 1);
    assert!((values[0] - 1.6).abs() <= tolerances::MATTE_PROJECTION);
    assert!(values[1..].iter().all(|value| value.abs() <= tolerances::MATTE_PROJECTION));

    let text = folder.ok("material ggx --roughness 0.5 --f0 0.04 --albedo 0.5,0.1,0 --order 3");
    let channels = numbers(&rows(&text, "name,o,p,q,r,g,b"), 3);
    assert!(channels[0] > channels[1] && channels[1] > channels[2] && channels[2] > 0.0);
    let message =
        folder.messages("material oren-nayar --sigma 0.3 --order 4 --name chalk --out c.csv");
    let start = "chalk: order 4 leaves out ";
    assert!(message.starts_with(start) && message.lines().count() == 1, "{message}");
    assert_eq!(rows(&folder.read("c.csv"), GRAY)[0][0], "chalk");
    // Without roughness it is the matte material.
    let smooth = folder.ok("material oren-nayar --sigma 0 --albedo 0.8 --order 4");
    assert!((numbers(&rows(&smooth, GRAY), 1)[0] - 1.6).abs() <= tolerances::MATTE_PROJECTION);
    // The other measure gives other coefficients.
    let graze = folder.ok("material ggx --roughness 0.5 --f0 1 --order 2 --measure solid-angle");
    assert_ne!(graze, folder.ok("material ggx --roughness 0.5 --f0 1 --order 2"));
}

/// Degree 9 and order 7, those of the shipped table; a light CSV keeps its own degree.
#[test]
fn degree_and_order_have_defaults() {
    let folder = Folder::new();
    let map = format!("light {}", shipped_path("inputs/maps/sky.exr"));
    for (command, header, last) in [
        ("material lambertian --albedo 0.8", GRAY, &["7", "7", "7"][..]),
        (&map, "name,l,m,r,g,b", &["9", "9"]),
        ("light lights.csv --from graphics", "name,l,m,r,g,b", &["4", "4"]),
    ] {
        let rows = rows(&folder.ok(command), header);
        assert_eq!(rows[rows.len() - 1][1..=last.len()], *last, "{command}");
    }
}

/// A constant table of 1/π.
fn table() -> Vec<u8> {
    let mut bytes: Vec<u8> = [90, 90, 180i32].iter().flat_map(|bins| bins.to_le_bytes()).collect();
    for scale in [1.0, 1.15, 1.66] {
        let value = 1500.0 / scale / PI;
        bytes.extend(std::iter::repeat_n(value.to_le_bytes(), 90 * 90 * 180).flatten());
    }
    bytes
}

fn measured() -> String {
    let angle = |step: i32| FRAC_PI_2 * f64::from(step) / 5.5;
    let row = |place: i32| {
        let (i, r, k) = (place / 24, place / 4 % 6, place % 4);
        format!("{},{},{},0,0.2\n", angle(i), 0.8 * f64::from(k), angle(r))
    };
    "theta_i,phi_i,theta_r,phi_r,value\n".to_owned() + &(0..144).map(row).collect::<String>()
}

#[test]
fn a_folder_of_everything() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("all")).unwrap();
    folder.write("all/a-table.binary", table());
    folder.write("all/b-fit.csv", measured());
    folder.write(
        "all/c.toml",
        "[[material]]\nname = \"gold\"\nmodel = \"ggx\"\nroughness = 0.6\nf0 = [1.0, 0.7, 0.3]\n\
         [[material]]\nname = \"chalk\"\nmodel = \"oren-nayar\"\nsigma = 0.5\nalbedo = 0.9\n",
    );
    folder.write("all/notes.txt", "none");
    let found = rows(&folder.ok("material all --order 2"), "name,o,p,q,r,g,b");
    let names: Vec<&str> = found.iter().step_by(5).map(|row| row[0].as_str()).collect();
    assert_eq!(names, ["a-table", "b-fit", "gold", "chalk"]);
    let first = numbers(&found[..5], 3);
    for (k, value) in first.iter().enumerate() {
        let expected = if k < 3 { 2.0 } else { 0.0 };
        assert!((value - expected).abs() <= tolerances::MATTE_PROJECTION, "{k}: {value}");
    }
    folder.write("all/d.csv", measured());
    folder.write("all/d.toml", "[[material]]\nname=\"d\"\nmodel=\"lambertian\"\nalbedo=1\n");
    assert_fails(&folder, "material all --order 2 --out new.csv", &["`d`"]);
    folder.write("all/d.csv", "theta_i,phi_i,theta_r,phi_r,value\n0,0,0,0,x\n");
    assert_fails(&folder, "material all --order 2 --out new.csv", &["d.csv:2:"]);
}

/// glTF's parameters are those of a GGX lobe over a matte base.
#[test]
fn gltf_materials_are_lobes_over_a_base() {
    let folder = Folder::new();
    for (gltf, ggx) in [
        ("--base-color 0.9,0.6,0.3 --metallic 1", "--f0 0.9,0.6,0.3"),
        ("--base-color 0.5 --metallic 0", "--f0 0.04 --albedo 0.5"),
        ("--base-color #ffffff --metallic 0", "--f0 0.04 --albedo 1,1,1"),
        ("--base-color 0.2,0.5,0.8 --metallic 0.5", "--f0 0.12,0.27,0.42 --albedo 0.1,0.25,0.4"),
    ] {
        let of = |model: &str, parameters: &str| {
            let material = format!("material {model} {parameters} --roughness 0.6 --order 3");
            folder.ok(&format!("{material} --name x --out {model}.csv"));
            ["", ".gloss"].map(|end| folder.read(&format!("{model}{end}.csv")))
        };
        assert_eq!(of("gltf", gltf), of("ggx", ggx), "{gltf}");
    }
    let wrong = [
        "material gltf --base-color 1.5 --metallic 0 --roughness 0.5",
        "material gltf --base-color 0.5 --metallic -0.1 --roughness 0.5",
        "material gltf --base-color #b8733 --metallic 1 --roughness 0.5",
        "material gltf --base-color b87333 --metallic 1 --roughness 0.5",
        "material ggx --roughness 0.5 --f0 #12",
        "material lambertian --albedo #gggggg",
    ];
    assert_usage_errors(&folder, &wrong);
}

/// A hexadecimal code is a color in sRGB, for the program and in a file: of copper, `#b87333`.
#[test]
fn hexadecimal_colors_are_in_srgb() {
    let folder = Folder::new();
    let entry = "[[material]]\nname = \"x\"\nmodel = \"ggx\"\nroughness = 0.6\n";
    let of = |f0: &str| {
        folder.write("m.toml", format!("{entry}f0 = {f0}\nalbedo = 0\n"));
        folder.ok("material m.toml --order 3")
    };
    // By the curve of IEC 61966-2-1, computed elsewhere.
    let linear = "[0.4793201831008268, 0.1714411007328226, 0.033104766570885055]";
    let (found, expected) = (of("\"#b87333\""), of(linear));
    let channels = |text: &str| numbers(&rows(text, "name,o,p,q,r,g,b"), 3);
    for (found, expected) in channels(&found).into_iter().zip(channels(&expected)) {
        assert!((found - expected).abs() <= 1e-12, "{found} {expected}");
    }
    let given = "material ggx --name x --roughness 0.6 --f0 #b87333 --order 3";
    assert_eq!(folder.ok(given), found);
    assert_eq!(of("\"#fc0\""), of("\"#FFcc00\""));
    folder.write("m.toml", format!("{entry}f0 = \"copper\"\n"));
    assert_fails(&folder, "material m.toml", &["m.toml:5:", "`copper` is no color", "#b87333"]);
    folder.write("m.toml", format!("{entry}f0 = \"#12\"\n"));
    assert_fails(
        &folder,
        "material m.toml",
        &["m.toml:5:", "`#12` is no color; write # and three"],
    );
    folder.write("m.toml", format!("{entry}f0 = [0.1, 0.2]\n"));
    assert_fails(&folder, "material m.toml", &["m.toml:5:", "[r, g, b]"]);
}

/// The options of the coefficients are on either side of a formula's name.
#[test]
fn options_before_a_formula() {
    let folder = Folder::new();
    let formula = "gltf --base-color 0.5 --metallic 0 --roughness 0.6";
    let before = folder.ok(&format!("material --order 3 --window 9 {formula}"));
    assert_eq!(before, folder.ok(&format!("material {formula} --order 3 --window 9")));
    assert_ne!(before, folder.ok(&format!("material {formula}")));
    let report = format!("material --report r.csv {formula}");
    assert_fails(&folder, &report, &["neither paths nor --report"]);
}
