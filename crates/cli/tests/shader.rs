//! `shader` writes functions that are valid in every language, and refuses what is no single scene.
//! packages/eigenshade compares their values in a browser with the pixels of its module.

use crate::support::{
    Folder, assert_fails, assert_usage_errors, difference, of_equal_areas, shipped_path,
    shipped_scene,
};
use naga::front::{glsl, wgsl};
use naga::valid::{Capabilities, ValidationFlags, Validator};
use serde_json::Value;

/// All languages.
const LANGUAGES: [&str; 4] = ["glsl", "glsl-block", "glsl-texture", "wgsl"];

const ONE: &str = "--table b.bin --light lights.csv:light-1 --material materials.csv:material-2";

/// The text of a language and the array.
fn written(folder: &Folder, options: &str) -> (String, Vec<[f64; 4]>) {
    let (text, vectors, terms) = parts(folder, &format!("{ONE} {options}"));
    assert_eq!(terms, vectors.len());
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

/// The module of a text; in GLSL with the declarations that naga takes, which are Vulkan's, and an
/// entry.
fn module(lang: &str, text: &str) -> naga::Module {
    if lang == "wgsl" {
        let parsed = wgsl::parse_str(text);
        return parsed.unwrap_or_else(|error| panic!("{}", error.emit_to_string(text)));
    }
    const BLOCK: &str = "layout(std140, set = 0, binding = 0) uniform";
    let image = "layout(set = 0, binding = 0) uniform texture2D image;\n\
                 layout(set = 0, binding = 1) uniform sampler how;";
    let text = text
        .replace("layout(std140) uniform", BLOCK)
        .replace("uniform highp sampler2D eigenshade;", image)
        .replace("texelFetch(eigenshade,", "texelFetch(sampler2D(image, how),");
    let text = match text.strip_prefix("uniform vec4 ") {
        Some(rest) => format!("{BLOCK} Block {{ vec4 {}", rest.replacen(';', "; };", 1)),
        None => text,
    };
    let whole = format!(
        "#version 450\nlayout(location = 0) out vec3 color;\n{text}\n\
         void main() {{ color = irradiance(vec3(0.0, 0.0, 1.0)); }}\n"
    );
    let parsed = glsl::Frontend::default().parse(&naga::ShaderStage::Fragment.into(), &whole);
    parsed.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&whole)))
}

/// Of each shipped table, with and without sources.
#[test]
fn texts_are_valid() {
    let folder = Folder::new();
    for lang in LANGUAGES {
        for table in ["sphere", "color", "pbr"] {
            for options in ["", "--sources 2", "--tolerance 0.1"] {
                let inputs = "--light lobby --material gold-metallic-paint2";
                let text = folder
                    .ok(&format!("shader -q --lang {lang} --table {table} {inputs} {options}"));
                let mut validator = Validator::new(ValidationFlags::all(), Capabilities::empty());
                let valid = validator.validate(&module(lang, &text));
                valid.unwrap_or_else(|error| panic!("{}", error.emit_to_string(&text)));
            }
        }
    }
}

#[test]
fn arrays_are_declared_with_their_lengths() {
    let folder = Folder::with_table();
    for lang in ["glsl", "glsl-block", "wgsl"] {
        let (text, vectors) = written(&folder, &format!("--lang {lang}"));
        assert!(text.contains(&vectors.len().to_string()), "the length of the array: {text}");
    }
}

#[test]
fn a_tolerance_leaves_terms_out() {
    let folder = Folder::with_table();
    let count = |options: &str| written(&folder, &format!("--lang glsl {options}")).1.len();
    let [all, some, few] = ["", "--tolerance 1e-2", "--tolerance 0.1"].map(count);
    assert!(all > some && some > few && few > 0, "{all}, {some}, {few}");
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

/// The text of a scene with a prefix, and that without, differ by the prefix of each name.
#[test]
fn names_begin_with_a_prefix() {
    let folder = Folder::with_table();
    for lang in LANGUAGES {
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
