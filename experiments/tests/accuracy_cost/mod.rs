//! `experiments accuracy-cost`: its errors, its fronts, its page, and what it says of a folder
//! that is not so.

use crate::oracle;
use crate::tolerances;

mod page;

use crate::support::{Folder, assert_fails, repository};
use eigenshade_index::material;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use experiments::accuracy_cost::bases::Bases;
use experiments::accuracy_cost::check::{self, compare};
use experiments::accuracy_cost::front::front;
use experiments::accuracy_cost::images::{Image, Images};
use experiments::accuracy_cost::kept::Kept;
use experiments::accuracy_cost::materials::{MEASURED, Scope};
use experiments::accuracy_cost::setting::{Recipe, Setting, Way};
use experiments::accuracy_cost::{method, model};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// An error of a setting, relative: hosts round differently, and rounding may end a polynomial a term
/// earlier or later, which moves the error of one cut short by a per cent.
const COST_ERROR: f64 = 0.02;

/// The same in any case: errors below that are roundings of f32, which fused multiplications halve.
const COST_ROUNDING: f64 = 1e-6;

/// Bytes, relative: such a term in all profiles of an azimuth.
const COST_BYTES: f64 = 0.02;

/// A fitted exponent of bytes, beside that of theory: lower powers are still there at the largest
/// sizes, (24 / 2 + 1)² of the order; and azimuths grow as the root of the components, so that rows of
/// 10 - |m| numbers shrink from 8 to 5 over three octaves, which is 0.23.
const COST_EXPONENT: f64 = 0.3;

/// The rms of a setting's error on other normals, relative: a thousand rings' normals against two
/// thousand spread evenly, with an error that stands at the rim.
const COST_NORMALS: f64 = 0.05;

/// Titles of the machines and their columns.
const MACHINES: [(&str, &str); 6] = [
    ("x86-64", "host"),
    ("Cortex-M0", "m0"),
    ("Cortex-M3", "m3"),
    ("Cortex-M4F", "m4f"),
    ("RV32IMAC", "rv32"),
    ("WebAssembly", "wasm"),
];

fn docs() -> PathBuf {
    repository().join("docs/accuracy-cost")
}

fn read(name: &str) -> String {
    fs::read_to_string(docs().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Rows of a committed file, by column.
fn sheet(name: &str) -> Vec<HashMap<String, String>> {
    let text = read(name);
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_reader(text.as_bytes());
    reader.deserialize().map(|row| row.expect("a row")).collect()
}

fn number(row: &HashMap<String, String>, column: &str) -> Option<f64> {
    let text = row.get(column).unwrap_or_else(|| panic!("no column {column}"));
    (!text.is_empty()).then(|| text.parse().unwrap_or_else(|_| panic!("{column}: {text}")))
}

/// Normals of equal shares of the disc, not those of the command.
fn spread(count: usize) -> Vec<[f64; 3]> {
    (0..count)
        .map(|k| {
            let square = (k as f64 + 0.5) / count as f64;
            let tilt = std::f64::consts::TAU * 0.618_034 * k as f64;
            let radius = square.sqrt();
            [radius * tilt.cos(), radius * tilt.sin(), (1.0 - square).sqrt()]
        })
        .collect()
}

/// The truth is the integral (3), and a setting's error is what its image is off that.
#[test]
fn errors_are_those_of_direct_quadrature() {
    let (degree, order) = (5, 4);
    let mut scope = Scope::new(degree, order).expect("the shipped data");
    let bases = Bases::new(&scope, [Recipe::all(degree, order)]).expect("a basis");
    scope.lights.entries.truncate(2);
    scope.seen.entries.truncate(2);
    scope.unseen.entries.truncate(1);
    let images = Images::new(&scope);
    assert_eq!(images.images.len(), 6);
    let reference = |image: &Image, normal: [f64; 3]| {
        let light = oracle::ExplicitLight::new(&image.light);
        let terms: Vec<_> = material::indices(order)
            .zip(&image.material)
            .map(|((o, p, q), b)| (o, p, q, *b))
            .collect();
        oracle::irradiance(&light, &terms, normal)
    };
    for image in &images.images {
        for k in (0..images.normals.len()).step_by(97) {
            let apart = (image.reference[k] - reference(image, images.normals[k])).abs();
            assert!(apart <= tolerances::DIRECT_SUM * image.peak, "{apart:e}");
        }
    }
    let weights: f64 = images.weights.iter().sum();
    assert!((weights - 1.0).abs() < tolerances::RING_SHARES);
    // An error that is not just rounding.
    let recipe = Recipe::first(degree, order, 12);
    let table = bases.table(&recipe).expect("a table");
    let found = method::compare(&Setting::of(recipe), &table, &images).expect("errors");
    let normals = spread(1000);
    let owned = OwnedBasis::<f32>::new(&table);
    let shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let view = OwnedNormals::new(&normals);
    let errors = |seen: bool| {
        let of = |image: &Image| {
            let shaded = shader
                .clone()
                .polynomial((degree, &image.light), (order, &image.material), &view)
                .expect("an image");
            let truths = normals.iter().map(|&normal| reference(image, normal));
            let square: f64 =
                shaded.iter().zip(truths).map(|(&a, b)| (f64::from(a) - b).powi(2)).sum();
            (square / normals.len() as f64).sqrt() / image.peak
        };
        images.images.iter().filter(|image| image.seen == seen).map(of).collect::<Vec<f64>>()
    };
    let (seen, unseen) = (errors(true), errors(false));
    let most = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let near = |a: f64, b: f64| (a / b - 1.0).abs() <= COST_NORMALS;
    assert_eq!((seen.len(), unseen.len()), (4, 2));
    assert!(near(found.seen.rms.worst, most(&seen)), "{found:?} {seen:?}");
    assert!(near(found.unseen.rms.worst, most(&unseen)), "{found:?} {unseen:?}");
    let mean = 0.5 * (unseen[0] + unseen[1]);
    assert!(near(found.unseen.rms.median, mean), "{found:?} {unseen:?}");
    assert!(found.seen.rms.worst > 1e-3 && found.seen.largest.worst > found.seen.rms.worst);
    // The nine-term formula is exact for what it is of.
    let scope = Scope::new(2, 0).expect("the shipped data");
    let bases = Bases::new(&scope, [Recipe::all(2, 0)]).expect("a basis");
    let setting = Setting::of(Recipe::all(2, 0)).by(Way::NineTerms);
    let table = bases.table(&setting.recipe).expect("a table");
    let found = method::compare(&setting, &table, &Images::new(&scope)).expect("errors");
    assert!(found.seen.largest.worst < COST_ROUNDING, "{found:?}");
}

/// Whether one point is as good as another in both, and better in one.
fn beats(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
}

#[test]
fn fronts_are_what_nothing_beats() {
    let rows = sheet("accuracy-cost.csv");
    let mut numbers = oracle::Numbers(3);
    let random: Vec<(f64, f64)> = (0..200)
        .map(|_| ((4.0 * numbers.next()).floor(), (9.0 * numbers.next()).floor()))
        .collect();
    let mut sets = vec![random];
    for (_, key) in MACHINES {
        let place = |row: &HashMap<String, String>| {
            Some((number(row, &format!("{key}_pixel"))?, number(row, "rms_median")?))
        };
        sets.push(rows.iter().filter_map(place).collect());
    }
    for points in sets {
        let on = front(&points);
        assert!(!on.is_empty());
        for (k, &point) in points.iter().enumerate() {
            let beaten = points.iter().any(|&other| beats(other, point));
            let twin = on.iter().any(|&other| points[other] == point);
            assert_eq!(twin, !beaten, "{k}: {point:?}");
        }
        let costs: Vec<f64> = on.iter().map(|&k| points[k].0).collect();
        assert!(costs.is_sorted_by(|a, b| a < b));
    }
}

/// Bytes grow as theory says, by a fit of our own.
#[test]
fn bytes_grow_as_they_should() {
    let rows = sheet("growth.csv");
    let theory = [
        ("degree", "rows of the components", 1.0),
        ("order", "rows of the components", 2.0),
        ("components", "rows of the components", 1.0),
        ("degree", "polar integrals", 1.0),
        ("order", "polar integrals", 2.0),
        ("components", "polar integrals", 0.0),
        ("degree", "a folded material", 1.0),
        ("order", "a folded material", 0.0),
        ("components", "a folded material", 1.0),
        ("materials", "transfers", 1.0),
        ("pixels", "a picture's f32", 1.0),
        ("maps", "coefficients", 1.0),
    ];
    for (quantity, measure, expected) in theory {
        let of = |row: &&HashMap<String, String>| {
            row["quantity"] == quantity && row["measure"] == measure && row["unit"] == "bytes"
        };
        let points: Vec<(f64, f64)> = rows
            .iter()
            .filter(of)
            .map(|row| (number(row, "size").unwrap().ln(), number(row, "counted").unwrap().ln()))
            .collect();
        assert!(points.len() >= 4, "{quantity}, {measure}");
        // From the middle to the end.
        let (first, last) = (points[points.len() / 2], points[points.len() - 1]);
        let slope = (last.1 - first.1) / (last.0 - first.0);
        assert!((slope - expected).abs() <= COST_EXPONENT, "{quantity}, {measure}: {slope}");
    }
}

/// "Model" has real materials in it, each at every degree and order.
#[test]
fn the_model_has_measured_materials() {
    let (page, rows) = (read("accuracy-cost.md"), sheet("model.csv"));
    let sizes = model::sizes().len();
    for fit in &MEASURED {
        let found = rows.iter().filter(|row| row["surface"] == fit.name).count();
        assert_eq!(found, sizes, "{}", fit.name);
        assert!(page.contains(&format!(" {} |", fit.name)), "{}", fit.name);
    }
    assert!(page.contains(&format!("{} measured materials", MEASURED.len())));
}

/// The times that `--keep-times` takes over are all that the files have.
#[test]
fn kept_times_are_those_of_the_files() {
    let kept = Kept::read(&docs()).expect("the files");
    for row in sheet("accuracy-cost.csv") {
        let (cost, price) = kept.of_setting(&row["setting"]).expect("a time");
        let found = [cost.pixel, cost.light, price.pixel.unwrap(), price.light.unwrap()];
        let columns = ["host_pixel_ns", "host_light_ns", "host_pixel", "host_light"];
        assert_eq!(found, columns.map(|column| number(&row, column).unwrap()));
    }
    assert!(kept.of_setting("9/7 K51 polynomial f32").is_none());
    let folder = Folder::new();
    fs::create_dir(folder.path("docs")).unwrap();
    assert_fails(&folder, "accuracy-cost --out docs --keep-times", &["docs/accuracy-cost.csv"]);
    assert_eq!(folder.run("accuracy-cost --check docs --keep-times").status.code(), Some(2));
}

/// What is compared is told with its line; times are not compared.
#[test]
fn damage_is_found() {
    assert_eq!(
        [check::ERROR, check::ROUNDING, check::BYTES, check::EXPONENT],
        [COST_ERROR, COST_ROUNDING, COST_BYTES, COST_EXPONENT]
    );
    let folder = Folder::new();
    let name = "accuracy-cost.csv";
    let good = read(name);
    let fresh = [(name, good.clone())];
    let compared = |text: &str| {
        folder.write(name, text);
        compare(&fresh, &[], &folder.path("."), true).map_err(|error| error.to_string())
    };
    let found = compared(&good).expect("nothing is damaged");
    assert!(found.rows > 100 && found.numbers > 1500, "{found:?}");
    let lines: Vec<&str> = good.lines().collect();
    let header: Vec<&str> = lines[1].split(',').collect();
    let place = lines.iter().position(|line| line.contains("9/7 K50 polynomial f32,")).unwrap();
    let changed = |column: &str, to: &dyn Fn(f64) -> f64| {
        let mut fields: Vec<String> = lines[place].split(',').map(str::to_owned).collect();
        let at = header.iter().position(|name| *name == column).unwrap();
        let old: f64 = fields[at].parse().unwrap_or_else(|_| panic!("{column}"));
        fields[at] = to(old).to_string();
        good.replacen(lines[place], &fields.join(","), 1)
    };
    for column in ["host_pixel_ns", "host_light_ns", "host_pixel", "wasm_pixel"] {
        compared(&changed(column, &|time| 3.0 * time)).expect("times are not compared");
    }
    compared(&changed("rms_median", &|error| 1.01 * error)).expect("within the tolerance");
    for (column, factor) in [
        ("rms_median", 1.05),
        ("rms_worst", 0.9),
        ("unseen_rms_most", 1.1),
        ("unseen_largest_worst", 1.1),
        ("model_median", 1.1),
        ("table_bytes", 1.1),
        ("state_bytes", 0.5),
        ("m4f_light", 1.001),
        ("degree", 2.0),
    ] {
        let message = compared(&changed(column, &|value| factor * value)).expect_err(column);
        let line = format!("{name}:{}: ", place + 1);
        for word in [&line, column, "belongs", "accuracy-cost --out"] {
            assert!(message.contains(word), "{column}: {message}");
        }
        assert!(!message.contains('\n'), "{message}");
    }
    let without = good.replacen(&format!("{}\n", lines[place]), "", 1);
    assert!(compared(&without).expect_err("a row").contains("no row of `9/7 K50 polynomial f32`"));
    let twice = format!("{good}{}\n", lines[place].replace("K50", "K51"));
    assert!(compared(&twice).expect_err("a row").contains("rows where"));
    let renamed = good.replacen("rms_worst", "rms_largest", 1);
    assert!(compared(&renamed).expect_err("a header").contains("rms_worst"));
    compared(&good).expect("all is whole again");
}

/// What a run without times finds: it is compared with the committed files, rows of times apart.
#[test]
fn a_run_without_times_is_compared_whole() {
    let untimed = |name: &str| -> String {
        let text = read(name);
        let header: Vec<&str> = text.lines().nth(1).expect("a header").split(',').collect();
        let keep = |line: &&str| !line.contains(",ns,");
        let blank = |line: &str| -> String {
            let fields = line.split(',').zip(&header);
            let kept = fields.map(|(field, column)| match column.starts_with("host_") {
                true if field != *column => "",
                _ => field,
            });
            kept.collect::<Vec<_>>().join(",")
        };
        text.lines().filter(keep).map(|line| blank(line) + "\n").collect()
    };
    let names = ["accuracy-cost.csv", "model.csv", "growth.csv"];
    let fresh = names.map(|name| (name, untimed(name)));
    assert!(fresh[2].1.lines().count() < read(names[2]).lines().count());
    let found = compare(&fresh, &[], &docs(), true).unwrap_or_else(|error| panic!("{error}"));
    assert!(found.rows > 300, "{found:?}");
    let short = fresh[2].1.lines().take(20).map(|line| format!("{line}\n")).collect();
    let error = compare(&[(names[2], short)], &[], &docs(), true).expect_err("rows are missing");
    assert!(error.to_string().contains("rows where 18 belong"), "{error}");
}

#[test]
fn bad_input_is_told_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    let start = std::time::Instant::now();
    assert_fails(&folder, "accuracy-cost --out file", &["file"]);
    assert_fails(&folder, "accuracy-cost --check nowhere", &["nowhere", "accuracy-cost.csv"]);
    assert_eq!(folder.run("accuracy-cost").status.code(), Some(2));
    assert_eq!(folder.run("accuracy-cost --out a --check b").status.code(), Some(2));
    fs::create_dir(folder.path("docs")).unwrap();
    folder.write("docs/accuracy-cost.csv", "");
    let missing = &["esplanade.exr", "no such map", "--maps"];
    assert_fails(&folder, "accuracy-cost --check docs --maps nowhere", missing);
    fs::create_dir(folder.path("maps")).unwrap();
    folder.write("maps/esplanade.exr", "no map");
    assert_fails(&folder, "accuracy-cost --check docs --maps maps", &["esplanade.exr"]);
    // The work takes minutes.
    assert!(start.elapsed().as_secs() < 30);
    assert!(Path::new(&folder.path("docs/accuracy-cost.csv")).exists());
}
