//! Hard cases of scenes: images without variance, objects of few normals, black lights and
//! materials, and coefficients out of range. `report stability` measures more of them, and the
//! runtime's properties cover any degree and order.

use crate::support::files::built;
use crate::support::{
    BASIS, Folder, SHADE, SHADED, assert_fails, assert_near, lights, materials, numbers, rows,
    scene,
};
use crate::tolerances;
use eigenshade_table::{light, material};

/// If images do not vary, image-centered tables have the constant alone, and standard tables no
/// component.
#[test]
fn no_variance_gives_no_components() {
    for (criterion, count, components) in [("image-centered", 4, 1), ("standard", 1, 0)] {
        let folder = Folder::of_size(0, 0, [3, count]);
        folder.replace("scene.toml", "image-centered", criterion);
        folder.ok(BASIS);
        let table = folder.table("b.bin");
        assert_eq!((table.components.len(), table.spectrum.len()), (components, components));
        folder.shaded("--format f64");
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
            let text = scene(criterion, 10_000, "[]").replace("\"sphere\"", "\"normals.csv\"");
            let normals = format!("x,y,z,weight\n{normals}");
            let folder = built(&text, &[("normals.csv", normals.into())]);
            let reference = folder.shaded("--method modes");
            let what = format!("{name}, {criterion}");
            let found = folder.shaded("--format f64");
            assert_near(&what, &found, &reference, tolerances::GENERAL_PICTURES);
            let count = folder.ok("eigenvalues --table b.bin").lines().count() - 1;
            assert!(count <= most, "{name}, {criterion}: {count} components of at most {most}");
        }
    }
}

/// CSV rows of a light of degree 4 whose coefficients are all 0.
fn night() -> String {
    light::indices(4).map(|(l, m)| format!("night,{l},{m},0,0,0\n")).collect()
}

#[test]
fn a_light_of_zeros() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 2) + &night());
    assert_fails(&folder, BASIS, &["scene.toml", "`night`", "normalize = \"none\""]);
    folder.replace("scene.toml", "rotation = \"any\"", "rotation = \"any\"\nnormalize = \"none\"");
    folder.ok(BASIS);
    assert_black(&folder, "night,");
    // No other light.
    folder.write("lights.csv", "name,l,m,r,g,b\n".to_owned() + &night());
    assert!(folder.ok(BASIS).contains("components   1 of 10000"));
    assert_black(&folder, "night,");
}

#[test]
fn a_material_of_zeros() {
    for count in [3, 0] {
        let folder = Folder::new();
        let soot = material::indices(3).map(|(o, p, q)| format!("soot,{o},{p},{q},0\n"));
        folder.write("materials.csv", materials(3, count) + &soot.collect::<String>());
        folder.ok(BASIS);
        assert_black(&folder, ",soot,");
    }
}

/// Asserts that the images of this light or material are exactly black, in every format.
fn assert_black(folder: &Folder, name: &str) {
    for options in ["", "--format f64", "--method eigen", "--method modes"] {
        let text = folder.ok(&format!("{SHADE} {options}"));
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
        let rows: String =
            materials(3, 2).lines().skip(1).map(|line| format!("{line}{size}\n")).collect();
        folder.write("materials.csv", format!("name,o,p,q,value\n{rows}"));
        assert_fails(&folder, BASIS, &["scene.toml", "out of range"]);
    }
}
