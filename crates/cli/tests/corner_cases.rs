//! Tables of every kind that a scene can request, against the direct sum and dense products, and hard
//! cases: objects of few normals, black lights and materials, and coefficients out of range.
//! `experiments stability` measures more of them.

use crate::support::{
    Folder, PAIR, SHADED, assert_fails, difference, lights, materials, numbers, repository, rows,
    scene,
};
use crate::tolerances;
use eigenshade_generator::basis::build;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_index::{light, mode};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use eigenshade_testing::largest;
use std::fmt::Write;
use std::fs;

/// As [`tolerances::ALL_COMPONENTS_F32`], at degree 16 and order 12: the powers of 2z - 1 cancel,
/// by up to 1e5 in the weakest profiles.
const ALL_COMPONENTS_F32_HIGH: f64 = 6e-6;

/// The largest error of both methods, in f64 and in f32, relative to the direct sum's peak.
fn errors(folder: &Folder, pair: &str) -> [f64; 2] {
    let shaded = |options: &str| {
        let text =
            folder.ok(&format!("shade --table b.bin {pair} --normals normals.csv {options}"));
        numbers(&rows(&text, SHADED), 3)
    };
    let reference = shaded("--method modes");
    ["f64", "f32"].map(|format| {
        let of_method = |method: &str| {
            difference(&shaded(&format!("--method {method} --format {format}")), &reference)
        };
        largest([of_method("polynomial"), of_method("eigen")])
    })
}

fn assert_near(what: &str, errors: [f64; 2]) {
    assert_within(what, errors, tolerances::ALL_COMPONENTS_F32);
}

fn assert_within(what: &str, [double, single]: [f64; 2], in_f32: f64) {
    println!("{what}: {double:.1e}, f32 {single:.1e}");
    assert!(double <= tolerances::ALL_COMPONENTS, "{what}: {double}");
    assert!(single <= in_f32, "{what}, f32: {single}");
}

/// The scene of the small folder with other degrees.
fn scene_of(criterion: &str, degree: usize, order: usize) -> String {
    scene(criterion, 10_000, "[]")
        .replace("degree = 4", &format!("degree = {degree}"))
        .replace("order = 3", &format!("order = {order}"))
}

#[test]
fn any_degree_and_order_works() {
    for criterion in ["image-centered", "standard"] {
        for (degree, order) in [(0, 0), (0, 3), (4, 0), (4, 3), (2, 5), (7, 1)] {
            let folder = Folder::new();
            folder.write("lights.csv", lights(degree, 3));
            folder.write("materials.csv", materials(order, 4));
            folder.write("scene.toml", scene_of(criterion, degree, order));
            folder.ok("basis --scene scene.toml --out b.bin");
            folder.ok("basis --scene scene.toml --check b.bin");
            assert_near(&format!("{criterion} {degree} {order}"), errors(&folder, PAIR));
        }
    }
}

/// One material and one light; light without directions; and no variance at all, where rounding
/// errors must not become components.
#[test]
fn the_smallest_databases_work() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(4, 1));
    folder.write("materials.csv", materials(3, 1));
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_near("one of each", errors(&folder, PAIR));

    let uniform: String = lights(4, 2)
        .lines()
        .map(|line| match line.split(',').collect::<Vec<_>>()[..] {
            [name, l, m, ..] if l != "0" && l != "l" => format!("{name},{l},{m},0,0,0\n"),
            _ => format!("{line}\n"),
        })
        .collect();
    folder.write("lights.csv", uniform);
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_eq!(folder.table("b.bin").components.len(), 2);
    assert_near("uniform light", errors(&folder, PAIR));

    folder.write("lights.csv", lights(0, 3));
    folder.write("materials.csv", materials(0, 4));
    folder.write("scene.toml", scene_of("image-centered", 0, 0));
    folder.ok("basis --scene scene.toml --out b.bin");
    assert_eq!(folder.table("b.bin").components.len(), 1, "a constant image is the constant");
    assert_near("constant images", errors(&folder, PAIR));
    folder.write("materials.csv", materials(0, 1));
    folder.write("scene.toml", scene_of("standard", 0, 0));
    folder.ok("basis --scene scene.toml --out b.bin");
    let table = folder.table("b.bin");
    assert_eq!((table.components.len(), table.spectrum.len()), (0, 0), "all is the mean");
    folder.shaded("");
    folder.ok("info --table b.bin");
}

/// Three of the shipped lights, to degree 16.
fn shipped_lights(degree: usize) -> String {
    let text = fs::read_to_string(repository().join("tables/inputs/lights.csv")).unwrap();
    let is_chosen = |line: &&str| {
        let fields: Vec<&str> = line.split(',').collect();
        fields[0] == "name"
            || ["park", "studio", "blender-courtyard"].contains(&fields[0])
                && fields[1].parse::<usize>().is_ok_and(|l| l <= degree)
    };
    text.lines().filter(is_chosen).map(|line| format!("{line}\n")).collect()
}

#[test]
fn degree_16_and_order_12_work() {
    let folder = Folder::new();
    folder.write("lights.csv", shipped_lights(16));
    folder.write("materials.csv", materials(12, 30));
    folder.write("scene.toml", scene_of("image-centered", 16, 12));
    folder.ok("basis --scene scene.toml --out b.bin");
    folder.write("materials.csv", materials(12, 3));
    let near = |what: &str, pair: &str| {
        assert_within(what, errors(&folder, pair), ALL_COMPONENTS_F32_HIGH);
    };
    near("degree 16, order 12", PAIR);

    // Lower degrees and orders than the table's are used as they are. Higher ones are refused by
    // the runtime, and dropped by the program.
    let low = PAIR.replace("lights.csv", "low.csv").replace("materials.csv", "seven.csv");
    folder.write("low.csv", shipped_lights(5));
    folder.write("seven.csv", materials(7, 2));
    near("degree 5, order 7", &low);
    folder.write("high.csv", materials(13, 2));
    near("order 13 of 12", &PAIR.replace("materials.csv", "high.csv"));
    let table = folder.table("b.bin");
    let owned = OwnedBasis::<f32>::new(&table);
    let mut shader = Shader::new(owned.basis().unwrap(), 1);
    let mut refused = |degree: usize, order: usize| {
        let light = vec![0.0; light::count(degree)];
        let material = vec![0.0; eigenshade_index::material::count(order)];
        shader.project((degree, &light), (order, &material)).unwrap_err().to_string()
    };
    assert!(refused(17, 12).contains("17") && refused(16, 13).contains("13"));

    // A table needs databases of its own degree and order.
    folder.write("materials.csv", materials(7, 2));
    assert_fails(&folder, "basis --scene scene.toml --out new.bin", &["materials.csv", "order 7"]);
}

/// The shipped scene with other settings and some of its inputs.
fn shipped(criterion: Criterion) -> Loaded {
    let mut loaded = scene_file::load(repository().join("tables/curet.toml")).unwrap();
    loaded.lights.entries.truncate(5);
    loaded.materials.entries.truncate(20);
    loaded.scene.basis.criterion = criterion;
    loaded
}

/// With a selection of modes and without: d is the dense product of the rows of UᵀM with c, and the
/// rows are WᵀA on the modes that are kept and zero on others.
#[test]
fn projections_are_dense_products() {
    for criterion in [Criterion::ImageCentered, Criterion::Standard] {
        for modes in [0, 1000] {
            let mut loaded = shipped(criterion);
            (loaded.scene.basis.components, loaded.scene.basis.modes) = (Some(120), modes);
            let table = build(&loaded.scene, &loaded.lights, &loaded.materials).unwrap();
            assert_rows(&table);
            let owned = OwnedBasis::<f64>::new(&table);
            let mut shader = Shader::new(owned.basis().unwrap(), usize::MAX);
            let entries = loaded.lights.entries.iter().zip(&loaded.materials.entries);
            for (light, material) in entries {
                let (light, material) = (&light.rgb[2], &material.rgb[2]);
                let ours = shader.project((9, light), (7, material)).unwrap();
                let dense = dense(&table, light, material);
                let largest = dense.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
                assert_eq!(ours.len(), 120);
                for (ours, dense) in ours.iter().zip(&dense) {
                    assert!((ours - dense).abs() <= tolerances::DENSE_PROJECTION * largest);
                }
            }
        }
    }
}

fn assert_rows(table: &Table) {
    let mut kept = vec![0; table.gram.degree + 1];
    for profile in &table.profiles {
        let columns = table.gram.columns(profile.azimuth);
        let modes = mode::indices(9, 7, profile.azimuth);
        kept[profile.azimuth] = 0;
        for (((l, o, p, q), column), entry) in modes.zip(columns).zip(table.gram_row(profile)) {
            let product: f64 = column.iter().zip(&profile.node_values).map(|(a, w)| a * w).sum();
            let keeps = table.keeps(profile.azimuth, l, o, p, q);
            kept[profile.azimuth] += usize::from(keeps);
            let expected = if keeps { product } else { 0.0 };
            assert!((entry - expected).abs() <= tolerances::ORTHONORMAL_NODES);
        }
    }
    let expected = if table.scene.basis.modes == 0 { mode::total(9, 7) } else { 1000 };
    let kept = kept[0] + 2 * kept[1..].iter().sum::<usize>();
    assert!((expected..expected + 2).contains(&kept), "{kept} modes; ±m are kept together");
}

fn dense(table: &Table, light: &[f64], material: &[f64]) -> Vec<f64> {
    let of_component = |(index, component): (usize, &eigenshade_table::Component)| {
        let m = component.order as isize;
        let profile = &table.profiles[component.profile];
        let sign = if m < 0 && m % 2 != 0 { -1.0 } else { 1.0 };
        let modes = mode::indices(9, 7, profile.azimuth).zip(table.gram_row(profile));
        let sum: f64 = modes
            .map(|((l, o, p, q), entry)| {
                let b = material[eigenshade_index::material::position(o, p, q)];
                entry * light[light::position(l, m)] * b
            })
            .sum();
        sign * sum - table.mean.as_ref().map_or(0.0, |mean| mean.coefficients[index])
    };
    table.components.iter().enumerate().map(of_component).collect()
}

/// The lines of a CSV of normals with weights.
fn csv(normals: impl IntoIterator<Item = ([f64; 3], f64)>) -> String {
    let mut text = "x,y,z,weight\n".to_owned();
    for ([x, y, z], weight) in normals {
        writeln!(text, "{x},{y},{z},{weight}").expect("text");
    }
    text
}

/// The largest error of the pictures of these normals by their table, relative to the largest |I|,
/// and the number of components.
fn errors_of_pictures(name: &str, normals: &str) -> (f64, usize) {
    let mut worst: f64 = 0.0;
    let mut count = 0;
    for criterion in ["image-centered", "standard"] {
        let folder = Folder::new();
        folder.write("object.csv", normals);
        let text = scene(criterion, 10_000, "[]");
        folder.write("scene.toml", text.replace("\"sphere\"", "\"object.csv\""));
        folder.ok("basis --scene scene.toml --out b.bin");
        let shaded = |options: &str| {
            let shade = format!("shade --table b.bin {PAIR} --normals object.csv {options}");
            numbers(&rows(&folder.ok(&shade), SHADED), 3)
        };
        let reference = shaded("--method modes");
        let ours = shaded("--method polynomial --format f64");
        let error = difference(&ours, &reference);
        assert!(error.is_finite(), "{name}, {criterion}");
        worst = worst.max(error);
        count = count.max(folder.ok("eigenvalues --table b.bin").lines().count() - 1);
    }
    println!("{name}: {count} components, pictures {worst:.1e}");
    (worst, count)
}

/// Each object has no more components than it can have, and its pictures are right.
#[test]
fn objects_of_few_normals() {
    let aslant = [0.6, 0.0, 0.8];
    let two = |x: f64, weight: f64| csv([(aslant, 1.0), ([x, 0.0, 0.8], weight)]);
    let patch = (0..400).map(|k| ([f64::from(k % 20) * 1e-5, f64::from(k / 20) * 1e-5, 1.0], 1.0));
    for (name, normals, most) in [
        ("toward the camera", csv([([0.0, 0.0, 1.0], 1.0)]), 1),
        ("on the rim", csv([([0.0, 1.0, 0.0], 1.0)]), 1),
        ("aslant, a hundred times", csv((0..100).map(|_| (aslant, 1.0))), 1),
        ("a roof", two(-0.6, 3.0), 2),
        ("two within 1e-9", two(0.6 + 1e-9, 1.0), 2),
        ("a patch of a hundredth of a degree", csv(patch), 10),
    ] {
        let (worst, count) = errors_of_pictures(name, &normals);
        assert!(worst <= tolerances::GENERAL_PICTURES, "{name}: {worst:e}");
        assert!(count <= most, "{name}: {count} components, where at most {most} are possible");
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
