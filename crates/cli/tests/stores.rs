//! What a table keeps, by the scene's `store`: the same images from less and less.

use crate::support::{Folder, assert_fails, materials, numbers, rows, scene};
use crate::tolerances;
use eigenshade_table::{Table, decode, encode};
use std::fs;

const PAIR: &str = "--lights lights.csv --materials materials.csv";
const RENDER: &str = "render materials.bin --light lights.csv:light-0 --material materials.csv:material-1 --size 8 --out r.png";
const STORES: [&str; 3] = ["modes", "projection", "materials"];

/// A folder with a table of each store, the materials in color.
fn folder(criterion: &str) -> Folder {
    let folder = Folder::new();
    let color: String = materials(3, 4)
        .lines()
        .map(|line| match line.rsplit_once(',') {
            Some((places, "value")) => format!("{places},r,g,b\n"),
            Some((places, value)) => {
                let value: f64 = value.parse().unwrap();
                format!("{places},{value},{},{value}\n", 0.5 * value)
            }
            None => panic!("a row"),
        })
        .collect();
    folder.write("materials.csv", color);
    for store in STORES {
        let scene = scene(criterion, 30, "[]") + &format!("store = \"{store}\"\n");
        folder.write(&format!("{store}.toml"), scene);
        folder.ok(&format!("basis --scene {store}.toml --out {store}.bin"));
        folder.ok(&format!("basis --scene {store}.toml --check {store}.bin"));
    }
    folder
}

fn table(folder: &Folder, store: &str) -> Table {
    decode(&fs::read(folder.path(&format!("{store}.bin"))).unwrap()).unwrap()
}

#[test]
fn every_store_gives_the_same_images() {
    for criterion in ["image-centered", "standard"] {
        let folder = folder(criterion);
        for format in ["f64", "f32"] {
            let shaded = |store: &str| {
                let normals = "--normals normals.csv";
                let text =
                    folder.ok(&format!("shade {store}.bin {PAIR} {normals} --format {format}"));
                numbers(&rows(&text, "light,material,normal,r,g,b"), 3)
            };
            let expected = shaded("modes");
            let peak = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
            let tolerance = match format {
                "f64" => tolerances::DENSE_PROJECTION,
                _ => tolerances::POLYNOMIAL_F32,
            };
            for store in STORES {
                let found = shaded(store);
                let apart = found.iter().zip(&expected).map(|(a, b)| (a - b).abs());
                let worst = apart.fold(0.0, f64::max) / peak;
                assert!(worst <= tolerance, "{criterion}, {store}, {format}: {worst}");
            }
        }
        let d = STORES.map(|store| folder.ok(&format!("project {store}.bin {PAIR}")));
        let [expected, _, of_materials] =
            d.map(|text| numbers(&rows(&text, "light,material,component,r,g,b"), 3));
        let largest = expected.iter().fold(0.0f64, |most, value| most.max(value.abs()));
        for (found, expected) in of_materials.iter().zip(&expected) {
            assert!((found - expected).abs() <= tolerances::DENSE_PROJECTION * largest);
        }
        folder.ok(RENDER);
    }
}

#[test]
fn tables_keep_what_they_say() {
    let folder = folder("image-centered");
    let sizes =
        STORES.map(|store| fs::metadata(folder.path(&format!("{store}.bin"))).unwrap().len());
    assert!(sizes.is_sorted_by(|a, b| a > b), "{sizes:?}");
    let of_materials = table(&folder, "materials");
    // Of the four materials red and blue are one, green is another.
    let degrees: usize = of_materials.profiles.iter().map(|one| 5 - one.azimuth).sum();
    assert_eq!(of_materials.transfers.len(), 8);
    assert!(of_materials.transfers.iter().all(|one| one.numbers.len() == degrees));
    for (store, words) in [
        ("modes", "U over modes, the factors of U^T M"),
        ("projection", "U over modes is made again from the scene"),
        ("materials", "the transfers of the scene's materials; U and U^T M are made again"),
    ] {
        assert!(folder.ok(&format!("info {store}.bin")).contains(words), "{store}");
    }
}

#[test]
fn other_materials_are_refused() {
    let folder = folder("image-centered");
    folder
        .write("materials.csv", materials(3, 1).replace("material-0,0,0,0,", "material-0,0,0,0,1"));
    let words = ["transfers of its scene's materials", "store = \"projection\""];
    let shade = format!("shade materials.bin {PAIR} --normals normals.csv --out new.csv");
    assert_fails(&folder, &shade, &words);
    assert_fails(&folder, &format!("project materials.bin {PAIR} --out new.csv"), &words);
    folder.ok(&format!("shade projection.bin {PAIR} --normals normals.csv"));
}

/// What a table keeps and what its scene says have to fit.
#[test]
fn contradictions_are_damage() {
    let folder = folder("image-centered");
    let of_materials = table(&folder, "materials");
    let whole = table(&folder, "modes");
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
    // A check tells a transfer that is off.
    let mut off = self::table(&folder, "materials");
    off.transfers[3].numbers[2] += 1e-6;
    folder.write("materials.bin", encode(&off));
    let check = "basis --scene materials.toml --check materials.bin";
    let output = folder.run(check);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stderr).contains("transfers differ"));
}

/// Objects' tables, too, leave U out where they are told to; what they shade is the same.
#[test]
fn tables_of_objects_leave_modes_out() {
    for (criterion, rotation) in [("image-centered", "any"), ("standard", "none")] {
        let folder = Folder::new();
        let whole = scene(criterion, 12, "[]")
            .replace("normals = \"sphere\"", "normals = \"normals.csv\"")
            .replace("rotation = \"any\"", &format!("rotation = \"{rotation}\""));
        for store in STORES {
            let text = whole.clone() + &format!("store = \"{store}\"\n");
            folder.write(&format!("{store}.toml"), text);
        }
        for store in ["modes", "projection"] {
            folder.ok(&format!("basis --scene {store}.toml --out {store}.bin"));
            folder.ok(&format!("basis --scene {store}.toml --check {store}.bin"));
        }
        let [modes, projection] = ["modes", "projection"].map(|store| table(&folder, store));
        let general = |table: &Table| table.general.clone().expect("an object's");
        assert!(general(&projection).modes.is_empty() && !general(&modes).modes.is_empty());
        assert!(projection.profiles.iter().all(|profile| profile.modes.is_empty()));
        assert!(encode(&projection).len() < encode(&modes).len());
        // Nothing else is another.
        let mut emptied = modes.clone();
        emptied.scene = projection.scene.clone();
        emptied.keep(std::iter::empty());
        assert_eq!(emptied, projection);
        let broken = Table { scene: projection.scene.clone(), ..modes };
        assert!(decode(&encode(&broken)).is_err());

        let shade = |store: &str| {
            folder.ok(&format!("shade {store}.bin {PAIR} --normals normals.csv --format f64"))
        };
        assert_eq!(shade("projection"), shade("modes"));
        let basis = "basis --scene materials.toml --out new.bin";
        assert_fails(&folder, basis, &["store = \"materials\"", "store = \"projection\""]);
    }
}
