//! What is done, but hardly meant: a line on standard error says so, with the value.

use crate::support::reading::{READ, with_image};
use crate::support::{DEGREE, Folder, lights, materials};
use eigenshade_index::light;
use eigenshade_table::{decode, encode};
use std::f64::consts::PI;

const SHADE: &str =
    "shade b.bin --lights lights.csv --materials materials.csv --normals normals.csv";
const RENDER: &str = "render b.bin --light lights.csv:light-0 --material materials.csv:material-0 \
                      --size 16 --out p.png";

/// What a command says on standard error.
fn said(folder: &Folder, arguments: &str) -> String {
    let output = folder.run(arguments);
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(0), "{arguments}: {said}");
    said
}

#[test]
fn materials_beyond_all_light_or_below_none() {
    let folder = Folder::with_table();
    let project = "project b.bin --lights lights.csv --materials materials.csv";
    for command in [SHADE, RENDER, project] {
        assert_eq!(said(&folder, command), "", "{command}");
    }
    // b_00^0 / 2 is the albedo where b_20^0 and b_22^0 are zero.
    let scene = folder.read("scene.toml").replace("order = 3", "order = 0");
    folder.write("scene.toml", scene);
    for (b, words) in [
        ("3.7", ["`material-0` has albedo 1.8500", "more than it gets"]),
        ("-0.2", ["`material-0` has albedo -0.1000", "less than none"]),
    ] {
        let header = "name,o,p,q,value";
        let rows = format!("{header}\nmaterial-0,0,0,0,{b}\nmaterial-1,0,0,0,1\n");
        folder.write("materials.csv", rows);
        let basis = "basis --scene scene.toml --out new.bin";
        for command in [SHADE, RENDER, project, basis] {
            let said = said(&folder, command);
            let warned: Vec<&str> =
                said.lines().filter(|line| line.starts_with("warning: ")).collect();
            assert_eq!(warned.len(), 1, "{command}: {said}");
            for word in words {
                assert!(warned[0].contains(word), "{command}: no `{word}` in {said}");
            }
        }
    }
}

#[test]
fn measurements_below_zero() {
    let folder = Folder::new();
    let measured = |lowest: f64| {
        format!("theta_i,phi_i,theta_r,phi_r,value\n0.1,0,0.2,0,0.1\n0.3,1,0.2,0,{lowest}\n")
    };
    folder.write("m.csv", measured(-0.004));
    assert!(!said(&folder, "material m.csv --order 0 --out new.csv").contains("warning: "));
    folder.write("m.csv", measured(-0.03));
    let said = said(&folder, "material m.csv --order 0 --out new.csv");
    assert!(said.contains("warning: material `m` has measurements down to -0.0300"), "{said}");
}

/// A point's light, cut at a degree, on the axis: from the camera for z = 1, from behind for -1.
fn point(z: f64) -> String {
    let (mut text, mut before, mut legendre) = ("name,l,m,r,g,b\n".to_owned(), 0.0, 1.0);
    for l in 0..=DEGREE {
        for (degree, m) in light::indices(DEGREE).filter(|(degree, _)| *degree == l) {
            let at = ((2 * l + 1) as f64 / (4.0 * PI)).sqrt() * legendre;
            let value = if m == 0 { at } else { 0.0 };
            text.push_str(&format!("light-0,{degree},{m},{value},{value},{value}\n"));
        }
        let n = l as f64;
        (before, legendre) = (legendre, ((2.0 * n + 1.0) * z * legendre - n * before) / (n + 1.0));
    }
    text
}

#[test]
fn light_behind_the_object_leaves_ringing() {
    let folder = Folder::with_table();
    let text = materials(3, 1);
    let matte = text.lines().enumerate().map(|(row, line)| {
        let (place, _) = line.rsplit_once(',').unwrap();
        let value = ["value", "2"].get(row).copied().unwrap_or("0");
        format!("{place},{value}\n")
    });
    folder.write("materials.csv", matte.collect::<String>());
    let ringing = |z: f64| {
        folder.write("lights.csv", point(z));
        [SHADE, &format!("{SHADE} --method modes"), &format!("{SHADE} --clamp"), RENDER]
            .map(|command| said(&folder, command))
    };
    for said in ringing(-1.0) {
        let words = ["light `light-0` on material `material-0`", "behind the object", "1 of 1"];
        assert!(words.iter().all(|word| said.contains(word)), "{said}");
    }
    assert_eq!(ringing(1.0).map(|said| said.contains("ringing")), [false; 4]);
    folder.write("lights.csv", lights(DEGREE, 3));
    assert_eq!(said(&folder, SHADE), "");
}

#[test]
fn tables_that_a_format_rounds_too_far() {
    let folder = with_image();
    let shade = |format: &str| format!("{SHADE} --method polynomial --format {format}");
    let pack = |format: &str| format!("pack b.bin --format {format} --out w.esw");
    let commands = |format: &str| [shade(format), pack(format)];
    let warning = |said: String| -> Vec<String> {
        let warnings = said.lines().filter(|line| line.starts_with("warning: rounding to "));
        warnings.map(str::to_owned).collect()
    };
    let of_f32 = || commands("f32").into_iter().chain([RENDER.into(), READ.into()]);
    for command in of_f32().chain(commands("q31")) {
        assert_eq!(warning(said(&folder, &command)), [""; 0], "{command}");
    }
    let mut table = decode(&std::fs::read(folder.path("b.bin")).unwrap()).unwrap();
    for rounding in &mut table.summary.roundings {
        (rounding.largest, rounding.rms) = (2e-3, 3e-4);
    }
    folder.write("b.bin", encode(&table));
    for command in of_f32() {
        let words = "warning: rounding to f32 costs up to 2.0e-3 of an image's peak (rms 3.0e-4)";
        let warned = warning(said(&folder, &command));
        assert!(warned.len() == 1 && warned[0].starts_with(words), "{command}: {warned:?}");
    }
    for command in commands("q15") {
        let warned = warning(said(&folder, &command));
        assert!(warned.len() == 1 && warned[0].contains("to q15"), "{command}: {warned:?}");
    }
    for command in [RENDER, SHADE] {
        let warned = warning(said(&folder, &format!("{command} --format f64")));
        assert_eq!(warned, [""; 0], "{command}");
    }
}
