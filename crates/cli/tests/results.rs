//! Results that are refused because a number format has no room for them, and warnings and notes
//! about doubtful ones.

use crate::support::files::{READ, with_image};
use crate::support::{
    DEGREE, Folder, ORDER, PAIR, SHADE, SHADED, assert_contains, assert_fails, lights, materials,
    numbers, rows,
};
use crate::tolerances;
use eigenshade_table::{encode, light};
use eigenshade_testing::largest;
use std::f64::consts::PI;

/// The last channel of every row times 10 to a power.
fn times(text: &str, power: &str) -> String {
    let (header, rest) = text.split_once('\n').unwrap();
    let rows: String = rest.lines().map(|line| format!("{line}e{power}\n")).collect();
    format!("{header}\n{rows}")
}

fn with_light(power: &str) -> Folder {
    let folder = Folder::with_table();
    folder.write("lights.csv", times(&lights(DEGREE, 1), power));
    folder
}

#[test]
fn images_beyond_a_format_are_refused() {
    let folder = with_light("300");
    let fragments = ["light `light-0` on material `material-0`", "the range of", "toward", "e300"];
    for (format, options) in [
        ("f32", ""),
        ("f32", "--clamp"),
        ("f32", "--method eigen"),
        ("f32", "--method baked"),
        ("f32", "--tolerance 1e-3"),
        ("q15", ""),
    ] {
        let shade = format!("{SHADE} --format {format} {options} --out new.csv");
        assert_fails(&folder, &shade, &[&fragments[..], &[format]].concat());
    }
    let render = "render --table b.bin --light lights.csv --material materials.csv:material-0";
    assert_fails(&folder, &format!("{render} --out new.png"), &fragments);
    // f64 has the range.
    let values = folder.shaded("--format f64");
    assert!(values.iter().all(|value| value.is_finite()) && values.iter().any(|&v| v > 1e299));
}

#[test]
fn products_beyond_f64_are_refused() {
    let folder = with_light("300");
    folder.write("materials.csv", times(&materials(ORDER, 1), "10"));
    let fragments = ["light `light-0` on material `material-0`", "f64", "e300", "e10", "toward"];
    for options in ["--format f64", "--method modes", "--method modes --clamp"] {
        assert_fails(&folder, &format!("{SHADE} {options} --out new.csv"), &fragments);
    }
    assert_fails(&folder, &format!("project --table b.bin {PAIR} --out new.csv"), &fragments);
}

/// The range of coefficients of lights and materials ends at 2^127 times the largest mantissa.
#[test]
fn integers_are_right_up_to_the_size_at_which_they_saturate() {
    let [format, right, too_large] = ["q15", "41", "43"];
    let folder = with_light(right);
    // The channel that is large.
    let [found, expected] = [format, "f64"]
        .map(|format| numbers(&rows(&folder.ok(&format!("{SHADE} --format {format}")), SHADED), 1));
    let peak = largest(expected.iter().copied());
    let squares = found.iter().zip(&expected).map(|(a, b)| ((a - b) / peak).powi(2));
    let rms = (squares.sum::<f64>() / found.len() as f64).sqrt();
    assert!(rms <= tolerances::SHADED_Q15, "{format}: {rms:e}");
    folder.write("lights.csv", times(&lights(DEGREE, 1), too_large));
    let shade = format!("{SHADE} --format {format} --out new.csv");
    assert_fails(&folder, &shade, &["light-0", format, "toward"]);
    folder.write("lights.csv", lights(DEGREE, 1));
    folder.write("materials.csv", times(&materials(ORDER, 1), too_large));
    assert_fails(&folder, &shade, &["material-0", format, "toward"]);
}

const RENDER: &str = "render -t b.bin -l lights.csv:light-0 -m materials.csv:material-0 \
                      --size 16 --out p.png";

/// A point light on the axis, truncated at a degree: from the camera for z = 1, from behind for -1.
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
fn light_behind_the_object_gives_a_note() {
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
        let render = format!("{RENDER} --window none");
        [SHADE, &format!("{SHADE} --method modes"), &format!("{SHADE} --clamp"), &render]
            .map(|command| folder.messages(command))
    };
    for message in ringing(-1.0) {
        let fragments =
            ["light `light-0` on material `material-0`", "behind the object", "--window"];
        assert_contains(&message, &fragments);
    }
    assert_eq!(ringing(1.0).map(|message| message.contains("ringing")), [false; 4]);
    // A light below zero does not ring.
    folder.write("lights.csv", "name,l,m,value\nlight-0,0,0,-1\n");
    for command in [SHADE, RENDER] {
        let message = folder.messages(command);
        assert!(message.contains("light `light-0` is below zero"), "{message}");
        assert!(!message.contains("ringing"), "{message}");
    }
    folder.write("lights.csv", lights(DEGREE, 3));
    assert_eq!(folder.messages(SHADE), "");
}

#[test]
fn formats_with_large_rounding_errors() {
    let folder = with_image();
    let shade = |format: &str| format!("{SHADE} --method polynomial --format {format}");
    let (in_f32, in_q15) = (shade("f32"), shade("q15"));
    let warned = |command: &str| {
        let message = folder.messages(command);
        let lines = message.lines().filter(|line| line.starts_with("warning: rounding to "));
        let lines: Vec<&str> = lines.collect();
        assert!(lines.len() <= 1, "{message}");
        lines.concat()
    };
    for command in [RENDER, READ, &in_f32] {
        assert_eq!(warned(command), "", "{command}");
    }
    let mut table = folder.table("b.bin");
    for rounding in &mut table.summary.roundings {
        (rounding.largest, rounding.rms) = (2e-3, 3e-4);
    }
    folder.write("b.bin", encode(&table));
    for command in [RENDER, READ, &in_f32] {
        let start = "warning: rounding to f32 costs up to 2.0e-3 of an image's peak (rms 3.0e-4)";
        assert!(warned(command).starts_with(start), "{command}");
    }
    assert_contains(&warned(&in_q15), &["to q15"]);
    let packed = folder.ok("pack --table b.bin --format q15 --out w.esw");
    assert_contains(&packed, &["2.0e-3 of the peak at most, rms 3.0e-4"]);
    for command in [RENDER, SHADE] {
        assert_eq!(warned(&format!("{command} --format f64")), "", "{command}");
    }
}
