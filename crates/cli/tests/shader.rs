//! `shader` writes functions whose values are the direct sum, in every language, and refuses what
//! is no single scene. Their compilers are tried by packages/eigenshade in a browser.

use crate::interpreter::Function;
use crate::support::{
    Folder, assert_fails, assert_near, assert_usage_errors, difference, numbers, of_equal_areas,
    rows, shipped_path, shipped_scene,
};
use eigenshade_testing::vectors::unit;
use serde_json::Value;

const ONE: &str = "--table b.bin --light lights.csv:light-1 --material materials.csv:material-2";

/// The sums of a table with all components in f32 against the direct sum, relative to the peak:
/// measured 1.5e-7.
const F32: f64 = 5e-7;

/// The text of a language and the array.
fn written(folder: &Folder, options: &str) -> (String, Vec<[f64; 4]>) {
    let (text, vectors, terms) = parts(folder, &format!("{ONE} {options}"));
    assert_eq!(terms, vectors.len(), "no recurrences");
    (text, vectors)
}

/// The text of the shader with these options, the array, and the number of terms.
pub fn parts(folder: &Folder, options: &str) -> (String, Vec<[f64; 4]>, usize) {
    let text = folder.ok(&format!("shader --quiet {options}"));
    let json: Value = serde_json::from_str(&folder.ok(&format!("shader --quiet {options} --json")))
        .expect("JSON");
    assert_eq!(json["text"].as_str(), Some(text.as_str()));
    let vectors = json["vectors"].as_array().expect("vectors").iter();
    let vectors: Vec<_> = vectors
        .map(|vector| [0, 1, 2, 3].map(|place| vector[place].as_f64().expect("a number")))
        .collect();
    (text, vectors, json["terms"].as_u64().expect("a number") as usize)
}

/// The values of the function at the folder's normals, channel after channel.
fn evaluated(folder: &Folder, text: &str, vectors: &[[f64; 4]]) -> Vec<f64> {
    Function::new(text).values(vectors, &normals(folder))
}

/// The folder's normals.
pub fn normals(folder: &Folder) -> Vec<[f64; 3]> {
    let rows = rows(&folder.read("normals.csv"), "x,y,z");
    numbers(&rows, 3).as_chunks::<3>().0.iter().copied().map(unit).collect()
}

#[test]
fn functions_are_the_direct_sum() {
    let folder = Folder::with_table();
    let reference = folder.irradiance(&format!("{ONE} --normals normals.csv --method modes"));
    for lang in ["glsl", "glsl-block", "wgsl"] {
        let (text, vectors) = written(&folder, &format!("--lang {lang}"));
        assert!(text.contains(&vectors.len().to_string()), "the length of the array: {text}");
        assert_near(lang, &evaluated(&folder, &text, &vectors), &reference, F32);
    }
    let (text, _) = written(&folder, "--lang glsl-texture");
    let (plain, _) = written(&folder, "--lang glsl");
    let fetched =
        text.replace("texelFetch(eigenshade, ivec2(", "eigenshade[").replace(", 0), 0)", "]");
    assert!(fetched.lines().skip(1).eq(plain.lines().skip(1)), "{fetched}");
}

#[test]
fn fewer_terms_are_near_the_whole() {
    let folder = Folder::with_table();
    let (text, vectors) = written(&folder, "--lang glsl");
    let whole = evaluated(&folder, &text, &vectors);
    // A tolerance is a root mean square; measured at single normals: 0.06 and 0.3.
    let mut before = vectors.len();
    for (tolerance, worst) in [("1e-2", 0.1), ("0.1", 0.5)] {
        let (text, vectors) = written(&folder, &format!("--lang glsl --tolerance {tolerance}"));
        assert!(vectors.len() < before, "{} terms", vectors.len());
        before = vectors.len();
        let found = difference(&evaluated(&folder, &text, &vectors), &whole);
        println!("{tolerance}: {found:.1e}");
        assert!(found > 0.0 && found <= worst, "{tolerance}: {found}");
    }
}

#[test]
fn more_vectors_than_promised_give_a_note() {
    let folder = Folder::new();
    let of = |lang: &str| {
        let inputs = "--table pbr --light lobby --material gold-metallic-paint --out scene.txt";
        folder.messages(&format!("shader --lang {lang} {inputs}"))
    };
    assert!(of("glsl").contains("note: 454 vectors are more than the 224 "), "{}", of("glsl"));
    for lang in ["glsl-block", "glsl-texture", "wgsl"] {
        assert!(!of(lang).contains("vectors"), "{}", of(lang));
    }
}

/// The error of the truncation that `tables/color.toml` states, relative to the peak of each
/// picture.
const CUT: f64 = 2e-5;

/// Every shipped light on every material in color, at normals spread over a sphere's picture.
#[test]
fn trimming_the_table_in_color_shows_in_no_picture() {
    let folder = Folder::new();
    let scene = shipped_scene("color");
    let whole: Vec<_> = scene.lines().filter(|line| !line.starts_with("trim = ")).collect();
    assert_eq!(whole.len() + 1, scene.lines().count());
    folder.write("whole.toml", whole.join("\n"));
    folder.ok("basis --scene whole.toml --out whole.bin");
    folder.write("disc.csv", of_equal_areas(100));
    let inputs = shipped_path("inputs");
    let shaded = |table: &str| {
        folder.irradiance(&format!(
            "--quiet --table {table} --normals disc.csv --format f64 --light {inputs}/lights.csv \
             --material {inputs}/merl.csv"
        ))
    };
    let (found, expected) = (shaded("color"), shaded("whole.bin"));
    let pairs = found.chunks(300).zip(expected.chunks(300));
    let most = pairs.map(|(found, expected)| difference(found, expected)).fold(0.0, f64::max);
    println!("{} pictures: {most:.1e}", found.len() / 300);
    assert!(most > 1e-7 && most <= CUT, "{most}");
    for (table, terms) in [("color", 194), ("whole.bin", 296)] {
        let inputs = "--light lobby --material gold-metallic-paint --json";
        let json = folder.ok(&format!("shader --quiet --lang glsl --table {table} {inputs}"));
        let json: Value = serde_json::from_str(&json).expect("JSON");
        assert_eq!(json["terms"].as_u64(), Some(terms));
    }
}

#[test]
fn several_entries_are_refused() {
    let folder = Folder::with_table();
    for (options, named) in [
        ("--light lights.csv --material materials.csv:material-2", "lights.csv: it has 3 entries"),
        ("--light lights.csv:light-1 --material materials.csv", "materials.csv: it has 4 entries"),
        ("--light lights.csv:z --material materials.csv:material-2", "it has no light `z`"),
    ] {
        assert_fails(&folder, &format!("shader --lang glsl --table b.bin {options}"), &[named]);
    }
}

/// The text of a scene with a prefix, and that without, differ by the prefix of each name.
#[test]
fn names_begin_with_a_prefix() {
    let folder = Folder::with_table();
    for lang in ["glsl", "glsl-block", "glsl-texture", "wgsl"] {
        let (plain, _) = written(&folder, &format!("--lang {lang}"));
        let (named, vectors) = written(&folder, &format!("--lang {lang} --prefix front_"));
        assert!(!named.replace("front_irradiance", "").contains("irradiance"), "{named}");
        assert_eq!(named.matches("front_").count(), plain.matches("igenshade").count() + 1);
        assert_eq!(named.replace("front_", ""), plain);
        assert!(!vectors.is_empty());
    }
    let (placed, _) = written(&folder, "--lang wgsl --prefix a --binding 2,3");
    assert!(placed.contains("@group(2) @binding(3) var<uniform> aeigenshade"), "{placed}");
    let wrong = ["--prefix a__b", "--prefix gl_a", "--prefix 1a", "--prefix a-b", "--binding 1"];
    let wrong = wrong.map(|options| format!("shader {ONE} --lang wgsl {options}"));
    assert_usage_errors(&folder, &wrong.each_ref().map(String::as_str));
    let command = format!("shader {ONE} --lang glsl --binding 1,0");
    assert_fails(&folder, &command, &["--binding is for --lang wgsl"]);
}
