//! `eigenshade read`: what is read from images that are known.

use crate::support::reading::{READ, answer, get, nearest, with_image};
use crate::support::{self, assert_fails, numbers, rows};
use crate::tolerances;
use std::fmt::Write;

/// The same where one pixel of 400 shows something else: more than this.
const READ_SPOILT: f64 = 1e-6;

/// Rms that the posterior mean leaves of a flat grey of 1/2: rounding.
const READ_FLAT: f64 = 2e-15;

#[test]
fn components_and_material_come_back() {
    let folder = with_image();
    let found = answer(&folder.ok(&format!("{READ} --light-out l.csv --modes-out m.csv")));
    let header = "light,material,component,r,g,b";
    let project = folder.ok("project b.bin --lights light.csv --materials material.csv");
    let expected = numbers(&rows(&project, header), 3);
    let largest = expected.iter().fold(0.0f64, |most, d| most.max(d.abs()));
    for estimate in ["least-squares", "posterior"] {
        let d: Vec<f64> = get(&found, "d", estimate).iter().flatten().copied().collect();
        assert_eq!(d.len(), expected.len());
        let far = d.iter().zip(&expected).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
        println!("{estimate}: {:.1e}", far / largest);
        assert!(far <= tolerances::READ_NOISELESS * largest, "{estimate}: {far:e}");
    }
    assert_eq!(get(&found, "fit", "pixels")[0][0], 400.0);
    assert!(get(&found, "relative-residual", "least-squares")[0][0] < tolerances::READ_RESIDUAL);
    assert_eq!(nearest(&found), "material-2");
    assert_eq!(get(&found, "fit", "product-converged"), [[1.0; 3]]);

    // The light that was read makes the image again.
    let shade = "shade b.bin --materials material.csv --normals normals.csv --format f64";
    let again = folder.ok(&format!("{shade} --lights l.csv"));
    let images = [folder.read("image.csv"), again]
        .map(|text| numbers(&rows(&text, "light,material,normal,r,g,b"), 3));
    let peak = images[0].iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let both = images[0].iter().zip(&images[1]);
    let far = both.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / peak;
    println!("the light's image: {far:.1e}");
    assert!(far <= tolerances::READ_NOISELESS, "{far:e}");
    assert!(folder.read("l.csv").contains("\nimage,0,0,"));
    let modes = rows(&folder.read("m.csv"), "estimate,l,m,o,p,q,r,g,b");
    let count = eigenshade_index::mode::total(support::DEGREE, support::ORDER);
    assert_eq!(modes.len(), 2 * count);
}

#[test]
fn both_criteria_read_alike() {
    let folder = with_image();
    folder.write("scene.toml", support::scene("standard", 10_000, "[]"));
    folder.ok("basis --scene scene.toml --out b.bin");
    let found = answer(&folder.ok(READ));
    assert!(get(&found, "relative-residual", "least-squares")[0][0] < tolerances::READ_RESIDUAL);
    assert_eq!(nearest(&found), "material-2");
    let project = folder.ok("project b.bin --lights light.csv --materials material.csv");
    let expected = numbers(&rows(&project, "light,material,component,r,g,b"), 3);
    let d = get(&found, "d", "least-squares").iter().flatten();
    let far = d.zip(&expected).fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
    assert!(far <= tolerances::READ_NOISELESS * expected[0].abs(), "{far:e}");
}

#[test]
fn weighted_images() {
    let folder = with_image();
    // A pixel that weighs nothing may show anything.
    let text = folder.read("image.csv");
    let last = text.trim_end().rfind('\n').unwrap();
    folder.write("bad.csv", format!("{}\nlight-0,material-2,399,9,9,9\n", &text[..last]));
    folder.write("mask.csv", format!("weight\n{}0\n", "2\n".repeat(399)));
    let bad = "read bad.csv --normals normals.csv --table b.bin";
    let [with, without] =
        [format!("{bad} --mask mask.csv"), bad.to_owned()].map(|line| answer(&folder.ok(&line)));
    assert_eq!(get(&with, "fit", "pixels")[0][0], 399.0);
    assert!(get(&with, "relative-residual", "least-squares")[0][0] < tolerances::READ_RESIDUAL);
    assert!(get(&without, "relative-residual", "least-squares")[0][0] > READ_SPOILT);
    assert_eq!(nearest(&with), "material-2");
}

#[test]
fn any_unit_reads_alike() {
    let folder = with_image();
    let values = numbers(&rows(&folder.read("image.csv"), "light,material,normal,r,g,b"), 3);
    let scaled = |scale: f64| {
        let mut text = "r,g,b\n".to_owned();
        for [r, g, b] in values.as_chunks::<3>().0 {
            writeln!(text, "{:e},{:e},{:e}", scale * r, scale * g, scale * b).unwrap();
        }
        folder.write("scaled.csv", text);
        "read scaled.csv --normals normals.csv --table b.bin".to_owned()
    };
    let expected = answer(&folder.ok(READ));
    for scale in [1e-30, 1e30] {
        let found = answer(&folder.ok(&scaled(scale)));
        assert_eq!(nearest(&found), "material-2");
        let [found, expected] = [&found, &expected].map(|answer| get(answer, "d", "posterior"));
        for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
            let far = (found / scale - expected).abs() / get_largest(&values);
            assert!(far <= tolerances::READ_NOISELESS, "{scale:e}: {far:e}");
        }
    }
    for scale in [1e-160, 1e160] {
        let arguments = format!("{} --out new.csv", scaled(scale));
        assert_fails(&folder, &arguments, &["scaled.csv", "largest", "scale it"]);
    }
}

fn get_largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most: f64, value| most.max(value.abs()))
}

/// Pixels of one normal determine one number, whatever the table has.
#[test]
fn a_flat_object() {
    let folder = with_image();
    folder.write("flat.csv", format!("x,y,z\n{}", "0.3,0.1,1\n".repeat(400)));
    folder.write("grey.csv", format!("value\n{}", "0.5\n".repeat(400)));
    let text = folder.ok("read grey.csv --normals flat.csv --table b.bin");
    let value = |begins: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with(begins)).expect("a line");
        line.rsplit(',').next().unwrap().parse().expect("a number")
    };
    assert_eq!(value("fit,rank,"), 1.0);
    assert!(value("residual-rms,least-squares,") < tolerances::READ_RESIDUAL);
    assert!(value("residual-rms,posterior,") < READ_FLAT, "{text}");
    // Without variance there is no share of it.
    assert_eq!(value("relative-residual,scalar-product,"), f64::INFINITY);
    assert!(!text.contains("NaN"));
}
