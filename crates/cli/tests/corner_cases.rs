//! Hard cases of scenes: images without variance, black lights and materials, and coefficients out of
//! range. `report stability` measures more of them, and the
//! runtime's properties cover any degree and order.

use crate::support::{
    BASIS, Folder, SHADE, SHADED, assert_fails, lights, materials, numbers, rows,
};
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

/// CSV rows of a light of degree 4 whose coefficients are all 0.
fn night() -> String {
    light::indices(4).map(|(l, m)| format!("night,{l},{m},0,0,0\n")).collect()
}

#[test]
fn a_light_of_zeros() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 2) + &night());
    assert_fails(&folder, BASIS, &["scene.toml", "`night`", "normalize = \"none\""]);
    folder.replace("scene.toml", "[light]", "[light]\nnormalize = \"none\"");
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
