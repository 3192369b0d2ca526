//! `eigenshade read` with tables of objects other than the sphere, and of light that
//! does not turn freely.

use crate::support::{self, Folder, lights, materials, noise, numbers, rows, scene};
use crate::tolerances;
use std::fmt::Write;

/// Numbers of a quantity and name of an answer, in the order of the index.
fn get(answer: &str, quantity: &str, name: &str) -> Vec<f64> {
    let rows = rows(answer, "quantity,name,index,r,g,b");
    let these: Vec<_> =
        rows.into_iter().filter(|row| row[0] == quantity && row[1] == name).collect();
    assert!(!these.is_empty(), "no {quantity} {name}");
    numbers(&these, 3)
}

/// The nearest material.
fn nearest(answer: &str) -> String {
    let is_first = |row: &&Vec<String>| row[0] == "material-evidence" && row[2] == "0";
    let rows = rows(answer, "quantity,name,index,r,g,b");
    rows.iter().find(is_first).expect("a first material")[1].clone()
}

/// Largest |a - b|, of the largest |b|.
#[track_caller]
fn assert_near(what: &str, found: &[f64], expected: &[f64]) {
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    let both = found.iter().zip(expected);
    let far = both.fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / largest;
    println!("{what}: {far:.1e}");
    assert!(far <= tolerances::READ_NOISELESS, "{what}: {far:e}");
}

/// 400 normals of an object that is seen more from its right.
fn object() -> String {
    let (mut text, mut noise) = ("x,y,z\n".to_owned(), noise(5));
    for _ in 0..400 {
        writeln!(text, "{},{},{}", noise() + 0.2, 0.8 * noise(), noise().abs()).unwrap();
    }
    text
}

/// A folder with an object's normals, one of the database's lights, the third
/// material, and the scene of this criterion and rotation.
fn folder(criterion: &str, geometry: &str, rotation: &str, light: &str) -> Folder {
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
    folder.write("material.csv", only(&materials(support::ORDER, 4), "material-", "material-2,"));
    folder
}

/// A grey light: the luminance of light-1 of the database, at another exposure.
fn grey_light() -> String {
    let mut text = "name,l,m,value\n".to_owned();
    for row in rows(&lights(support::DEGREE, 3), "name,l,m,r,g,b") {
        if row[0] == "light-1" {
            let [r, g, b] = [3, 4, 5].map(|field| row[field].parse::<f64>().expect("a number"));
            let value = 3.0 * (0.2126 * r + 0.7152 * g + 0.0722 * b);
            writeln!(text, "grey,{},{},{value:e}", row[1], row[2]).unwrap();
        }
    }
    text
}

/// Makes the table, shades its object or the sphere's normals, and reads it back.
fn comes_back(folder: &Folder, normals: &str) -> String {
    folder.ok("basis --scene scene.toml --out b.bin");
    let pair = "--lights light.csv --materials material.csv";
    folder.ok(&format!("shade b.bin {pair} --normals {normals} --format f64 --out image.csv"));
    let answer =
        folder.ok(&format!("read image.csv --normals {normals} --table b.bin --light-out l.csv"));
    let header = "light,material,component,r,g,b";
    let expected = numbers(&rows(&folder.ok(&format!("project b.bin {pair}")), header), 3);
    for estimate in ["least-squares", "posterior"] {
        assert_near(estimate, &get(&answer, "d", estimate), &expected);
    }
    assert!(get(&answer, "relative-residual", "least-squares")[0] < tolerances::READ_RESIDUAL);
    assert_eq!(nearest(&answer), "material-2");
    // The light that was read makes the image again.
    let again = folder.ok(&format!(
        "shade b.bin --lights l.csv --materials material.csv --normals {normals} --format f64"
    ));
    let [found, image] = [again, folder.read("image.csv")]
        .map(|text| numbers(&rows(&text, "light,material,normal,r,g,b"), 3));
    assert_near("the light's image", &found, &image);
    answer
}

#[test]
fn an_object_comes_back() {
    for criterion in ["image-centered", "standard"] {
        let colored = lights(support::DEGREE, 1);
        let folder = folder(criterion, "object.csv", "any", &colored);
        let answer = comes_back(&folder, "object.csv");
        // Its pixels are its normals: the paper's scalar product is right on them.
        let (product, squares) =
            (get(&answer, "d", "scalar-product"), get(&answer, "d", "least-squares"));
        assert_near("scalar product", &product, &squares);
    }
}

#[test]
fn captured_light_comes_back() {
    // The last: a sphere's table, read on pixels that another object shows.
    for (criterion, geometry) in
        [("image-centered", "object.csv"), ("standard", "object.csv"), ("image-centered", "sphere")]
    {
        let folder = folder(criterion, geometry, "none", &grey_light());
        comes_back(&folder, "object.csv");
        let [found, truth] = ["l.csv", "light.csv"].map(|name| {
            let text = folder.read(name);
            let header = text.lines().next().expect("a header").to_owned();
            let rows = rows(&text, &header);
            rows.iter().map(|row| row[3].parse().expect("a number")).collect::<Vec<f64>>()
        });
        assert_near("the light", &found, &truth);
    }
}

#[test]
fn light_about_the_vertical_comes_back() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion, "object.csv", "vertical", &grey_light());
        comes_back(&folder, "object.csv");
    }
}

/// Where one light and one material alone count, nothing but the exposure is open.
#[test]
fn weights_of_the_scene_count() {
    for geometry in ["object.csv", "sphere"] {
        let folder = folder("image-centered", geometry, "none", &grey_light());
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
        assert_near("exposure", &get(&answer, "fit", "exposure")[..1], &light[..1]);
    }
}
