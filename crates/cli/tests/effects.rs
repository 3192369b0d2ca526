//! Effects: their pictures sum to the whole, tables of some effects give just those, and effects
//! that are left out are in no table.

use crate::support::{Folder, PAIR, assert_fails, assert_near, colored, lights, materials, scene};
use crate::tolerances;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_table::effect::{Effect, Effects};
use eigenshade_table::{Table, light, material, mode, parts};

/// The sum of pictures of effects against the picture of all, relative to the peak: rounding.
const SUM_OF_EFFECTS: f64 = 9e-15;

/// An object's table of some effects against the direct sum over their modes, relative to the peak:
/// the rank cutoff of 1e-10, amplified by how weakly six normals determine the modes.
const OBJECT_OF_EFFECTS: f64 = 1e-10;

/// Tables of some effects in integers against f64, relative to the peak: measured 6e-4.
const EFFECTS_Q15: f64 = 2e-3;

/// A folder of degree 4 and order 6, where every effect has modes, and ambient modes of each order.
/// The scene's database, `database.csv`, begins with the materials that are shaded,
/// `materials.csv`.
fn folder(criterion: &str) -> Folder {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 2));
    folder.write("database.csv", materials(6, 40));
    folder.write("materials.csv", materials(6, 8));
    let scene = scene(criterion, 10_000, "[]").replace("order = 3", "order = 6");
    folder.write("scene.toml", scene.replace("materials.csv", "database.csv"));
    folder
}

fn names(effects: Effects) -> Vec<&'static str> {
    Effect::ALL.iter().filter(|one| effects.has(**one)).map(|one| one.name()).collect()
}

fn every() -> impl Iterator<Item = Effects> {
    (1..16).filter_map(Effects::from_bits)
}

/// Makes the table `out` of these effects.
fn make(folder: &Folder, effects: Effects, out: &str) -> Table {
    let of = format!("\n[effects]\nuse = {:?}\n", names(effects));
    folder.write("effects.toml", folder.read("scene.toml") + &of);
    folder.ok(&format!("basis --scene effects.toml --out {out}"));
    folder.table(out)
}

/// The table of all effects, by every method and with any number of components.
#[test]
fn the_pictures_of_effects_sum_to_the_whole() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion);
        make(&folder, Effects::ALL, "b.bin");
        for options in [
            "--method modes",
            "--method eigen --format f64",
            "--method polynomial --format f64",
            "--method polynomial --format f64 --components 7",
            "--method eigen --format f64 --components 2",
        ] {
            let whole = folder.shaded(options);
            let mut sum = vec![0.0; whole.len()];
            for effect in Effect::ALL {
                let of = format!("{options} --effects {}", effect.name());
                let picture = folder.shaded(&of);
                assert!(picture.iter().any(|value| *value != 0.0), "{of}");
                sum.iter_mut().zip(picture).for_each(|(sum, value)| *sum += value);
            }
            assert_near(&format!("{criterion} {options}"), &sum, &whole, SUM_OF_EFFECTS);
        }
    }
}

/// The table of each of the fifteen sets with all components, and the table of all effects with the
/// option --effects, against the direct sum over their modes.
#[test]
fn some_effects_are_the_direct_sum_over_their_modes() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion);
        make(&folder, Effects::ALL, "all.bin");
        for effects in every() {
            make(&folder, effects, "some.bin");
            folder.ok("basis --scene effects.toml --check some.bin");
            let options = format!("--effects {}", names(effects).join(","));
            let reference = folder.shaded_by("all.bin", &format!("--method modes {options}"));
            for (table, options, tolerance) in [
                ("some.bin", "--method modes".to_owned(), SUM_OF_EFFECTS),
                ("some.bin", "--format f64".into(), tolerances::ALL_COMPONENTS),
                ("some.bin", "--format f64 --method eigen".into(), tolerances::ALL_COMPONENTS),
                ("some.bin", "--format f32".into(), tolerances::ALL_COMPONENTS_F32),
                ("some.bin", "--format f32 --method eigen".into(), tolerances::ALL_COMPONENTS_F32),
                ("all.bin", format!("--format f64 {options}"), tolerances::ALL_COMPONENTS),
                ("all.bin", format!("--format f32 {options}"), tolerances::ALL_COMPONENTS_F32),
            ] {
                let what = format!("{criterion} {:?} {table} {options}", names(effects));
                assert_near(&what, &folder.shaded_by(table, &options), &reference, tolerance);
            }
        }
    }
}

/// A table with a selection of modes, and an object that is not a sphere.
#[test]
fn selections_and_objects_have_effects() {
    let folder = folder("standard");
    let sphere = folder.read("scene.toml");
    folder.write(
        "object.csv",
        "x,y,z\n0,0,1\n0.6,0,0.8\n0,0.6,0.8\n-0.6,0.48,0.64\n0.3,-0.4,0.8660254037844386\n\
         -0.1,-0.7,0.7071067811865476\n",
    );
    for effects in every() {
        let options = format!("--effects {}", names(effects).join(","));
        folder.write("scene.toml", sphere.replace("sphere", "object.csv"));
        make(&folder, effects, "object.bin");
        folder.ok("basis --scene effects.toml --check object.bin");
        folder.write("scene.toml", &sphere);
        make(&folder, effects, "sphere.bin");
        let of = |table: &str, options: &str| {
            folder.irradiance(&format!("--table {table} {PAIR} --normals object.csv {options}"))
        };
        let reference = of("sphere.bin", &format!("--method modes {options}"));
        assert_near(&options, &of("object.bin", "--format f64"), &reference, OBJECT_OF_EFFECTS);
        // Few modes: d of a coefficient is the sum over those that are kept, of these effects.
        folder.replace("scene.toml", "profile_tolerance", "modes = 60\nprofile_tolerance");
        let table = make(&folder, effects, "few.bin");
        folder.ok("basis --scene effects.toml --check few.bin");
        assert_projects_kept_modes(&table, effects);
        assert!(table.count() > 0);
    }
}

/// Asserts for each single coefficient of the material under one light: `project` gives the sum,
/// over the modes that are kept, of the rows of UᵀM that the table's nodes give.
fn assert_projects_kept_modes(table: &Table, effects: Effects) {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let evaluator = Evaluator::new(table);
    let light: Vec<f64> = (0..light::count(degree)).map(|k| 1.0 / (1.0 + k as f64)).collect();
    let dark = evaluator.project(&[], &[]).unwrap();
    for (j, coefficient) in material::indices(order).enumerate() {
        let mut one = vec![0.0; material::count(order)];
        one[j] = 1.0;
        let found = evaluator.project(&light, &one).unwrap();
        for (k, component) in table.components.iter().enumerate() {
            let profile = &table.profiles[component.profile];
            let m = component.order as isize;
            let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
            let modes = mode::indices(degree, order, profile.azimuth);
            let mut sum = 0.0;
            for ((l, o, p, q), column) in modes.zip(table.gram.columns(profile.azimuth)) {
                let place = table.gram.place(profile.azimuth, l, o, p, q);
                let kept = table.selection.is_empty() || table.selection[place];
                if (o, p, q) == coefficient && kept && effects.keeps(l, o) {
                    let row: f64 =
                        column.iter().zip(&profile.node_values).map(|(a, w)| a * w).sum();
                    sum += sign * row * light[light::position(l, m)];
                }
            }
            let off = (found[k] - dark[k] - sum).abs();
            assert!(off <= tolerances::ORTHONORMAL_NODES, "{effects:?} {coefficient:?} {k}: {off}");
        }
    }
}

/// Tables have no rows, columns, azimuths and degrees of effects that are left out. Gloss uses the
/// columns of all orders, because its coefficients (o, p, q) couple o >= 4 with every p.
#[test]
fn what_is_left_out_costs_nothing() {
    let folder = folder("image-centered");
    let whole = make(&folder, Effects::ALL, "b.bin");
    let size = |table: &Table| {
        let parts = parts::floats(table);
        let transfer: usize = parts.passes.iter().map(|pass| usize::from(pass.profiles)).sum();
        let terms: usize = parts.lengths.iter().map(|&length| usize::from(length)).sum();
        [
            parts.components,
            parts.polar.len(),
            parts.factors.len() + parts.ambient.len(),
            parts.couplings.len(),
            parts.terms.len(),
            transfer,
            terms,
        ]
    };
    let all = size(&whole);
    for effects in every().filter(|effects| !effects.has(Effect::Gloss)) {
        let table = make(&folder, effects, "some.bin");
        let some = size(&table);
        println!("{:?}: {some:?} of {all:?}", names(effects));
        for (some, all) in some.iter().zip(&all) {
            assert!(some <= all, "{:?}: {some} of {all}", names(effects));
        }
        assert!(some[..4].iter().zip(&all).all(|(some, all)| some < all), "{:?}", names(effects));
    }
    // Ambient alone: no azimuth but m = 0, no degree but l = 0.
    let ambient = make(&folder, Effects::NONE.with(Effect::Ambient), "ambient.bin");
    assert_eq!((ambient.gram.degree, parts::floats(&ambient).lengths.len()), (0, 1));
    assert!(ambient.components.iter().all(|component| component.order == 0));
    // Diffuse alone is what a Lambertian table is.
    let diffuse = make(&folder, Effects::NONE.with(Effect::Diffuse), "diffuse.bin");
    assert_eq!((diffuse.gram.order, parts::floats(&diffuse).couplings.len()), (0, 1));
}

#[test]
fn wire_files_have_effects() {
    let folder = folder("image-centered");
    for effects in every() {
        let table = make(&folder, effects, "some.bin");
        folder.ok("pack --table some.bin --out some.esw --format f32");
        let text = folder.ok("info --table some.esw");
        let line = format!("{:<24} {}", "effects", names(effects).join(" "));
        assert!(text.contains(&line), "{text}");
        let pack = "pack --table some.bin --out some15.esw --format q15";
        if effects.unfactored_count(table.gram.order) > 0 {
            assert_fails(&folder, pack, &["ambient", "gloss"]);
            continue;
        }
        folder.ok(pack);
        let double = folder.shaded_by("some.bin", "--format f64");
        let integers = folder.shaded_by("some.bin", "--format q15");
        assert_near(&format!("{:?}", names(effects)), &integers, &double, EFFECTS_Q15);
    }
}

#[test]
fn what_a_scene_leaves_out_is_refused() {
    let folder = folder("image-centered");
    make(&folder, Effects::NONE.with(Effect::Ambient).with(Effect::Diffuse), "some.bin");
    let shade =
        |options: &str| format!("shade --table some.bin {PAIR} --normals normals.csv {options}");
    assert_fails(&folder, &shade("--effects gloss"), &["no gloss", "ambient diffuse"]);
    assert_fails(&folder, &shade("--effects diffuse --format q15"), &["q15 shades all effects"]);
    let text = folder.read("effects.toml");
    folder.write("none.toml", text.replace("[\"ambient\", \"diffuse\"]", "[]"));
    assert_fails(&folder, "basis --scene none.toml --out n.bin", &["effects.use", "all"]);
    folder.write("still.toml", text + "rotation = false\n");
    folder.ok("basis --scene still.toml --out still.bin");
    let rotated = format!("shade --table still.bin {PAIR} --normals normals.csv --rotate 1,2,3");
    assert_fails(&folder, &rotated, &["fixed light", "--rotate"]);
}

/// Without color a picture is that of the luminance of light and material, also with a table that
/// stores the transfers of its materials.
#[test]
fn without_color_there_is_luminance() {
    let folder = folder("image-centered");
    folder.write("colored.csv", colored(&materials(6, 40), [0.5, 0.25]));
    let scene = folder.read("scene.toml").replace("database.csv", "colored.csv");
    let luminance = 0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25;
    for store in ["projection", "materials"] {
        let text = format!("{scene}store = \"{store}\"\n[effects]\ncolor = false\n");
        folder.write("gray.toml", text);
        folder.ok("basis --scene gray.toml --out gray.bin");
        assert!(folder.ok("info --table gray.bin").contains("no color"));
        let of = |table: &str, materials: &str| {
            let pair = PAIR.replace("materials.csv", materials);
            let rest = "--normals normals.csv --format f64";
            folder.irradiance(&format!("--table {table} {pair} {rest}"))
        };
        let found = of("gray.bin", "colored.csv");
        make(&folder, Effects::ALL, "whole.bin");
        // The picture of a material without color has the color of the light.
        let pictures = of("whole.bin", "database.csv");
        let of_light = |rgb: &[f64]| 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        let expected: Vec<f64> =
            pictures.chunks(3).flat_map(|rgb| [luminance * of_light(rgb); 3]).collect();
        assert_near(store, &found, &expected, tolerances::ALL_COMPONENTS);
    }
}
