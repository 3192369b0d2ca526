//! Statics of a scene, as a build script asks for them.

use eigenshade_generator::build::write;
use eigenshade_generator::scene_file::inputs;
use std::fs;
use std::path::{Path, PathBuf};

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// A scene of the repository's databases, these lines added.
fn scene(folder: &Path, basis: &str) -> PathBuf {
    let inputs = repository().join("tables/inputs");
    let inputs = inputs.to_str().expect("a path in UTF-8");
    let path = folder.join("scene.toml");
    let text = format!(
        "[light]\ndegree = 2\ndatabase = \"{inputs}/lights.csv\"\n\
         [material]\norder = 2\ndatabase = \"{inputs}/materials.csv\"\n\
         [basis]\n{basis}\n"
    );
    fs::write(&path, text).expect("a file");
    path
}

#[test]
fn integers_stand_beside_floats_where_they_serve() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    for ([degree, order, components], reason) in
        [([2, 2, 4], None), ([9, 7, 1000], Some("component 147 "))]
    {
        let basis = format!("criterion = \"image-centered\"\ncomponents = {components}");
        let scene = scene(folder.path(), &basis);
        let text = fs::read_to_string(&scene).expect("a scene");
        let text = text.replace("degree = 2", &format!("degree = {degree}"));
        fs::write(&scene, text.replace("order = 2", &format!("order = {order}"))).expect("a file");
        let warnings = write(&scene, &out).expect("a table");
        let text = fs::read_to_string(&out).expect("a file");
        assert!(text.starts_with("// eigenshade-generator, from "), "{}", &text[..80]);
        assert!(text.contains("\neigenshade::table!(sphere passes "));
        assert_eq!(text.contains("pub mod q15 {"), reason.is_none());
        assert_eq!(warnings.len(), usize::from(reason.is_some()));
        for line in &warnings {
            assert!(line.contains("scene.toml: no q15: "), "{line}");
            assert!(line.contains(reason.unwrap_or_default()), "{line}");
        }
    }
}

#[test]
fn tables_that_the_runtime_does_not_take_are_refused() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    let basis = "criterion = \"image-centered\"\ncomponents = 4";
    let path = scene(folder.path(), basis);
    let text = fs::read_to_string(&path).expect("a scene");
    for (from, to, reason) in [
        ("degree = 2", "degree = 13", "degree 13 and order 2, the runtime goes to 12 and 12"),
        ("[basis]", "[basis]\nstore = \"materials\"", "stores only transfers"),
    ] {
        fs::write(&path, text.replace(from, to)).expect("a file");
        let refused = write(&path, &out).expect_err(reason).to_string();
        assert!(refused.contains("scene.toml: ") && refused.contains(reason), "{refused}");
        assert!(!out.exists());
    }
}

/// Sources and gloss are beside the table, exactly those of the files; a light without a map and a
/// material without gloss are named, and a scene of nothing else is refused.
#[test]
fn highlights_stand_beside_the_table() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    let inputs = repository().join("tables/inputs");
    let at = |name: &str| inputs.join(name).display().to_string();
    let basis = "criterion = \"image-centered\"\ncomponents = 4";
    let path = scene(folder.path(), basis);
    let text = fs::read_to_string(&path).expect("a scene");
    let text = text.replace("inputs/materials.csv", "inputs/merl.csv");
    let section = |most: usize, gloss: &str| {
        let (sources, gloss) = (at("sources.csv"), at(gloss));
        format!("{text}[highlights]\nsources = \"{sources}\"\ngloss = \"{gloss}\"\nmost = {most}\n")
    };
    fs::write(&path, section(2, "gloss.csv")).expect("a file");
    let named = eigenshade_generator::scene_file::inputs(&path);
    assert!(
        named.contains(&inputs.join("sources.csv")) && named.contains(&inputs.join("gloss.csv"))
    );
    let warnings = write(&path, &out).expect("a table");
    let [dark] = &warnings[..] else { panic!("{warnings:?}") };
    assert!(dark.contains("no sources of the lights blender-city, "), "{dark}");
    assert!(dark.contains("they are not in") && !dark.contains(" studio"), "{dark}");
    let statics = fs::read_to_string(&out).expect("a file");
    let numbers = |text: &str| -> Vec<f32> {
        let number = |c: char| !(c.is_ascii_digit() || "+-.e".contains(c));
        text.split(number).filter_map(|number| number.parse().ok()).collect()
    };
    let after = |name: &str| {
        let from = statics.find(&format!("(\"{name}\",")).expect(name) + name.len() + 3;
        &statics[from..]
    };
    let rows = |file: &str, start: &str| -> Vec<Vec<f32>> {
        let text = fs::read_to_string(inputs.join(file)).expect("a file");
        text.lines()
            .filter(|line| line.starts_with(start))
            .map(|line| numbers(&line[start.len()..]))
            .collect()
    };
    let of_studio = after("studio");
    let found = numbers(&of_studio[..of_studio.find("])").expect("an end")]);
    assert_eq!(found, rows("sources.csv", "studio,")[..2].concat());
    let of_nylon = after("nylon");
    let found = numbers(of_nylon.lines().next().expect("a line"));
    // f90 follows the albedo here.
    let [row] = &rows("gloss.csv", "nylon,")[..] else { panic!("one row") };
    let expected = [&row[..4], &row[7..10], &row[4..7]].concat();
    assert_eq!(found, expected);

    for (text, expected) in [
        (section(33, "gloss.csv"), "highlights.most = 33"),
        (section(2, "none.csv"), "none.csv"),
        (
            section(2, "gloss.csv").replace("inputs/merl.csv", "inputs/materials.csv"),
            "the gloss of no material",
        ),
        (section(2, "gloss.csv").replace("most = 2", "most = 2\nmore = 1"), "more"),
    ] {
        fs::write(&path, text).expect("a file");
        let error = write(&path, &out).expect_err("an error").to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn faults_leave_nothing_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let out = folder.path().join("table.rs");
    let of_materials = "criterion = \"image-centered\"\ncomponents = 4\nstore = \"materials\"";
    for (basis, words) in [
        (of_materials, ["scene.toml: ", "store = \"projection\""]),
        ("criterion = \"image-centered\"", ["scene.toml: ", "either components or tolerance"]),
        ("criterion = \"of mine\"\ncomponents = 4", ["scene.toml:8: ", "of mine"]),
    ] {
        let scene = scene(folder.path(), basis);
        let error = write(&scene, &out).expect_err("a fault").to_string();
        assert!(words.iter().all(|word| error.contains(word)), "{error}");
        assert!(!out.exists());
    }
}

/// Cargo watches these, those that are missing too.
#[test]
fn inputs_are_all_files_of_a_scene() {
    let folder = tempfile::tempdir().expect("a folder");
    let basis = "criterion = \"image-centered\"\ncomponents = 4";
    let found = inputs(&scene(folder.path(), basis));
    let names: Vec<_> =
        found.iter().map(|path| path.file_name().expect("a name").to_owned()).collect();
    assert_eq!(names, ["scene.toml", "lights.csv", "materials.csv"]);
    assert!(found.iter().all(|path| path.is_absolute()));
    let none = folder.path().join("none.toml");
    assert_eq!(inputs(&none), [none]);
}
