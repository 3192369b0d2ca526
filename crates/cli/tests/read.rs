//! `eigenshade read` on images whose light and material are known: of a sphere, of other objects,
//! and with tables of light that does not rotate freely.

use crate::support::files::{Answer, READ, answer, get, nearest, third_material, with_image};
use crate::support::{
    BASIS, DEGREE, Folder, ORDER, SHADED, assert_contains, assert_fails, assert_near, lights,
    noise, numbers, rows, scene, shipped_path,
};
use eigenshade_testing::{fixtures, largest};
use std::fs;

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
    let found = assert_comes_back(&folder, "normals.csv", "--modes-out m.csv");
    assert_eq!(get(&found, "fit", "pixels")[0][0], 400.0);
    assert_eq!(get(&found, "fit", "product-converged"), [[1.0; 3]]);
    assert!(folder.read("l.csv").contains("\nimage,0,0,"));
    let modes = rows(&folder.read("m.csv"), "estimate,l,m,o,p,q,r,g,b");
    let count = eigenshade_table::mode::total(DEGREE, ORDER);
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
    let values = image(&folder);
    let scaled = |scale: f64| {
        let row =
            |[r, g, b]: &[f64; 3]| format!("{:e},{:e},{:e}\n", scale * r, scale * g, scale * b);
        let text: String = values.as_chunks().0.iter().map(row).collect();
        folder.write("scaled.csv", format!("r,g,b\n{text}"));
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

/// 400 normals of an object whose right side faces the camera more.
fn object() -> String {
    let mut noise = noise(5);
    let mut row = || format!("{},{},{}\n", noise() + 0.2, 0.8 * noise(), noise().abs());
    "x,y,z\n".to_owned() + &(0..400).map(|_| row()).collect::<String>()
}

/// A folder with an object's normals, this light, the third material, and the scene of this
/// criterion.
fn with_object(criterion: &str, light: &str) -> Folder {
    let folder = Folder::new();
    folder.write("object.csv", object());
    folder.write("scene.toml", scene(criterion, 10_000, "[]"));
    folder.write("light.csv", light);
    folder.write("material.csv", third_material());
    folder
}

/// A gray light: the luminance of light-1 of the database, at another exposure.
fn gray_light() -> String {
    let gray = |row: &Vec<String>| {
        let [r, g, b] = [3, 4, 5].map(|field| row[field].parse::<f64>().expect("a number"));
        let value = 3.0 * (0.2126 * r + 0.7152 * g + 0.0722 * b);
        format!("gray,{},{},{value:e}\n", row[1], row[2])
    };
    let rows = rows(&lights(DEGREE, 3), "name,l,m,r,g,b");
    let rows: String = rows.iter().filter(|row| row[0] == "light-1").map(gray).collect();
    format!("name,l,m,value\n{rows}")
}

/// Makes the table, shades the object, and reads it back.
fn comes_back(folder: &Folder) -> Answer {
    folder.ok(BASIS);
    let scene = "--light light.csv --material material.csv --normals object.csv";
    folder.ok(&format!("shade --table b.bin {scene} --format f64 --out image.csv"));
    assert_comes_back(folder, "object.csv", "")
}

/// Asserts that d, the material and an estimated light of `image.csv`, which has these normals, are
/// those of `light.csv` and `material.csv`.
fn assert_comes_back(folder: &Folder, normals: &str, options: &str) -> Answer {
    let read = READ.replace("normals.csv", normals);
    let answer = answer(&folder.ok(&format!("{read} --light-out l.csv {options}")));
    let expected = folder.projected("--table b.bin --light light.csv --material material.csv");
    for estimate in ["least-squares", "posterior"] {
        assert_near(estimate, get(&answer, "d", estimate).as_flattened(), &expected, NOISELESS);
    }
    assert!(get(&answer, "relative-residual", "least-squares")[0][0] < RESIDUAL);
    assert_eq!(nearest(&answer), "material-2");
    // The estimated light gives the image again.
    let again = folder.irradiance(&format!(
        "--table b.bin --light l.csv --material material.csv --normals {normals} --format f64"
    ));
    assert_near("the light's image", &again, &image(folder), NOISELESS);
    answer
}

fn image(folder: &Folder) -> Vec<f64> {
    numbers(&rows(&folder.read("image.csv"), SHADED), 3)
}

/// A sphere's table, with the pixels of another object.
#[test]
fn an_object_comes_back() {
    for criterion in ["image-centered", "standard"] {
        comes_back(&with_object(criterion, &lights(DEGREE, 1)));
    }
}

#[test]
fn captured_light_comes_back() {
    for criterion in ["image-centered", "standard"] {
        let folder = with_object(criterion, &gray_light());
        comes_back(&folder);
        let [found, reference] = ["l.csv", "light.csv"].map(|name| {
            let text = folder.read(name);
            let header = text.lines().next().expect("a header").to_owned();
            let rows = rows(&text, &header);
            rows.iter().map(|row| row[3].parse().expect("a number")).collect::<Vec<f64>>()
        });
        assert_near("the light", &found, &reference, NOISELESS);
    }
}

/// The picture of the eigenimages alone, which `read` explains.
const PLAIN: &str = "-t color --sources 0 --window none";

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
        folder
            .ok(&format!("render -l {light} -m {material} -s 128 --exposure 0.2 {PLAIN} -o a.png"));
        let said = folder.messages("read a.png -n sphere -o d.csv --without-black");
        assert_eq!(said.contains(" 0 clipped or"), light == "lobby", "{said}");
        assert_eq!(nearest(&answer(&folder.read("d.csv"))), first, "{light}, {material}");
    }
}

/// An image that no light and material can have, and a sphere in a wide image.
#[test]
fn images_of_something_else_are_noted() {
    let folder = with_image();
    assert!(!folder.messages(&format!("{READ} -o d.csv")).contains("does not look like"));
    // With fewer components than the table has, the image is not blamed.
    let said = folder.messages(&format!("{READ} --components 1 -o d.csv"));
    let note = format!("1 of {} components leave ", folder.table("b.bin").count());
    assert!(said.contains(&note) && !said.contains("does not look like"), "{said}");
    let mut noise = noise(7);
    let rows: String = (0..400).map(|k| format!("l,m,{k},{0},{0},{0}\n", noise().abs())).collect();
    folder.write("image.csv", format!("{SHADED}\n{rows}"));
    let said = folder.messages(&format!("{READ} -o d.csv"));
    assert_contains(&said, &["does not look like one of this table", "normals and their frame"]);
    assert!(!said.contains("--transfer"), "{said}");
    let wide: Vec<[f32; 3]> = (0..32 * 16).map(|k| [1.0 + 1e-3 * k as f32; 3]).collect();
    folder.write("wide.pfm", fixtures::pfm(32, &wide));
    let said = folder.messages("read wide.pfm -n sphere --table b.bin --components 4 -o d.csv");
    assert!(said.contains("the image is 32 x 16"), "{said}");
}

/// The colors of an EXR are multiplied by its opacity, those of a PNG are not.
#[test]
fn an_exr_is_divided_by_its_opacity() {
    let folder = Folder::new();
    let [mut materials, mut transparent] = [Vec::new(), Vec::new()];
    for file in ["a.png", "a.exr"] {
        folder
            .ok(&format!("render -l lobby -m pearl-paint -s 128 --exposure 0.2 {PLAIN} -o {file}"));
        let said = folder.messages(&format!("read {file} -n sphere -o d.csv"));
        let counts = said.split_once("(of all: ").unwrap().1.lines().next().unwrap().to_owned();
        transparent.push(counts);
        materials.push(nearest(&answer(&folder.read("d.csv"))).to_owned());
    }
    assert_eq!(materials, ["pearl-paint"; 2]);
    assert_eq!(transparent[0], transparent[1]);
}

/// A material that reflects nothing: alone it is refused, among others it is the least likely.
#[test]
fn black_materials() {
    let folder = with_image();
    let all = folder.read("materials.csv");
    let first = all.lines().filter_map(|line| line.strip_prefix("material-0"));
    let zeros: String =
        first.map(|line| format!("soot{},0\n", line.rsplit_once(',').unwrap().0)).collect();
    let soot = format!("name,o,p,q,value\n{zeros}");
    folder.write("soot.csv", &soot);
    let read = "read image.csv --normals normals.csv --out new.csv";
    for criterion in ["image-centered", "standard"] {
        folder.write("scene.toml", scene(criterion, 10_000, "[]"));
        folder.write("materials.csv", &soot);
        folder.ok("basis --scene scene.toml --out night.bin");
        assert_fails(&folder, &format!("{read} --table night.bin"), &["night.bin", "black"]);
        folder.write("materials.csv", &all);
        folder.ok(BASIS);
        let with_soot = format!("{read} --table b.bin --material soot.csv");
        assert_fails(&folder, &with_soot, &["b.bin", "black", "--material"]);
    }
    folder.write("both.csv", format!("{all}{zeros}"));
    let found = answer(&folder.ok(&format!("{READ} --material both.csv")));
    assert_eq!(nearest(&found), "material-2");
    assert_eq!(get(&found, "material-evidence", "soot")[0][0], 4.0);
}

/// Missing databases with as many lights and materials as the shipped ones, but other ones.
#[test]
fn shipped_databases_replace_only_themselves() {
    let folder = with_image();
    fs::copy(shipped_path("inputs/materials.csv"), folder.path("materials.csv")).unwrap();
    folder.write("lights.csv", lights(DEGREE, 26));
    folder.ok("basis --scene scene.toml --out other.bin");
    fs::remove_file(folder.path("lights.csv")).unwrap();
    let read = "read image.csv --normals normals.csv --table other.bin --components 9";
    assert_fails(&folder, &format!("{read} --out new.csv"), &["other.bin", "--light"]);
    folder.write("lights.csv", lights(DEGREE, 26));
    folder.ok(read);
}
