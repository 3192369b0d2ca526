//! Objects that show too few normals for what is asked of them: each has the
//! components that its normals can tell apart, and they give its pictures.

use crate::support::{Folder, numbers, rows, scene};
use crate::tolerances;
use std::f64::consts::{FRAC_PI_2, TAU};
use std::fmt::Write;

const HEADER: &str = "light,material,normal,r,g,b";

/// The lines of a CSV of normals with weights.
fn csv(normals: impl IntoIterator<Item = ([f64; 3], f64)>) -> String {
    let mut text = "x,y,z,weight\n".to_owned();
    for ([x, y, z], weight) in normals {
        writeln!(text, "{x},{y},{z},{weight}").expect("text");
    }
    text
}

/// The table of these normals, and how far its pictures of them are from the direct sum,
/// of the largest |I| there; the number of components.
fn pictures(name: &str, normals: &str) -> (f64, usize) {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("object.csv", normals);
        let text = scene(criterion, 10_000, "[]");
        folder.write("scene.toml", text.replace("\"sphere\"", "\"object.csv\""));
        folder.ok("basis --scene scene.toml --out b.bin");
        let pair = "--lights lights.csv --materials materials.csv --normals object.csv";
        let shaded = |options: &str| {
            numbers(&rows(&folder.ok(&format!("shade b.bin {pair} {options}")), HEADER), 3)
        };
        let truth = shaded("--method modes");
        let ours = shaded("--method polynomial --format f64");
        let peak = truth.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        assert!(truth.iter().all(|value| value.is_finite()) && peak > 0.0);
        for (ours, truth) in ours.iter().zip(&truth) {
            let apart = (ours - truth).abs() / peak;
            assert!(apart.is_finite(), "{name}, {criterion}");
            worst = worst.max(apart);
        }
        count = count.max(folder.ok("eigenvalues b.bin").lines().count() - 1);
    }
    println!("{name}: {count} components, pictures {worst:.1e}");
    (worst, count)
}

fn assert_pictures(name: &str, normals: &str, most: usize) {
    let (worst, count) = pictures(name, normals);
    assert!(worst <= tolerances::GENERAL_PICTURES, "{name}: {worst:e}");
    assert!(count <= most, "{name}: {count} components of {most} that there can be");
}

#[test]
fn one_normal() {
    assert_pictures("toward the camera", "x,y,z\n0,0,1\n", 1);
    assert_pictures("on the rim", "x,y,z\n0,1,0\n", 1);
    assert_pictures("aslant, a hundred times", &csv((0..100).map(|_| ([0.6, 0.0, 0.8], 1.0))), 1);
}

#[test]
fn normals_on_a_line() {
    let arc = |slant: f64| [slant.sin(), 0.0, slant.cos()];
    let normals = (-40..=40).map(|k| (arc(FRAC_PI_2 * f64::from(k) / 40.0), 1.0));
    assert_pictures("a half circle", &csv(normals), 17);
    let two = [([0.6, 0.0, 0.8], 1.0), ([-0.6, 0.0, 0.8], 3.0)];
    assert_pictures("a roof", &csv(two), 2);
}

/// The visible half of a cylinder across the picture.
#[test]
fn a_cylinder() {
    let normals = (0..=60).map(|k| {
        let (sine, cosine) = (FRAC_PI_2 * f64::from(k - 30) / 30.0).sin_cos();
        ([0.0, sine, cosine.max(0.0)], cosine.max(0.0))
    });
    assert_pictures("a cylinder", &csv(normals), 17);
}

#[test]
fn all_on_the_rim() {
    let normals = (0..64).map(|k| {
        let (y, x) = (TAU * f64::from(k) / 64.0).sin_cos();
        ([x, y, 0.0], 1.0)
    });
    assert_pictures("the rim", &csv(normals), 9);
}

/// Two normals a hair apart, and a patch of a hundredth of a degree.
#[test]
fn normals_that_hardly_differ() {
    let two = [([0.6, 0.0, 0.8], 1.0), ([0.6 + 1e-9, 0.0, 0.8], 1.0)];
    assert_pictures("two within 1e-9", &csv(two), 2);
    let patch = (0..400).map(|k| {
        let (x, y) = (f64::from(k % 20) * 1e-5, f64::from(k / 20) * 1e-5);
        ([x, y, 1.0], 1.0)
    });
    assert_pictures("a patch of 2e-4", &csv(patch), 10);
}

/// Weights that span twelve decades: the light ones count as little as they weigh, and
/// are still seen right.
#[test]
fn weights_over_twelve_decades() {
    let normals = (0..400).map(|k| {
        let z: f64 = (f64::from(k) + 0.5) / 400.0;
        let (y, x) = (2.399_963 * f64::from(k)).sin_cos();
        let radius = (1.0 - z * z).sqrt();
        ([radius * x, radius * y, z], 10f64.powf(-12.0 * f64::from(k) / 399.0))
    });
    let (worst, _) = pictures("weights", &csv(normals));
    assert!(worst <= tolerances::LIGHTEST_NORMALS, "{worst:e}");
}

/// Facets without area, some of them a line, some a point, some thinner than rounding.
#[test]
fn a_mesh_with_degenerate_triangles() {
    let corners = "v 0 0 0\nv 1 0 0.3\nv 0 1 -0.2\nv 1 1 0.5\nv 2 0 0.6\nv 0.5 1e-17 0.15\n";
    let good = "f 1 2 3\nf 2 4 3\n";
    let bad = "f 1 1 1\nf 1 2 2\nf 1 2 5\nf 1 2 6\n";
    let eigenvalues = |text: String| {
        let folder = Folder::new();
        folder.write("m.obj", text);
        let scene = scene("image-centered", 10_000, "[]").replace("\"sphere\"", "\"m.obj\"");
        folder.write("scene.toml", scene);
        folder.ok("basis --scene scene.toml --out b.bin");
        folder.ok("eigenvalues b.bin")
    };
    let expected = eigenvalues(format!("{corners}{good}"));
    assert_eq!(eigenvalues(format!("{corners}{good}{bad}")), expected);
    assert!(expected.lines().count() > 2);
}
