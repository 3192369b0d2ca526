//! Hard cases through the command line: objects of few normals, black lights and materials, and
//! coefficients out of range. `experiments stability` measures more of them.

use crate::support::{
    Folder, PAIR, SHADED, assert_fails, difference, lights, materials, numbers, rows, scene,
};
use crate::tolerances;
use std::fmt::Write;

/// The lines of a CSV of normals with weights.
fn csv(normals: impl IntoIterator<Item = ([f64; 3], f64)>) -> String {
    let mut text = "x,y,z,weight\n".to_owned();
    for ([x, y, z], weight) in normals {
        writeln!(text, "{x},{y},{z},{weight}").expect("text");
    }
    text
}

/// The largest error of the pictures of these normals by their table, relative to the largest |I|,
/// and the number of components.
fn errors_of_pictures(name: &str, normals: &str) -> (f64, usize) {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("object.csv", normals);
        let text = scene(criterion, 10_000, "[]");
        folder.write("scene.toml", text.replace("\"sphere\"", "\"object.csv\""));
        folder.ok("basis --scene scene.toml --out b.bin");
        let shaded = |options: &str| {
            let shade = format!("shade b.bin {PAIR} --normals object.csv {options}");
            numbers(&rows(&folder.ok(&shade), SHADED), 3)
        };
        let reference = shaded("--method modes");
        let ours = shaded("--method polynomial --format f64");
        let error = difference(&ours, &reference);
        assert!(error.is_finite(), "{name}, {criterion}");
        worst = worst.max(error);
        count = count.max(folder.ok("eigenvalues b.bin").lines().count() - 1);
    }
    println!("{name}: {count} components, pictures {worst:.1e}");
    (worst, count)
}

/// Each object has no more components than it can have, and its pictures are right.
#[test]
fn objects_of_few_normals() {
    let aslant = [0.6, 0.0, 0.8];
    let two = |x: f64, weight: f64| csv([(aslant, 1.0), ([x, 0.0, 0.8], weight)]);
    let patch = (0..400).map(|k| ([f64::from(k % 20) * 1e-5, f64::from(k / 20) * 1e-5, 1.0], 1.0));
    for (name, normals, most) in [
        ("toward the camera", csv([([0.0, 0.0, 1.0], 1.0)]), 1),
        ("on the rim", csv([([0.0, 1.0, 0.0], 1.0)]), 1),
        ("aslant, a hundred times", csv((0..100).map(|_| (aslant, 1.0))), 1),
        ("a roof", two(-0.6, 3.0), 2),
        ("two within 1e-9", two(0.6 + 1e-9, 1.0), 2),
        ("a patch of a hundredth of a degree", csv(patch), 10),
    ] {
        let (worst, count) = errors_of_pictures(name, &normals);
        assert!(worst <= tolerances::GENERAL_PICTURES, "{name}: {worst:e}");
        assert!(count <= most, "{name}: {count} components, where at most {most} are possible");
    }
}

/// CSV rows of one name whose coefficients are all 0.
fn zeros(name: &str, like: &str) -> String {
    let first = like.lines().nth(1).and_then(|line| line.split(',').next()).unwrap();
    let of_first = like.lines().filter(|line| line.starts_with(&format!("{first},")));
    let values = if like.starts_with("name,l,m") { 3 } else { 1 };
    of_first
        .map(|line| {
            let fields: Vec<&str> = line.split(',').skip(1).collect();
            let places = fields[..fields.len() - values].join(",");
            format!("{name},{places}{}\n", ",0".repeat(values))
        })
        .collect()
}

#[test]
fn a_light_of_zeros() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 2) + &zeros("night", &lights(4, 1)));
    let fragments = ["scene.toml", "`night`", "normalize = \"none\""];
    assert_fails(&folder, "basis --scene scene.toml --out b.bin", &fragments);
    let as_they_are = folder
        .read("scene.toml")
        .replace("rotation = \"any\"", "rotation = \"any\"\nnormalize = \"none\"");
    folder.write("scene.toml", as_they_are);
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_black(&folder, "night,");
    // No other light.
    folder.write("lights.csv", "name,l,m,r,g,b\n".to_owned() + &zeros("night", &lights(4, 1)));
    assert!(folder.ok("basis --scene scene.toml --out b.bin").contains("components   1 of 10000"));
    assert_black(&folder, "night,");
}

#[test]
fn a_material_of_zeros() {
    for count in [3, 0] {
        let folder = Folder::new();
        let some = materials(3, 1);
        let header = "name,o,p,q,value\n".to_owned();
        let others = if count == 0 { header } else { materials(3, count) };
        folder.write("materials.csv", others + &zeros("soot", &some));
        folder.ok("basis --scene scene.toml --out b.bin");
        assert_black(&folder, ",soot,");
    }
}

/// Asserts that the images of this light or material are exactly black, in every format.
fn assert_black(folder: &Folder, name: &str) {
    for options in ["", "--format f64", "--method eigen", "--method modes"] {
        let text = folder.ok(&format!("shade b.bin {PAIR} --normals normals.csv {options}"));
        let of_name: Vec<_> =
            rows(&text, SHADED).into_iter().filter(|row| row.join(",").contains(name)).collect();
        assert!(!of_name.is_empty());
        assert!(numbers(&of_name, 3).iter().all(|value| *value == 0.0), "{options}");
    }
}

/// Images whose squares are out of range have no table.
#[test]
fn squares_out_of_range() {
    for size in ["e155", "e-180", "e300"] {
        let folder = Folder::new();
        let line = |line: &str| match line.strip_suffix("value") {
            Some(_) => format!("{line}\n"),
            None => format!("{line}{size}\n"),
        };
        let materials: String = materials(3, 2).lines().map(line).collect();
        folder.write("materials.csv", materials);
        assert_fails(
            &folder,
            "basis --scene scene.toml --out b.bin",
            &["scene.toml", "out of range"],
        );
    }
}
