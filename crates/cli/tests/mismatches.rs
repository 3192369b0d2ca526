//! Files and options that do not belong together, and would give a wrong picture without a word.

use crate::support::files::map;
use crate::support::{Folder, ORDER, assert_contains, assert_fails, materials, stderr};

#[test]
fn sources_of_other_lights_are_not_left_beside_new_ones() {
    let folder = Folder::new();
    folder.write("map.pfm", map(1.0));
    for name in ["beside.csv", "beside.sources.csv", "beside.sources.errors.csv"] {
        folder.write(name, "");
    }
    let what = "beside.sources.csv and beside.sources.errors.csv would be used with the new lights";
    for command in ["map.pfm", "lights.csv"] {
        assert_fails(&folder, &format!("light {command} -o beside.csv"), &[what]);
    }
    folder.ok("light map.pfm -o other.csv");
    folder.write("other.sources.errors.csv", "");
    assert_fails(&folder, "light map.pfm -o other.csv", &["error: other.sources.errors.csv would"]);
    folder.ok("render -l lobby -m nylon -s 64 -o a.png");
    assert_fails(&folder, "read a.png -n sphere -o d.csv --light-out beside.csv", &[what]);
}

#[test]
fn a_table_without_gloss_takes_no_sources() {
    let folder = Folder::new();
    let matte = "\n[effects]\nuse = [\"ambient\", \"diffuse\"]\n";
    folder.write("matte.toml", folder.read("scene.toml") + matte);
    folder.ok("basis --scene matte.toml --out matte.bin");
    for command in ["render -o a.png", "shader --lang glsl --json"] {
        let command = format!("{command} -t matte.bin -l lobby -m brass --sources 4");
        assert_fails(&folder, &command, &["has no gloss"]);
    }
}

/// As docs/commands.md says of a matte.
#[test]
fn integers_of_a_matte_end_at_its_orders() {
    let folder = Folder::new();
    let packed = "pack -t matte.bin -f q15 -o matte.esw";
    for (order, effects, fits) in [(3, "", false), (0, "", true), (3, ", \"broad\"", true)] {
        let scene = folder.read("scene.toml").replace("order = 3", &format!("order = {order}"));
        let effects = format!("[effects]\nuse = [\"ambient\", \"diffuse\"{effects}]\n");
        folder.write("matte.toml", format!("{scene}\n{effects}"));
        folder.ok("basis --scene matte.toml --out matte.bin");
        if fits {
            folder.ok(packed);
        } else {
            assert_fails(&folder, packed, &["ambient"]);
        }
    }
}

/// Integers that a table does not have are refused before anything is written.
#[test]
fn a_table_without_integers_writes_nothing() {
    let folder = Folder::new();
    let command = "shade -l lobby -m brass -n normals.csv -f q15";
    assert_fails(&folder, command, &["color", "--table sphere"]);
    assert_eq!(folder.run(command).stdout, b"");
    for options in ["--components 64", "--table sphere"] {
        assert!(folder.ok(&format!("{command} {options}")).lines().count() > 1);
    }
}

#[test]
fn the_printed_module_names_the_file() {
    let folder = Folder::new();
    let printed = folder.ok("pack-normals sphere --size 8 -o my-map.rs");
    assert!(printed.contains("#[path = \"my-map.rs\"] mod normal_map;"), "{printed}");
    let printed = folder.ok("pack-normals sphere --size 8 -o 1.rs");
    assert!(printed.contains("#[path = \"1.rs\"] mod normal_map;"), "{printed}");
    assert!(folder.ok("pack-normals sphere --size 8 -o map.rs").contains(" mod map;"));
}

#[test]
fn negative_numbers_are_values() {
    let folder = Folder::new();
    for command in ["light lights.csv --degree -1", "material ggx --f0 -1 --roughness 0.5"] {
        let output = folder.run(command);
        let text = stderr(&output);
        assert!(text.contains("-1") && !text.contains("unexpected argument"), "{text}");
        assert!(!output.status.success());
    }
}

/// Shipped materials cannot be made again, since their measurements are not shipped.
#[test]
fn shipped_materials_of_a_higher_order_need_another_table() {
    let folder = Folder::with_table();
    let said = |material: &str| {
        folder.messages(&format!("project --table b.bin --light lobby --material {material}"))
    };
    let line = "warning: chrome: its materials have order 7, the table order 3: higher \
                coefficients are ignored, and the rest are not the projection to order 3; use a \
                table of order 7\n";
    assert_contains(&said("chrome"), &[line]);
    folder.write("high.csv", materials(ORDER + 2, 1));
    let made = "order 3 unless made with --measure solid-angle; create";
    assert_contains(&said("high.csv"), &[made]);
}
