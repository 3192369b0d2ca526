//! Statics of a scene, as a build script asks for them.

use eigenshade_generator::build::{Format, write};
use eigenshade_generator::scene_file::inputs;
use std::fs;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A scene of the repository's databases, these lines added.
fn scene(folder: &Path, geometry: &str, basis: &str) -> PathBuf {
    let inputs = repository().join("tables/inputs");
    let inputs = inputs.to_str().expect("a path in UTF-8");
    let path = folder.join("scene.toml");
    let text = format!(
        "[geometry]\n{geometry}\n[light]\ndegree = 2\ndatabase = \"{inputs}/lights.csv\"\n\
         rotation = \"any\"\n[material]\norder = 2\ndatabase = \"{inputs}/materials.csv\"\n\
         [basis]\n{basis}\n"
    );
    fs::write(&path, text).expect("a file");
    path
}

#[test]
fn integers_stand_beside_floats_where_they_serve() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    let formats = [Format::Q15, Format::Q31];
    for (geometry, basis, reason) in [
        ("normals = \"sphere\"", "criterion = \"image-centered\"\ncomponents = 4", None),
        ("normals = \"sphere\"", "criterion = \"standard\"\ncomponents = 4", Some("mean image")),
        (
            "normals = \"sphere\"",
            "criterion = \"image-centered\"\ncomponents = 4\nmodes = 20",
            Some("selection"),
        ),
        (
            "normals = \"slant-density\"\ndensity = \"cos(a)^2\"",
            "criterion = \"image-centered\"\ncomponents = 4",
            Some("only tables of a sphere"),
        ),
    ] {
        let scene = scene(folder.path(), geometry, basis);
        let warnings = write(&scene, &out, &formats).expect("a table");
        let text = fs::read_to_string(&out).expect("a file");
        assert!(text.starts_with("// eigenshade-generator, from "), "{}", &text[..80]);
        let of_sphere = geometry.contains("\"sphere\"");
        let kind = if of_sphere { "table!(sphere passes " } else { "table!(general);" };
        assert!(text.contains(&format!("\neigenshade::{kind}")), "{kind}");
        for name in ["q15", "q31"] {
            assert_eq!(text.contains(&format!("pub mod {name} {{")), reason.is_none());
        }
        assert_eq!(warnings.len(), if reason.is_some() { 2 } else { 0 });
        for (line, name) in warnings.iter().zip(["q15", "q31"]) {
            assert!(line.contains(&format!("scene.toml: no {name}: ")), "{line}");
            assert!(line.contains(reason.unwrap_or_default()), "{line}");
        }
        // None are asked for, none are missed.
        assert!(write(&scene, &out, &[]).expect("a table").is_empty());
    }
}

#[test]
fn faults_leave_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    let sphere = "normals = \"sphere\"";
    let of_materials = "criterion = \"image-centered\"\ncomponents = 4\nstore = \"materials\"";
    for (basis, words) in [
        (of_materials, ["scene.toml: ", "store = \"projection\""]),
        ("criterion = \"image-centered\"", ["scene.toml: ", "either components or tolerance"]),
        ("criterion = \"of mine\"\ncomponents = 4", ["scene.toml:11: ", "of mine"]),
    ] {
        let scene = scene(folder.path(), sphere, basis);
        let error = write(&scene, &out, &[]).expect_err("a fault").to_string();
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
        assert!(!out.exists());
    }
}

/// Cargo watches these, those that are missing too.
#[test]
fn inputs_are_all_files_of_a_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let basis = "criterion = \"image-centered\"\ncomponents = 4";
    let databases = ["lights.csv", "materials.csv"];
    for (geometry, files) in [
        ("normals = \"sphere\"", vec![]),
        ("normals = \"mesh.stl\"", vec!["mesh.stl"]),
        ("normals = \"map.png\"\nmask = \"mask.png\"", vec!["map.png", "mask.png"]),
        ("normals = \"slant-density\"\ndensity = \"cos(a)\"", vec![]),
        ("normals = \"slant-density\"\ndensity = \"slants.CSV\"", vec!["slants.CSV"]),
    ] {
        let scene = scene(folder.path(), geometry, basis);
        let found = inputs(&scene);
        let names: Vec<_> =
            found.iter().map(|path| path.file_name().expect("a name").to_owned()).collect();
        let expected = ["scene.toml"].into_iter().chain(databases).chain(files);
        assert_eq!(names, expected.collect::<Vec<_>>());
        assert!(found.iter().all(|path| path.is_absolute()));
    }
    let none = folder.path().join("none.toml");
    assert_eq!(inputs(&none), [none]);
}
