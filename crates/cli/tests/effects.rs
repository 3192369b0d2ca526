//! Effects: their pictures sum to the whole in every format, and bound the degree and the order of
//! a table.

use crate::support::{Folder, PAIR, assert_fails, assert_near, colored, lights, materials, scene};
use crate::tolerances;
use eigenshade_model::evaluation::Evaluator;
use eigenshade_table::effect::{Effect, Effects};
use eigenshade_table::{Table, light, material, mode, parts};

/// The sum of pictures of effects against the picture of all, relative to the peak: rounding.
const SUM_OF_EFFECTS: f64 = 9e-15;

/// Effects in integers against f64, relative to the peak.
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

/// Each of the fifteen sets, by the table of all effects and by the table of that set, in every format
/// against the direct sum over those of its modes that the table has. Ambient light beside directional
/// light has the orders of the latter.
#[test]
fn some_effects_are_the_direct_sum_over_their_modes() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion);
        make(&folder, Effects::ALL, "all.bin");
        for effects in every() {
            make(&folder, effects, "some.bin");
            folder.ok("basis --scene effects.toml --check some.bin");
            let names = names(effects).join(",");
            let shaded = |table: &str, options: &str| {
                folder.shaded_by(table, &format!("{options} --effects {names}"))
            };
            let references = ["some.bin", "all.bin"].map(|table| shaded(table, "--method modes"));
            let order = folder.table("some.bin").gram.order;
            if !effects.has(Effect::Ambient) || !effects.is_directional() || order == 6 {
                let [some, all] = &references;
                assert_near(&names, some, all, SUM_OF_EFFECTS);
            }
            for (options, tolerance) in [
                ("--format f64", tolerances::ALL_COMPONENTS),
                ("--format f64 --method eigen", tolerances::ALL_COMPONENTS),
                ("--format f32", tolerances::ALL_COMPONENTS_F32),
                ("--format f32 --method eigen", tolerances::ALL_COMPONENTS_F32),
                ("--format q15", EFFECTS_Q15),
            ] {
                if criterion == "standard" && !options.contains("f64") {
                    continue;
                }
                for (table, reference) in ["some.bin", "all.bin"].iter().zip(&references) {
                    let what = format!("{criterion} {names} {table} {options}");
                    assert_near(&what, &shaded(table, options), reference, tolerance);
                }
            }
        }
    }
}

/// A table with a selection of modes.
#[test]
fn selections_have_effects() {
    let folder = folder("standard");
    // Few modes: d of a coefficient is the sum over those that are kept, of these effects.
    folder.replace("scene.toml", "profile_tolerance", "modes = 60\nprofile_tolerance");
    let table = make(&folder, Effects::ALL, "few.bin");
    folder.ok("basis --scene effects.toml --check few.bin");
    assert!(table.count() > 0);
    for effects in every() {
        assert_projects_kept_modes(&table, effects);
    }
}

/// Asserts for each single coefficient of the material under one light: `project` gives the sum,
/// over the modes that are kept, of the rows of UᵀM that the table's nodes give.
fn assert_projects_kept_modes(table: &Table, effects: Effects) {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let evaluator = Evaluator::new(table).with_effects(effects).unwrap();
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

/// Effects bound a table: the degree is that of its light, the order the highest that one of them
/// has.
#[test]
fn effects_bound_the_degree_and_the_order() {
    let folder = folder("image-centered");
    for (names, degree, order) in [
        ("ambient", 0, 6),
        ("diffuse", 4, 0),
        ("broad", 4, 3),
        ("gloss", 4, 6),
        ("diffuse,broad", 4, 3),
        ("ambient,diffuse", 4, 0),
        ("ambient,broad", 4, 3),
        ("ambient,gloss", 4, 6),
    ] {
        let of = |name: &&Effect| names.split(',').any(|one| one == name.name());
        let table = make(&folder, Effect::ALL.iter().filter(of).copied().collect(), "some.bin");
        assert_eq!((table.gram.degree, table.gram.order), (degree, order), "{names}");
        let parts = parts::floats(&table);
        assert_eq!(parts.lengths.len(), degree + 1);
        assert!(table.components.iter().all(|one| one.order.unsigned_abs() as usize <= degree));
    }
}

#[test]
fn what_a_scene_leaves_out_is_refused() {
    let folder = folder("image-centered");
    make(&folder, Effects::NONE.with(Effect::Ambient).with(Effect::Diffuse), "some.bin");
    let shade =
        |options: &str| format!("shade --table some.bin {PAIR} --normals normals.csv {options}");
    assert_fails(&folder, &shade("--effects gloss"), &["no gloss", "ambient diffuse"]);
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
