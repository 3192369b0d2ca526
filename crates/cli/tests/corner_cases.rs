//! Tables of every kind that a scene can request, against the direct sum and dense products.

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
use std::fs;

/// As [`tolerances::ALL_COMPONENTS_F32`], at degree 16 and order 12: the powers of 2z - 1 cancel,
/// by up to 1e5 in the weakest profiles.
const ALL_COMPONENTS_F32_HIGH: f64 = 6e-6;

/// The largest error of both methods, in f64 and in f32, relative to the direct sum's peak.
fn errors(folder: &Folder, pair: &str) -> [f64; 2] {
    let shaded = |options: &str| {
        let text = folder.ok(&format!("shade b.bin {pair} --normals normals.csv {options}"));
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
    folder.ok("info b.bin");
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
    let mut loaded = scene_file::load(repository().join("tables/sphere.toml")).unwrap();
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
