//! `basis`: what a table stores, its comparison with a new one, and that it does not depend on the
//! number of threads.

use crate::PROGRAM;
use crate::support::files::built;
use crate::support::{
    BASIS, Folder, PAIR, assert_fails, assert_near, colored, materials, repository_text, scene,
    shipped_path, shipped_scene, stderr,
};
use crate::tolerances;
use eigenshade_model::inputs::coefficient_csv::read_materials;
use eigenshade_model::inputs::normals::read_normals;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::shipped;
use eigenshade_table::{MeanImage, Table, decode, encode};
use std::process::Command;

const RENDER: &str = "render --table materials.bin --light lights.csv:light-0 \
                      --material materials.csv:material-1 --size 8 --out r.png";
const STORES: [&str; 3] = ["modes", "projection", "materials"];

/// A folder with a table of each store and with materials in color.
fn with_stores(criterion: &str) -> Folder {
    let folder = Folder::new();
    let color = colored(&materials(3, 4), [0.5, 1.0]);
    folder.write("materials.csv", color);
    for store in STORES {
        let scene = scene(criterion, 30, "[]") + &format!("store = \"{store}\"\n");
        folder.write(&format!("{store}.toml"), scene);
        folder.ok(&format!("basis --scene {store}.toml --out {store}.bin"));
        folder.ok(&format!("basis --scene {store}.toml --check {store}.bin"));
    }
    folder
}

/// Pictures of a table of degree 32 against the direct sum, of the peak, in f64: profiles are
/// within 1e-7 of their largest value.
const HIGH_DEGREE: f64 = 1e-6;

/// The scene file of degree 32 with formulas, here of four materials: a smooth metal is the direct
/// sum.
#[test]
fn a_table_of_degree_32_is_the_direct_sum() {
    let folder = Folder::new();
    let formulas = repository_text("tables/inputs/pbr-materials.toml");
    let few = ["lambertian", "metal-0.2", "metal-0.3", "metal-0.5"];
    let of = |formula: &&str| few.iter().any(|name| formula.contains(&format!("\"{name}\"\n")));
    let formulas: Vec<&str> = formulas.split("[[material]]").filter(of).collect();
    assert_eq!(formulas.len(), few.len());
    folder.write("four.toml", format!("[[material]]{}", formulas.join("[[material]]")));
    let scene = shipped_scene("pbr-32");
    let all = shipped_path("inputs/pbr-materials.toml");
    folder.write("32.toml", scene.replace(&all, "four.toml"));
    folder.ok("basis --scene 32.toml --out 32.bin");
    folder.ok("material ggx --roughness 0.3 --f0 0.9 --order 32 --out m.csv");
    let scene = "--table 32.bin --light studio --material m.csv";
    let found = folder.irradiance(&format!("{scene} --format f64 --normals normals.csv"));
    let studio = shipped::lights().unwrap().entries;
    let studio = studio.into_iter().find(|light| light.name == "studio").unwrap();
    let material = read_materials(folder.path("m.csv"), None).unwrap();
    let sum = DirectSum::new(32, 32);
    let normals = read_normals(folder.path("normals.csv")).unwrap();
    let expected: Vec<f64> = normals
        .iter()
        .flat_map(|normal| {
            let modes = sum.at(*normal);
            let scattered = modes.scatter(&material.entries[0].rgb[0]);
            studio.rgb.each_ref().map(|light| modes.irradiance(light, &scattered))
        })
        .collect();
    assert_near("degree 32", &found, &expected, HIGH_DEGREE);
    // And it is drawn.
    folder.ok(&format!("render {scene} --format f64 -s 16 -o a.png"));
    assert_fails(
        &folder,
        &format!("render {scene} -s 16 -o b.png"),
        &["degree 32", "--format f64"],
    );
    for format in ["f32", "q15"] {
        for command in [
            format!("pack --table 32.bin --format {format} --out b.esw"),
            format!("export --table 32.bin --lang rust --format {format} --out b.rs"),
        ] {
            assert_fails(&folder, &command, &["degree 32 and order 32", "sources"]);
        }
    }
}

#[test]
fn every_store_gives_the_same_images() {
    for criterion in ["image-centered", "standard"] {
        let folder = with_stores(criterion);
        // Only f64 draws a mean image.
        let formats = ["f64", "f32"];
        for format in &formats[..if criterion == "standard" { 1 } else { 2 }] {
            let shaded = |store: &str| {
                folder.shaded_by(&format!("{store}.bin"), &format!("--format {format}"))
            };
            let expected = shaded("modes");
            let tolerance = match *format {
                "f64" => tolerances::DENSE_PROJECTION,
                _ => tolerances::POLYNOMIAL_F32,
            };
            for store in STORES {
                let what = format!("{criterion}, {store}, {format}");
                assert_near(&what, &shaded(store), &expected, tolerance);
            }
        }
        let [expected, _, of_materials] =
            STORES.map(|store| folder.projected(&format!("--table {store}.bin {PAIR}")));
        assert_near(criterion, &of_materials, &expected, tolerances::DENSE_PROJECTION);
        folder.ok(&format!("{RENDER} --format f64"));
    }
}

#[test]
fn tables_store_what_their_scene_requests() {
    let folder = with_stores("image-centered");
    let sizes = STORES.map(|store| folder.bytes(&format!("{store}.bin")).len());
    assert!(sizes.is_sorted_by(|a, b| a > b), "{sizes:?}");
    let of_materials = folder.table("materials.bin");
    // Each of the four materials has two different channels.
    let degrees: usize = of_materials.profiles.iter().map(|one| 5 - one.azimuth).sum();
    assert_eq!(of_materials.transfers.len(), 8);
    assert!(of_materials.transfers.iter().all(|one| one.numbers.len() == degrees));
    for (store, fragments) in [
        ("modes", "U over modes, the factors of U^T M"),
        ("projection", "U over modes is derived again from the scene"),
        ("materials", "the transfers of the scene's materials; U and U^T M are derived again"),
    ] {
        assert!(folder.ok(&format!("info --table {store}.bin")).contains(fragments), "{store}");
    }
}

#[test]
fn other_materials_are_refused() {
    let folder = with_stores("image-centered");
    folder
        .write("materials.csv", materials(3, 1).replace("material-0,0,0,0,", "material-0,0,0,0,1"));
    for command in ["shade --normals normals.csv", "project"] {
        let refused = format!("{command} --table materials.bin {PAIR} --out new.csv");
        assert_fails(&folder, &refused, &["its scene's materials", "store = \"projection\""]);
    }
    folder.shaded_by("projection.bin", "");
}

/// A table that does not store what its scene requests is damaged.
#[test]
fn contradictions_are_damage() {
    let folder = with_stores("image-centered");
    let of_materials = folder.table("materials.bin");
    let whole = folder.table("modes.bin");
    let mut transfer = of_materials.transfers[0].clone();
    transfer.numbers.pop();
    let broken = [
        Table { scene: of_materials.scene.clone(), ..whole.clone() },
        Table { scene: whole.scene.clone(), ..of_materials.clone() },
        Table { transfers: of_materials.transfers.clone(), ..whole.clone() },
        Table { transfers: vec![transfer], ..of_materials.clone() },
        Table { gram: whole.gram.clone(), ..of_materials.clone() },
        Table { profiles: whole.profiles.clone(), ..of_materials },
    ];
    for table in broken {
        assert!(decode(&encode(&table)).is_err());
    }
    // --check finds a wrong transfer.
    let mut off = folder.table("materials.bin");
    off.transfers[3].numbers[2] += 1e-6;
    folder.write("materials.bin", encode(&off));
    let check = "basis --scene materials.toml --check materials.bin";
    assert_fails(&folder, check, &["transfers differ"]);
}

/// The folder with a changed table.
fn altered(folder: Folder, change: impl FnOnce(&mut Table)) -> Folder {
    let mut table = folder.table("b.bin");
    change(&mut table);
    folder.write("b.bin", encode(&table));
    folder
}

const CHECK: &str = "basis --scene scene.toml --check b.bin";

fn assert_differs(folder: &Folder, what: &str) {
    assert_fails(folder, CHECK, &["b.bin", what, &format!("eigenshade {BASIS}")]);
    let text = String::from_utf8(folder.run(CHECK).stdout).unwrap();
    assert!(text.lines().any(|line| line.starts_with(what) && line.ends_with("OVER")), "{text}");
}

#[test]
fn new_tables_pass() {
    for criterion in ["image-centered", "standard"] {
        let text = built(&scene(criterion, 30, "[]"), &[]).ok(CHECK);
        assert_eq!(text.lines().count(), 9, "{text}");
        assert!(!text.contains("OVER"), "{text}");
    }
}

#[test]
fn altered_numbers_are_found() {
    for (change, what) in [
        (
            |table: &mut Table| *table.components[3].eigenvalue.as_mut().unwrap() *= 1.0 + 1e-6,
            "components' eigenvalues",
        ),
        (|table| *table.spectrum[3].1.as_mut().unwrap() *= 1.0 + 1e-6, "spectrum"),
        (|table| table.profiles[0].node_values[5] += 1e-6, "profiles at the nodes"),
        (|table| table.profiles[1].chebyshev[0] += 1e-6, "polynomials"),
        (|table| table.profiles[1].factors[0] += 1e-6, "rows of U^T M"),
        (|table| table.profiles[0].modes[0] += 1e-6, "images A U"),
        (|table| table.gram.root_weights[2] += 1e-6, "mode means e"),
    ] as [(fn(&mut Table), &str); 7]
    {
        assert_differs(&altered(Folder::with_table(), change), what);
    }
    let folder = Folder::with_table();
    folder.write("scene.toml", scene("image-centered", 9, "[]"));
    assert_fails(&folder, CHECK, &["b.bin", "another scene"]);
}

/// Polynomials of different lengths are compared as closely as others.
#[test]
fn polynomials_of_other_lengths_are_compared_term_by_term() {
    let folder = altered(Folder::with_table(), |table| table.profiles[1].chebyshev.push(1e-14));
    folder.ok(CHECK);
    let folder = altered(Folder::with_table(), |table| table.profiles[1].chebyshev.push(1e-6));
    assert_differs(&folder, "terms of one table only");
    let folder = altered(Folder::with_table(), |table| {
        table.profiles[1].chebyshev.push(0.0);
        table.profiles[1].chebyshev[0] += 1e-7;
    });
    assert_differs(&folder, "polynomials");
    let folder = altered(Folder::with_table(), |table| table.profiles[1].chebyshev.truncate(2));
    assert_differs(&folder, "terms of one table only");
}

#[test]
fn altered_means_are_found() {
    fn mean(table: &mut Table) -> &mut MeanImage {
        table.mean.as_mut().unwrap()
    }
    for (change, what) in [
        ((|table| mean(table).chebyshev[1] += 1e-6) as fn(&mut Table), "polynomials"),
        (|table| mean(table).coefficients[0] += 1e-6, "coefficients of the mean"),
    ] {
        let folder = built(&scene("standard", 30, "[]"), &[]);
        folder.ok(CHECK);
        assert_differs(&altered(folder, change), what);
    }
}

/// Every component of the shipped scene has the same order, sign and bits in every run and with any
/// number of threads. Each azimuth and each profile is computed by one thread. With faer's feature
/// `rayon` several threads would share a sum, and its last bits would depend on their number.
#[test]
fn tables_are_the_same_to_the_byte() {
    let folder = Folder::new();
    let line = |line: &str| match line.split_once(" = ") {
        Some(("components", _)) => "components = 10000\n".to_owned(),
        Some(("rank_cutoff", _)) => "rank_cutoff = 1e-13\n".to_owned(),
        _ => format!("{line}\n"),
    };
    folder.write("scene.toml", shipped_scene("sphere").lines().map(line).collect::<String>());
    let table = |threads: &str, name: &str| {
        let output = Command::new(PROGRAM)
            .current_dir(folder.path("."))
            .env("RAYON_NUM_THREADS", threads)
            .args(["basis", "--scene", "scene.toml", "--out", name])
            .output()
            .expect("the program runs");
        assert!(output.status.success(), "{}", stderr(&output));
        folder.bytes(name)
    };
    let first = table("1", "first.bin");
    assert!(first.len() > 1 << 18, "{} bytes", first.len());
    for (run, threads) in ["1", "2", "2", "3"].into_iter().enumerate() {
        assert!(table(threads, &format!("{run}.bin")) == first, "{threads} threads, run {run}");
    }
}
