//! Effects: their pictures sum to the whole, tables of some of them show just those, and what
//! is left out is in no table.

use crate::support::{self, Folder, assert_fails, materials, numbers, rows, scene};
use crate::tolerances;
use eigenshade_index::effect::{Effect, Effects};
use eigenshade_index::{light, material, mode};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_table::parts::Parts;
use eigenshade_table::{Table, decode};
use std::fs;

/// Pictures of effects, summed, against the picture of all, of the peak: rounding. docs/method.md
/// promises 1e-12.
const SUM_OF_EFFECTS: f64 = 9e-15;

/// An object's table of some effects against the direct sum over their modes, of the peak: the
/// rank's cut-off of 1e-10, amplified as far as six normals see the modes.
const OBJECT_OF_EFFECTS: f64 = 1e-10;

/// Tables of some effects in integers against f64, of the peak: seen 2e-7 and 6e-4.
const EFFECTS_Q31: f64 = 6e-7;

/// See [`EFFECTS_Q31`].
const EFFECTS_Q15: f64 = 2e-3;

const PAIR: &str = "--lights lights.csv --materials materials.csv --normals normals.csv";
const HEADER: &str = "light,material,normal,r,g,b";

/// Degree 4 and order 6: every effect has modes, ambient some of each order.
fn folder(criterion: &str) -> Folder {
    let folder = Folder::new();
    folder.write("lights.csv", support::lights(4, 2));
    folder.write("materials.csv", materials(6, 40));
    let scene = scene(criterion, 10_000, "[]").replace("order = 3", "order = 6");
    folder.write("scene.toml", scene);
    folder
}

fn names(effects: Effects) -> Vec<&'static str> {
    Effect::ALL.iter().filter(|one| effects.has(**one)).map(|one| one.name()).collect()
}

fn every() -> impl Iterator<Item = Effects> {
    (1..16).filter_map(Effects::from_bits)
}

/// Makes `out` of these effects.
fn make(folder: &Folder, effects: Effects, out: &str) -> Table {
    let text = fs::read_to_string(folder.path("scene.toml")).unwrap();
    let of = format!("{text}\n[effects]\nuse = {:?}\n", names(effects));
    folder.write("effects.toml", of);
    folder.ok(&format!("basis --scene effects.toml --out {out}"));
    folder.ok(&format!("basis --scene effects.toml --check {out}"));
    decode(&fs::read(folder.path(out)).unwrap()).unwrap()
}

fn shaded(folder: &Folder, table: &str, options: &str) -> Vec<f64> {
    numbers(&rows(&folder.ok(&format!("shade {table} {PAIR} {options}")), HEADER), 3)
}

fn difference(a: &[f64], b: &[f64]) -> f64 {
    assert_eq!(a.len(), b.len());
    let peak = b.iter().fold(0.0f64, |most, value| most.max(value.abs()));
    a.iter().zip(b).fold(0.0f64, |most, (a, b)| most.max((a - b).abs())) / peak
}

/// Of the table of all: in every way to a pixel, whatever the components.
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
            let whole = shaded(&folder, "b.bin", options);
            let mut sum = vec![0.0; whole.len()];
            for effect in Effect::ALL {
                let of = format!("{options} --effects {}", effect.name());
                let picture = shaded(&folder, "b.bin", &of);
                assert!(picture.iter().any(|value| *value != 0.0), "{of}");
                sum.iter_mut().zip(picture).for_each(|(sum, value)| *sum += value);
            }
            let found = difference(&sum, &whole);
            println!("{criterion} {options}: {found:.1e}");
            assert!(found <= SUM_OF_EFFECTS, "{criterion} {options}: {found}");
        }
    }
}

/// Of each of the fifteen sets: its table with all components, and the whole table asked for
/// them, against the direct sum over their modes.
#[test]
fn some_effects_are_the_direct_sum_over_their_modes() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion);
        make(&folder, Effects::ALL, "all.bin");
        for effects in every() {
            make(&folder, effects, "some.bin");
            let asked = format!("--effects {}", names(effects).join(","));
            let truth = shaded(&folder, "all.bin", &format!("--method modes {asked}"));
            for (table, options, tolerance) in [
                ("some.bin", "--method modes".to_owned(), SUM_OF_EFFECTS),
                ("some.bin", "--format f64".into(), tolerances::ALL_COMPONENTS),
                ("some.bin", "--format f64 --method eigen".into(), tolerances::ALL_COMPONENTS),
                ("some.bin", "--format f32".into(), tolerances::ALL_COMPONENTS_F32),
                ("all.bin", format!("--format f64 {asked}"), tolerances::ALL_COMPONENTS),
                ("all.bin", format!("--format f32 {asked}"), tolerances::ALL_COMPONENTS_F32),
            ] {
                let found = difference(&shaded(&folder, table, &options), &truth);
                println!("{criterion} {:?} {table} {options}: {found:.1e}", names(effects));
                assert!(found <= tolerance, "{:?} {table} {options}: {found}", names(effects));
            }
        }
    }
}

/// Of a table that takes fewer modes than there are, and of an object that is no sphere.
#[test]
fn selections_and_objects_have_effects() {
    let folder = folder("standard");
    let sphere = fs::read_to_string(folder.path("scene.toml")).unwrap();
    folder.write("object.csv", "x,y,z\n0,0,1\n0.6,0,0.8\n0,0.6,0.8\n-0.6,0.48,0.64\n0.3,-0.4,0.8660254037844386\n-0.1,-0.7,0.7071067811865476\n");
    for effects in every() {
        let wanted = format!("--effects {}", names(effects).join(","));
        folder.write("scene.toml", sphere.replace("sphere", "object.csv"));
        make(&folder, effects, "object.bin");
        folder.write("scene.toml", &sphere);
        make(&folder, effects, "sphere.bin");
        let normals = "--lights lights.csv --materials materials.csv --normals object.csv";
        let of = |table: &str, options: &str| {
            let text = folder.ok(&format!("shade {table} {normals} {options}"));
            numbers(&rows(&text, HEADER), 3)
        };
        let truth = of("sphere.bin", &format!("--method modes {wanted}"));
        let found = difference(&of("object.bin", "--format f64"), &truth);
        assert!(found <= OBJECT_OF_EFFECTS, "{:?}: {found}", names(effects));
        // Few modes: d of a coefficient is the sum over those that are kept, of these effects.
        folder.write(
            "scene.toml",
            sphere.replace("profile_tolerance", "modes = 60\nprofile_tolerance"),
        );
        let table = make(&folder, effects, "few.bin");
        assert_projects_kept_modes(&table, effects);
        assert!(table.count() > 0);
    }
    folder.write("scene.toml", sphere);
}

/// Each coefficient of the material by itself under one light: `project` against the sum of
/// the rows of UᵀM, made here from the table's nodes, over the modes that are in.
fn assert_projects_kept_modes(table: &Table, effects: Effects) {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let owned = OwnedBasis::<f64>::new(table);
    let mut shader = Shader::new(owned.any().unwrap(), usize::MAX);
    let light: Vec<f64> = (0..light::count(degree)).map(|k| 1.0 / (1.0 + k as f64)).collect();
    let dark = shader
        .project((degree, &vec![0.0; light.len()]), (order, &vec![0.0; material::count(order)]));
    let dark = dark.unwrap().to_vec();
    for (j, coefficient) in material::indices(order).enumerate() {
        let mut one = vec![0.0; material::count(order)];
        one[j] = 1.0;
        let found = shader.project((degree, &light), (order, &one)).unwrap().to_vec();
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

/// Rows, columns, azimuths and degrees of what is left out are in no table. Gloss takes the
/// columns of all orders: its coefficients (o, p, q) couple o >= 4 with every p.
#[test]
fn what_is_left_out_costs_nothing() {
    let folder = folder("image-centered");
    let whole = make(&folder, Effects::ALL, "b.bin");
    let is_without_gloss = |effects: &Effects| !effects.has(Effect::Gloss);
    let size = |table: &Table| {
        let parts = Parts::new(table);
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
    for effects in every().filter(is_without_gloss) {
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
    assert_eq!((ambient.gram.degree, Parts::new(&ambient).lengths.len()), (0, 1));
    assert!(ambient.components.iter().all(|component| component.order == 0));
    // Diffuse alone is what a Lambertian table is.
    let diffuse = make(&folder, Effects::NONE.with(Effect::Diffuse), "diffuse.bin");
    assert_eq!((diffuse.gram.order, Parts::new(&diffuse).couplings.len()), (0, 1));
}

#[test]
fn the_wire_carries_effects() {
    let folder = folder("image-centered");
    for effects in every() {
        let table = make(&folder, effects, "some.bin");
        folder.ok("pack some.bin --out some.esw --format f32");
        let text = folder.ok("info some.esw");
        let line = format!("{:<24} {}", "effects", names(effects).join(" "));
        assert!(text.contains(&line), "{text}");
        let apart = effects.unfactored_count(table.gram.order) > 0;
        let pack = "pack some.bin --out some15.esw --format q15";
        if apart {
            assert_fails(&folder, pack, &["ambient", "gloss"]);
            continue;
        }
        folder.ok(pack);
        let double = shaded(&folder, "some.bin", "--format f64");
        for (format, tolerance) in [("q31", EFFECTS_Q31), ("q15", EFFECTS_Q15)] {
            let integers = shaded(&folder, "some.bin", &format!("--format {format}"));
            let found = difference(&integers, &double);
            println!("{:?} {format}: {found:.1e}", names(effects));
            assert!(found <= tolerance, "{:?} {format}: {found}", names(effects));
        }
    }
}

#[test]
fn what_a_scene_does_not_call_for_is_refused() {
    let folder = folder("image-centered");
    make(&folder, Effects::NONE.with(Effect::Ambient).with(Effect::Diffuse), "some.bin");
    let shade = |options: &str| format!("shade some.bin {PAIR} {options}");
    assert_fails(&folder, &shade("--effects gloss"), &["no gloss", "ambient diffuse"]);
    assert_fails(&folder, &shade("--effects diffuse --format q15"), &["integers"]);
    let text = fs::read_to_string(folder.path("effects.toml")).unwrap();
    folder.write("none.toml", text.replace("[\"ambient\", \"diffuse\"]", "[]"));
    assert_fails(&folder, "basis --scene none.toml --out n.bin", &["effects.use", "all"]);
    folder.write("still.toml", text + "rotation = false\n");
    folder.ok("basis --scene still.toml --out still.bin");
    let turned = format!("shade still.bin {PAIR} --rotate 1,2,3");
    assert_fails(&folder, &turned, &["does not turn", "--rotate"]);
}

/// Without color a picture is that of the luminance of light and material, also of a table
/// that keeps its materials folded in.
#[test]
fn without_color_there_is_luminance() {
    let folder = folder("image-centered");
    let colored: String = materials(6, 40)
        .lines()
        .map(|line| match line.rsplit_once(',') {
            Some((places, "value")) => format!("{places},r,g,b\n"),
            Some((places, value)) => {
                let value: f64 = value.parse().unwrap();
                format!("{places},{value},{},{}\n", 0.5 * value, 0.25 * value)
            }
            None => panic!("a row"),
        })
        .collect();
    folder.write("colored.csv", colored);
    let scene = fs::read_to_string(folder.path("scene.toml")).unwrap();
    let scene = scene.replace("materials.csv", "colored.csv");
    let luminance = 0.2126 + 0.7152 * 0.5 + 0.0722 * 0.25;
    for store in ["projection", "materials"] {
        let text = format!("{scene}store = \"{store}\"\n[effects]\ncolor = false\n");
        folder.write("grey.toml", text);
        folder.ok("basis --scene grey.toml --out grey.bin");
        assert!(folder.ok("info grey.bin").contains("no color"));
        let of = |table: &str, materials: &str| {
            let pair = PAIR.replace("materials.csv", materials);
            let text = folder.ok(&format!("shade {table} {pair} --format f64"));
            numbers(&rows(&text, HEADER), 3)
        };
        let found = of("grey.bin", "colored.csv");
        make(&folder, Effects::ALL, "whole.bin");
        // On a material without color a picture has the light's.
        let pictures = of("whole.bin", "materials.csv");
        let of_light = |rgb: &[f64]| 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2];
        let expected: Vec<f64> =
            pictures.chunks(3).flat_map(|rgb| [luminance * of_light(rgb); 3]).collect();
        let off = difference(&found, &expected);
        assert!(off <= tolerances::ALL_COMPONENTS, "{store}: {off}");
    }
}
