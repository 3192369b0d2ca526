//! Hard cases of scenes: images without variance, objects of few normals, black lights and
//! materials, and coefficients out of range. `experiments stability` measures more of them, and the
//! runtime's properties cover any degree and order.

use crate::support::{
    Folder, PAIR, SHADED, assert_fails, difference, lights, materials, numbers, rows, scene,
};
use crate::tolerances;

/// If images do not vary, image-centered tables have the constant alone, and standard tables no
/// component.
#[test]
fn no_variance_gives_no_components() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(0, 3));
    for (criterion, count, components) in [("image-centered", 4, 1), ("standard", 1, 0)] {
        folder.write("materials.csv", materials(0, count));
        let text = scene(criterion, 10_000, "[]").replace("degree = 4", "degree = 0");
        folder.write("scene.toml", text.replace("order = 3", "order = 0"));
        folder.ok("basis --scene scene.toml --out b.bin");
        let table = folder.table("b.bin");
        assert_eq!((table.components.len(), table.spectrum.len()), (components, components));
        folder.shaded("");
        folder.ok("info --table b.bin");
    }
}

/// Each object has no more components than it can have, and its pictures are right.
#[test]
fn objects_of_few_normals() {
    let aslant = "0.6,0,0.8,1\n";
    let patch = |k: u32| format!("{},{},1,1\n", f64::from(k % 20) * 1e-5, f64::from(k / 20) * 1e-5);
    for (name, normals, most) in [
        ("toward the camera", "0,0,1,1\n".to_owned(), 1),
        ("on the rim", "0,1,0,1\n".into(), 1),
        ("aslant, a hundred times", aslant.repeat(100), 1),
        ("a roof", format!("{aslant}-0.6,0,0.8,3\n"), 2),
        ("two within 1e-9", format!("{aslant}0.600000001,0,0.8,1\n"), 2),
        ("a patch of a hundredth of a degree", (0..400).map(patch).collect(), 10),
    ] {
        for criterion in ["image-centered", "standard"] {
            let folder = Folder::new();
            folder.write("normals.csv", format!("x,y,z,weight\n{normals}"));
            let text = scene(criterion, 10_000, "[]").replace("\"sphere\"", "\"normals.csv\"");
            folder.write("scene.toml", text);
            folder.ok("basis --scene scene.toml --out b.bin");
            let reference = folder.shaded("--method modes");
            let error = difference(&folder.shaded("--format f64"), &reference);
            let count = folder.ok("eigenvalues --table b.bin").lines().count() - 1;
            println!("{name}: {count} components, pictures {error:.1e}");
            assert!(error <= tolerances::GENERAL_PICTURES, "{name}, {criterion}: {error:e}");
            assert!(count <= most, "{name}, {criterion}: {count} components of at most {most}");
        }
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
        let text =
            folder.ok(&format!("shade --table b.bin {PAIR} --normals normals.csv {options}"));
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
