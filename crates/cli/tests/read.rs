//! `eigenshade read` on images whose light and material are known: of a sphere, of other objects,
//! and with tables of light that does not rotate freely.

use crate::support::files::{Answer, READ, answer, get, nearest, with_image};
use crate::support::{
    DEGREE, Folder, ORDER, SHADED, assert_fails, difference, lights, materials, noise, numbers,
    rows, scene,
};
use eigenshade_testing::{fixtures, largest};
use std::fmt::Write;

/// d of an image without noise, and the image of its light, relative to the largest: polynomials
/// accurate to 1e-12, times a condition number of a few hundreds.
const NOISELESS: f64 = 1e-9;

/// Share of the energy, or rms, that least squares leave of an image made of their components:
/// roundings of files with full digits, and profiles truncated at 1e-12.
const RESIDUAL: f64 = 3e-15;

/// The residual where one of 400 pixels is wrong is larger than this.
const SPOILED: f64 = 1e-6;

/// The rms residual of the posterior mean of a constant image of 1/2: rounding.
const FLAT: f64 = 2e-15;

#[test]
fn components_and_material_come_back() {
    let folder = with_image();
    let found = answer(&folder.ok(&format!("{READ} --light-out l.csv --modes-out m.csv")));
    let header = "light,material,component,r,g,b";
    let project = folder.ok("project --table b.bin --light light.csv --material material.csv");
    let expected = numbers(&rows(&project, header), 3);
    for estimate in ["least-squares", "posterior"] {
        assert_near(estimate, get(&found, "d", estimate).as_flattened(), &expected);
    }
    assert_eq!(get(&found, "fit", "pixels")[0][0], 400.0);
    assert!(get(&found, "relative-residual", "least-squares")[0][0] < RESIDUAL);
    assert_eq!(nearest(&found), "material-2");
    assert_eq!(get(&found, "fit", "product-converged"), [[1.0; 3]]);

    // The estimated light gives the image again.
    let shade = "shade --table b.bin --material material.csv --normals normals.csv --format f64";
    let again = folder.ok(&format!("{shade} --light l.csv"));
    let images = [folder.read("image.csv"), again].map(|text| numbers(&rows(&text, SHADED), 3));
    assert_near("the light's image", &images[1], &images[0]);
    assert!(folder.read("l.csv").contains("\nimage,0,0,"));
    let modes = rows(&folder.read("m.csv"), "estimate,l,m,o,p,q,r,g,b");
    let count = eigenshade_index::mode::total(DEGREE, ORDER);
    assert_eq!(modes.len(), 2 * count);
}

#[test]
fn weighted_images() {
    let folder = with_image();
    // A pixel of weight 0 may have any value.
    let text = folder.read("image.csv");
    let last = text.trim_end().rfind('\n').unwrap();
    folder.write("bad.csv", format!("{}\nlight-0,material-2,399,9,9,9\n", &text[..last]));
    folder.write("mask.csv", format!("weight\n{}0\n", "2\n".repeat(399)));
    let bad = "read bad.csv --normals normals.csv --table b.bin";
    let [with, without] =
        [format!("{bad} --mask mask.csv"), bad.to_owned()].map(|line| answer(&folder.ok(&line)));
    assert_eq!(get(&with, "fit", "pixels")[0][0], 399.0);
    assert!(get(&with, "relative-residual", "least-squares")[0][0] < RESIDUAL);
    assert!(get(&without, "relative-residual", "least-squares")[0][0] > SPOILED);
    assert_eq!(nearest(&with), "material-2");
}

#[test]
fn units_do_not_matter() {
    let folder = with_image();
    let values = numbers(&rows(&folder.read("image.csv"), SHADED), 3);
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
            let far = (found / scale - expected).abs() / largest(values.iter().copied());
            assert!(far <= NOISELESS, "{scale:e}: {far:e}");
        }
    }
    for scale in [1e-160, 1e160] {
        let arguments = format!("{} --out new.csv", scaled(scale));
        assert_fails(&folder, &arguments, &["scaled.csv", "largest", "scale it"]);
    }
}

/// Pixels of one normal determine one number, whatever the table.
#[test]
fn a_flat_object() {
    let folder = with_image();
    folder.write("flat.csv", format!("x,y,z\n{}", "0.3,0.1,1\n".repeat(400)));
    folder.write("gray.csv", format!("value\n{}", "0.5\n".repeat(400)));
    let text = folder.ok("read gray.csv --normals flat.csv --table b.bin");
    let value = |begins: &str| -> f64 {
        let line = text.lines().find(|line| line.starts_with(begins)).expect("a line");
        line.rsplit(',').next().unwrap().parse().expect("a number")
    };
    assert_eq!(value("fit,rank,"), 1.0);
    assert!(value("residual-rms,least-squares,") < RESIDUAL);
    assert!(value("residual-rms,posterior,") < FLAT, "{text}");
    // The image has no variance to be relative to.
    assert_eq!(value("relative-residual,scalar-product,"), f64::INFINITY);
    assert!(!text.contains("NaN"));
}

/// Asserts that the numbers of an image without noise are as expected.
#[track_caller]
fn assert_near(what: &str, found: &[f64], expected: &[f64]) {
    let error = difference(found, expected);
    println!("{what}: {error:.1e}");
    assert!(error <= NOISELESS, "{what}: {error:e}");
}

/// 400 normals of an object whose right side faces the camera more.
fn object() -> String {
    let (mut text, mut noise) = ("x,y,z\n".to_owned(), noise(5));
    for _ in 0..400 {
        writeln!(text, "{},{},{}", noise() + 0.2, 0.8 * noise(), noise().abs()).unwrap();
    }
    text
}

/// A folder with an object's normals, this light, the third material, and the scene of this
/// criterion and rotation.
fn with_object(criterion: &str, geometry: &str, rotation: &str, light: &str) -> Folder {
    let folder = Folder::new();
    folder.write("object.csv", object());
    let text = scene(criterion, 10_000, "[]")
        .replace("normals = \"sphere\"", &format!("normals = \"{geometry}\""))
        .replace("rotation = \"any\"", &format!("rotation = \"{rotation}\""));
    folder.write("scene.toml", text);
    let only = |text: &str, begin: &str, name: &str| -> String {
        let keep = |line: &&str| !line.starts_with(begin) || line.starts_with(name);
        text.lines().filter(keep).map(|line| format!("{line}\n")).collect()
    };
    folder.write("light.csv", light);
    folder.write("material.csv", only(&materials(ORDER, 4), "material-", "material-2,"));
    folder
}

/// A gray light: the luminance of light-1 of the database, at another exposure.
fn gray_light() -> String {
    let mut text = "name,l,m,value\n".to_owned();
    for row in rows(&lights(DEGREE, 3), "name,l,m,r,g,b") {
        if row[0] == "light-1" {
            let [r, g, b] = [3, 4, 5].map(|field| row[field].parse::<f64>().expect("a number"));
            let value = 3.0 * (0.2126 * r + 0.7152 * g + 0.0722 * b);
            writeln!(text, "gray,{},{},{value:e}", row[1], row[2]).unwrap();
        }
    }
    text
}

/// Makes the table, shades its object or the sphere's normals, and reads it back.
fn comes_back(folder: &Folder, normals: &str) -> Answer {
    folder.ok("basis --scene scene.toml --out b.bin");
    let pair = "--light light.csv --material material.csv";
    folder.ok(&format!(
        "shade --table b.bin {pair} --normals {normals} --format f64 --out image.csv"
    ));
    let read = format!("read image.csv --normals {normals} --table b.bin --light-out l.csv");
    let answer = answer(&folder.ok(&read));
    let header = "light,material,component,r,g,b";
    let expected = numbers(&rows(&folder.ok(&format!("project --table b.bin {pair}")), header), 3);
    for estimate in ["least-squares", "posterior"] {
        assert_near(estimate, get(&answer, "d", estimate).as_flattened(), &expected);
    }
    assert!(get(&answer, "relative-residual", "least-squares")[0][0] < RESIDUAL);
    assert_eq!(nearest(&answer), "material-2");
    // The estimated light gives the image again.
    let again = folder.ok(&format!(
        "shade --table b.bin --light l.csv --material material.csv --normals {normals} --format f64"
    ));
    let [found, image] =
        [again, folder.read("image.csv")].map(|text| numbers(&rows(&text, SHADED), 3));
    assert_near("the light's image", &found, &image);
    answer
}

#[test]
fn an_object_comes_back() {
    let colored = lights(DEGREE, 1);
    // A sphere's table, with the pixels of another object.
    comes_back(&with_object("standard", "sphere", "any", &colored), "object.csv");
    for criterion in ["image-centered", "standard"] {
        let folder = with_object(criterion, "object.csv", "any", &colored);
        let answer = comes_back(&folder, "object.csv");
        // Its pixels are its normals, so that the paper's scalar product is exact.
        let [product, squares] =
            ["scalar-product", "least-squares"].map(|name| get(&answer, "d", name).as_flattened());
        assert_near("scalar product", product, squares);
    }
}

#[test]
fn captured_light_comes_back() {
    // The last is a sphere's table with the pixels of another object.
    for (criterion, geometry) in
        [("image-centered", "object.csv"), ("standard", "object.csv"), ("image-centered", "sphere")]
    {
        let folder = with_object(criterion, geometry, "none", &gray_light());
        comes_back(&folder, "object.csv");
        let [found, reference] = ["l.csv", "light.csv"].map(|name| {
            let text = folder.read(name);
            let header = text.lines().next().expect("a header").to_owned();
            let rows = rows(&text, &header);
            rows.iter().map(|row| row[3].parse().expect("a number")).collect::<Vec<f64>>()
        });
        assert_near("the light", &found, &reference);
    }
}

#[test]
fn light_about_the_vertical_comes_back() {
    for criterion in ["image-centered", "standard"] {
        let folder = with_object(criterion, "object.csv", "vertical", &gray_light());
        comes_back(&folder, "object.csv");
    }
}

/// If only one light and one material have weight, only the exposure is unknown.
#[test]
fn weights_of_the_scene_count() {
    for geometry in ["object.csv", "sphere"] {
        let folder = with_object("image-centered", geometry, "none", &gray_light());
        let text = folder
            .read("scene.toml")
            .replace("[material]", "weights = { light-0 = 0, light-2 = 0 }\n[material]")
            .replace(
                "[basis]",
                "weights = { material-0 = 0, material-1 = 0, material-3 = 0 }\n[basis]",
            );
        folder.write("scene.toml", text);
        let answer = comes_back(&folder, "object.csv");
        let light = numbers(&rows(&folder.read("light.csv"), "name,l,m,value"), 1);
        assert_near("exposure", &get(&answer, "fit", "exposure")[0][..1], &light[..1]);
    }
}

/// Where a channel of a picture that `render` drew is 0, it may have been below.
#[test]
fn black_may_be_clipped() {
    let folder = Folder::new();
    let [gold, pearl] = ["gold-metallic-paint", "pearl-paint"];
    for (light, material, first) in [
        ("park", "brass", "brass"),
        ("studio", "brass", "brass"),
        ("park", gold, gold),
        // As the guide says.
        ("lobby", gold, pearl),
    ] {
        folder.ok(&format!("render -l {light} -m {material} -s 128 --exposure 0.2 -o a.png"));
        let said = folder.messages("read a.png -n sphere -o d.csv --without-black");
        assert_eq!(said.contains(" 0 clipped or"), light == "lobby", "{said}");
        assert_eq!(nearest(&answer(&folder.read("d.csv"))), first, "{light}, {material}");
    }
}

/// An image that no light and material can have, and a sphere in a wide image.
#[test]
fn images_of_something_else_are_noted() {
    let folder = with_image();
    let said = folder.messages(&format!("{READ} -o d.csv"));
    assert!(!said.contains("does not look like"), "{said}");
    let mut noise = noise(7);
    let rows: String = (0..400).map(|k| format!("l,m,{k},{0},{0},{0}\n", noise().abs())).collect();
    folder.write("image.csv", format!("{SHADED}\n{rows}"));
    let said = folder.messages(&format!("{READ} -o d.csv"));
    assert!(said.contains("does not look like one of this table"), "{said}");
    assert!(said.contains("normals and their frame") && !said.contains("--transfer"), "{said}");
    let wide: Vec<[f32; 3]> = (0..32 * 16).map(|k| [1.0 + 1e-3 * k as f32; 3]).collect();
    folder.write("wide.pfm", fixtures::pfm(32, &wide));
    let said = folder.messages("read wide.pfm -n sphere --table b.bin --components 4 -o d.csv");
    assert!(said.contains("the image is 32 x 16"), "{said}");
}

/// With fewer components than the table has, the image is not blamed.
#[test]
fn few_components_leave_much() {
    let folder = with_image();
    let said = folder.messages(&format!("{READ} --components 1 -o d.csv"));
    let note = format!("1 of {} components leave ", folder.table("b.bin").count());
    assert!(said.contains(&note) && !said.contains("does not look like"), "{said}");
}

#[test]
fn a_mesh_has_no_normals_of_pixels() {
    let folder = with_image();
    folder.write("mesh.obj", "mtllib s.mtl\n");
    let read = READ.replace("normals.csv", "mesh.obj");
    assert_fails(&folder, &read, &["mesh.obj: it is a mesh", "with `render`"]);
}

/// The colors of an EXR are multiplied by its opacity, those of a PNG are not.
#[test]
fn an_exr_is_divided_by_its_opacity() {
    let folder = Folder::new();
    let [mut materials, mut transparent] = [Vec::new(), Vec::new()];
    for file in ["a.png", "a.exr"] {
        folder.ok(&format!("render -l lobby -m pearl-paint -s 128 --exposure 0.2 -o {file}"));
        let said = folder.messages(&format!("read {file} -n sphere -o d.csv"));
        let counts = said.split_once("(of all: ").unwrap().1.lines().next().unwrap().to_owned();
        transparent.push(counts);
        materials.push(nearest(&answer(&folder.read("d.csv"))).to_owned());
    }
    assert_eq!(materials, ["pearl-paint"; 2]);
    assert_eq!(transparent[0], transparent[1]);
}
