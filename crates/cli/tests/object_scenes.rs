//! Scene files of objects with shadows, and `info` of packed objects.

use crate::support::{Folder, assert_contains, assert_fails, lights, materials};
use eigenshade_testing::glb::Glb;

/// A plate with a wall across it.
const RELIEF: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -0.2 -1 0.8\nv 0.2 -1 0.8\n\
    v 0.2 1 0.8\nv -0.2 1 0.8\nf 1 2 3 4\nf 5 6 7 8\nf 1 5 8 4\nf 6 2 3 7\n";

const SCENE: &str = "[geometry]\nobject = \"relief.obj\"\nsize = 16\n\n\
    [material]\nname = \"gold-metallic-paint\"\n";

/// A folder with the relief and its scene.
fn relief() -> Folder {
    let folder = Folder::new();
    folder.write("relief.obj", RELIEF);
    folder.write("relief.toml", SCENE);
    folder
}

#[test]
fn a_scene_of_an_object_gives_the_file_of_the_command() {
    let folder = relief();
    let printed = folder.ok("basis --scene relief.toml --out a.bin");
    assert_contains(&printed, &["16 x 16, 256 with an object", "degree       16"]);
    let command = "pack-object relief.obj --shadows --material gold-metallic-paint --size 16";
    folder.ok(&format!("{command} --out b.bin"));
    assert_eq!(folder.bytes("a.bin"), folder.bytes("b.bin"));
    // All fields.
    let geometry = "object = \"relief.obj\"\nview = \"left\"\nflat = true";
    folder.replace("relief.toml", "object = \"relief.obj\"", geometry);
    folder.write("codes.toml", folder.read("relief.toml") + "[basis]\ncodes = 20\n");
    folder.ok("basis --scene codes.toml --out a.bin");
    folder.ok(&format!("{command} --view left --flat --codes 20 --out b.bin"));
    assert_eq!(folder.bytes("a.bin"), folder.bytes("b.bin"));
    // Databases of the scene, in a folder of another name; another degree and other turns.
    folder.write("mine.csv", materials(3, 2));
    folder.write("lights.csv", lights(4, 3));
    folder.replace(
        "codes.toml",
        "name = \"gold-metallic-paint\"",
        "name = \"material-1\"\ndatabase = \"mine.csv\"",
    );
    let light = "[light]\ndegree = 4\ndatabase = \"lights.csv\"\nrotation = ";
    let all = folder.read("codes.toml");
    let mut files = Vec::new();
    for rotation in ["any", "tilts 45", "tilts 12.5"] {
        folder.write("codes.toml", format!("{all}{light}\"{rotation}\"\n"));
        folder.ok("basis --scene codes.toml --out a.bin");
        assert_contains(&folder.ok("info --table a.bin"), &["degree                   4\n"]);
        files.push(folder.bytes("a.bin"));
    }
    assert!(files[0] != files[1] && files[1] != files[2] && files[0] != files[2]);
}

#[test]
fn bad_scenes_of_objects_are_refused() {
    let folder = relief();
    let light = "[light]\nrotation = \"tilts 45\"\n\n[material]";
    folder.replace("relief.toml", "[material]", light);
    folder.write("lights.csv", lights(4, 3));
    let scene = folder.read("relief.toml");
    for (from, to, expected) in [
        ("size = 16", "size = 1", "geometry.size = 1; give 2 to 512"),
        ("size = 16", "sise = 16", "bad.toml:3: unknown field `sise`"),
        ("size = 16", "view = \"up\"", "geometry.view = \"up\"; give front"),
        ("size = 16", "normals = \"sphere\"", "unknown field `normals`"),
        ("tilts 45", "tilts 0", "light.rotation = \"tilts 0\"; give"),
        ("tilts 45", "tilts 91", "light.rotation = \"tilts 91\"; give"),
        ("tilts 45", "tilts nan", "light.rotation = \"tilts nan\"; give"),
        ("tilts 45", "vertical", "light.rotation = \"vertical\"; give"),
        ("rotation", "degree = 17\nrotation", "light.degree = 17; give 0 to 16"),
        ("rotation", "database = \"no.csv\"\nrotation", "no.csv"),
        ("rotation", "database = \"lights.csv\"\nrotation", "degree = 16, and its database has 4"),
        ("gold-metallic-paint", "gold-metalic-paint", "`gold-metalic-paint` is neither"),
        ("gold-metallic-paint", "lights.csv", "is not the name of a shipped material; name"),
        ("relief.obj", "no.obj", "no.obj"),
        ("relief.obj", "relief.toml", "only a mesh has shadows"),
    ] {
        assert!(scene.contains(from));
        folder.write("bad.toml", scene.replacen(from, to, 1));
        assert_fails(&folder, "basis --scene bad.toml --out a.bin", &[expected]);
    }
    assert_fails(&folder, "basis --scene relief.toml --out relief.obj", &["replace the input"]);
    folder.write("a.bin", "");
    assert_fails(&folder, "basis --scene relief.toml --check a.bin", &["--check is for tables"]);
}

/// The numbers in front of `bytes`.
fn parts(printed: &str) -> Vec<usize> {
    let parts = printed.lines().filter_map(|line| line.strip_suffix(" bytes"));
    parts.map(|line| line[24..].trim().replace(',', "").parse().unwrap()).collect()
}

#[test]
fn packed_objects_are_described() {
    let folder = relief();
    folder.ok("basis --scene relief.toml --out shadows.bin");
    folder.write("sphere.glb", Glb::sphere(24).bytes());
    folder.ok("pack-object sphere.glb --size 32 --out own.bin");
    for (name, fields) in [
        ("shadows.bin", &["with shadows", "16 x 16", "rank                     64"][..]),
        ("own.bin", &["in its own materials", "32 x 32", "regions                  1"]),
    ] {
        let printed = folder.ok(&format!("info --table {name}"));
        assert_contains(&printed, fields);
        let parts = parts(&printed);
        let (file, parts) = parts.split_last().unwrap();
        let bytes = folder.bytes(name);
        assert_eq!([*file, parts.iter().sum()], [bytes.len(); 2], "{printed}");
        assert!(folder.ok(&format!("info --json --table {name}")).starts_with('{'));
        for length in [6, 7, 13, 17, 19, 300, bytes.len() - 1] {
            folder.write("cut.bin", &bytes[..length]);
            assert_fails(&folder, "info --table cut.bin", &["cut.bin: it is cut or damaged; pack"]);
        }
    }
}
