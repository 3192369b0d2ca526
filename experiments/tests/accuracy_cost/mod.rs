//! `experiments accuracy-cost`: its errors, its choices, and its checks.

use crate::oracle;
use crate::support::{Folder, assert_fails, repository};
use crate::{spread, tolerances};
use eigenshade_generator::material::brdf::projection::project;
use eigenshade_generator::material::brdf::{Ggx, Measure};
use eigenshade_index::material;
use eigenshade_model::database::Named;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use experiments::accuracy_cost::bases::Bases;
use experiments::accuracy_cost::check::{self, Compared, compare};
use experiments::accuracy_cost::choice::{LIMITS, Lighting, TIE, cheapest, pareto};
use experiments::accuracy_cost::images::{Image, Images};
use experiments::accuracy_cost::machines::MACHINES;
use experiments::accuracy_cost::materials::{Scope, modelled};
use experiments::accuracy_cost::setting::{Recipe, Setting, Way};
use experiments::accuracy_cost::sheet::{self, GROWTH, MODEL, SETTINGS};
use experiments::accuracy_cost::{Measured, errors, report, settings};
use experiments::pages::with_parts;
use std::collections::HashMap;
use std::fs;
use std::path::PathBuf;

/// An error of a setting, relative: hosts round differently, and rounding may end a polynomial a
/// term earlier or later, which moves the error of one cut short by a per cent.
const COST_ERROR: f64 = 0.02;

/// The same in any case: errors below that are roundings of f32, which fused multiplications halve.
const COST_ROUNDING: f64 = 1e-6;

/// Bytes, relative: such a term in all profiles of an azimuth.
const COST_BYTES: f64 = 0.02;

/// A fitted exponent of bytes, beside that of theory: lower powers are still there at the largest
/// sizes, (24 / 2 + 1)² of the order; and azimuths grow as the root of the components, so that rows
/// of 10 - |m| numbers shrink from 8 to 5 over three octaves, which is 0.23.
const COST_EXPONENT: f64 = 0.3;

/// The rms of a setting's error on other normals, relative: a thousand rings' normals against two
/// thousand spread evenly, with an error that stands at the rim.
const COST_NORMALS: f64 = 0.05;

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

/// A glossy dielectric, of which no basis here is made.
fn unseen(order: usize) -> Named {
    let ggx = Ggx::new(0.3, 0.04, 0.5).expect("a material");
    let coefficients = project(&ggx, order, Measure::Projected).coefficients;
    Named { name: "ggx".into(), rgb: [0; 3].map(|_| coefficients.clone()) }
}

/// The reference is the integral (3), and a setting's error is the difference of its image.
#[test]
fn errors_are_those_of_direct_quadrature() {
    let (degree, order) = (5, 4);
    let mut scope = Scope::seen(degree, order).expect("the shipped data");
    let bases = Bases::new(&scope, [Recipe::all(degree, order)]).expect("a basis");
    scope.lights.entries.truncate(2);
    scope.seen.entries.truncate(2);
    scope.unseen.entries.push(unseen(order));
    let images = Images::new(&scope);
    assert_eq!(images.images.len(), 6);
    let direct = |image: &Image, normal: [f64; 3]| {
        let light = oracle::ExplicitLight::new(&image.pair.light);
        let terms: Vec<_> = material::indices(order)
            .zip(&image.pair.material)
            .map(|((o, p, q), b)| (o, p, q, *b))
            .collect();
        oracle::irradiance(&light, &terms, normal)
    };
    for image in &images.images {
        for k in (0..images.normals.len()).step_by(97) {
            let apart = (image.reference[k] - direct(image, images.normals[k])).abs();
            assert!(apart <= tolerances::DIRECT_SUM * image.peak, "{apart:e}");
        }
    }
    let weights: f64 = images.weights.iter().sum();
    assert!((weights - 1.0).abs() < tolerances::RING_SHARES);
    // An error that is not just rounding.
    let recipe = Recipe::first(degree, order, 12);
    let table = bases.table(&recipe).expect("a table");
    let found = errors::compare(&Setting::of(recipe), &table, &images).expect("errors");
    // Not those of the command.
    let normals = spread(300);
    let owned = OwnedBasis::<f32>::new(&table);
    let shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let view = OwnedNormals::new(&normals);
    let errors = |seen: bool| {
        let of = |image: &Image| {
            let shaded = shader
                .clone()
                .polynomial((degree, &image.pair.light), (order, &image.pair.material), &view)
                .expect("an image");
            let direct = normals.iter().map(|&normal| direct(image, normal));
            let square: f64 =
                shaded.iter().zip(direct).map(|(&a, b)| (f64::from(a) - b).powi(2)).sum();
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
    let scope = Scope::seen(2, 0).expect("the shipped data");
    let bases = Bases::new(&scope, [Recipe::all(2, 0)]).expect("a basis");
    let setting = Setting::of(Recipe::all(2, 0)).by(Way::NineTerms);
    let table = bases.table(&setting.recipe).expect("a table");
    let found = errors::compare(&setting, &table, &Images::new(&scope)).expect("errors");
    assert!(found.seen.largest.worst < COST_ROUNDING, "{found:?}");
}

/// Whether one point is as good as another in both, and better in one.
fn beats(a: (f64, f64), b: (f64, f64)) -> bool {
    a.0 <= b.0 && a.1 <= b.1 && (a.0 < b.0 || a.1 < b.1)
}

/// The constants that the other tests use from the program.
#[test]
fn limits_and_machines_are_those_of_the_page() {
    assert_eq!(LIMITS, [0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4, 1e-5]);
    assert_eq!(TIE, 1.05);
    let keys = MACHINES.map(|machine| machine.key);
    assert_eq!(keys, ["host", "m0", "m3", "m4f", "rv32", "wasm"]);
}

#[test]
fn nothing_beats_a_point_of_the_pareto_set_and_something_every_other() {
    let rows = sheet("accuracy-cost.csv");
    let mut numbers = oracle::Numbers(3);
    let random: Vec<(f64, f64)> = (0..200)
        .map(|_| ((4.0 * numbers.next()).floor(), (9.0 * numbers.next()).floor()))
        .collect();
    let mut sets = vec![random];
    for machine in &MACHINES {
        let place = |row: &HashMap<String, String>| {
            Some((number(row, &format!("{}_pixel", machine.key))?, number(row, "rms_median")?))
        };
        sets.push(rows.iter().filter_map(place).collect());
    }
    for points in sets {
        let front = pareto(&points);
        assert!(!front.is_empty());
        for &point in &points {
            let beaten = points.iter().any(|&other| beats(other, point));
            assert_eq!(front.contains(&point), !beaten, "{point:?}");
        }
        assert!(front.is_sorted_by(|a, b| a.0 < b.0));
    }
    assert!(pareto(&[(1.0, f64::NAN), (f64::NAN, 0.0)]).is_empty());
}

/// The chosen setting's error is below the limit, nothing in the file does it for less, and nothing
/// better for as much.
#[test]
fn the_cheapest_setting_that_suffices_is_chosen() {
    let rows = sheet("accuracy-cost.csv");
    let records = sheet::read(&SETTINGS, &docs()).expect("the file");
    let mut checked = 0;
    for machine in &MACHINES {
        let key = machine.key;
        for (lighting, limit) in [Lighting::Still, Lighting::Moving]
            .into_iter()
            .flat_map(|lighting| LIMITS.map(|limit| (lighting, limit)))
        {
            let cost = |row: &HashMap<String, String>| {
                let pixels = 9216.0 * number(row, &format!("{key}_pixel"))?;
                match lighting {
                    Lighting::Still => Some(pixels),
                    Lighting::Moving => Some(pixels + number(row, &format!("{key}_light"))?),
                }
            };
            let able: Vec<_> = rows
                .iter()
                .filter(|row| {
                    let of_paper = row["degree"] == "9" && row["order"] == "7";
                    let modelled = number(row, "model_median").is_some_and(|one| one <= limit);
                    let error = number(row, "unseen_rms_most").expect("an error");
                    row["knob"] != "mathematics" && error <= limit && (of_paper || modelled)
                })
                .filter_map(|row| Some((row, cost(row)?)))
                .collect();
            let chosen = cheapest(&records, machine, lighting, limit);
            assert_eq!(chosen.is_some(), !able.is_empty(), "{key} {limit}");
            let Some(chosen) = chosen else { continue };
            let is_it = |row: &HashMap<String, String>| row["setting"] == chosen.text("setting");
            let (taken, taken_cost) = able.iter().find(|(row, _)| is_it(row)).expect("it suffices");
            let least = able.iter().map(|(_, cost)| *cost).fold(f64::INFINITY, f64::min);
            // Times that are nearly the least are as good; the least error decides.
            let most = if ["host", "wasm"].contains(&key) { TIE * least } else { least };
            assert!(*taken_cost <= most, "{key} {limit}: {taken:?}");
            let error = |row: &HashMap<String, String>| {
                let model = number(row, "model_median").unwrap_or(f64::INFINITY);
                model.max(number(row, "unseen_rms_most").expect("an error"))
            };
            let is_better = |(row, cost): &(&HashMap<String, String>, f64)| {
                *cost <= most && error(row) < error(taken)
            };
            assert!(!able.iter().any(is_better), "{key} {limit}: {taken:?}");
            checked += 1;
        }
    }
    assert!(checked > 30, "{checked}");
}

/// Pictures of 96 x 96 pixels with an error below one per cent on a Cortex-M4F of 64 MHz, at an
/// instruction a cycle: 60 a second with less than half of the cycles where the light stands still,
/// 20 where it moves.
#[test]
fn a_reader_finds_a_setting_for_a_board() {
    let rows = sheet::read(&SETTINGS, &docs()).expect("the file");
    let m4f = MACHINES.iter().find(|machine| machine.key == "m4f").expect("a machine");
    let still = cheapest(&rows, m4f, Lighting::Still, 0.01).expect("a setting");
    assert_eq!(still.text("way"), "bilinear32");
    assert!(9216.0 * m4f.number(still, "pixel").expect("a cost") < 0.5 * 64e6 / 60.0);
    let moving = cheapest(&rows, m4f, Lighting::Moving, 0.01).expect("a setting");
    assert_eq!(moving.text("way"), "polynomial");
    let [pixel, light] = ["pixel", "light"].map(|one| m4f.number(moving, one).expect("a cost"));
    assert!(9216.0 * pixel + light < 64e6 / 20.0);
}

/// Every board has an answer down to 0.1 % for light that changes with every picture, and the
/// memory of its program.
#[test]
fn boards_have_rows_for_moving_light() {
    let rows = sheet::read(&SETTINGS, &docs()).expect("the file");
    for machine in MACHINES.iter().filter(|machine| machine.board.is_some()) {
        for limit in LIMITS.into_iter().filter(|limit| *limit >= 1e-3) {
            let row = cheapest(&rows, machine, Lighting::Moving, limit).expect("a setting");
            let [light, flash, ram] =
                ["light", "flash", "ram"].map(|one| machine.number(row, one).expect("a number"));
            assert!(light > 100.0 && flash > 1e4 && ram > 300.0, "{}: {row:?}", machine.key);
        }
    }
}

/// The tables and charts are those of the CSV files, and no other files are there.
#[test]
fn the_page_and_the_charts_show_the_files() {
    let measured = Measured::read(&docs()).expect("the files");
    let page = read(report::PAGE);
    let again = with_parts(&page, &report::tables(&measured)).expect("all markers");
    let command = "accuracy-cost --from-csv --out docs/accuracy-cost";
    assert!(again == page, "the tables are others: {command}");
    let charts = report::charts(&measured).expect("charts");
    for (name, svg) in &charts {
        assert!(read(name) == *svg, "{name} is another: {command}");
    }
    let known = [SETTINGS.name, MODEL.name, GROWTH.name, report::PAGE];
    for entry in fs::read_dir(docs()).expect("a folder") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(known.contains(&&*name) || charts.iter().any(|(one, _)| *one == name), "{name}");
        assert!(name == report::PAGE || page.contains(&format!("]({name})")), "{name}");
        let first = read(&name).lines().next().unwrap_or_default().to_owned();
        assert!(first.contains("accuracy-cost"), "{name}");
    }
    let links = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        let file = link.split('#').next().unwrap_or_default();
        assert!(docs().join(file).is_file(), "{link}");
    }
}

/// The file has the settings of the list, in its order.
#[test]
fn the_file_has_all_settings() {
    let rows = sheet("accuracy-cost.csv");
    let found: Vec<_> = rows.iter().map(|row| (&*row["knob"], row["setting"].clone())).collect();
    let all = settings::all(false);
    let all: Vec<_> = all.iter().map(|one| (one.parameter, one.setting.to_string())).collect();
    assert_eq!(found, all);
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

/// Each surface is there at every degree and order, and seven of them are measured.
#[test]
fn the_model_has_all_surfaces() {
    let rows = sheet("model.csv");
    let surfaces = modelled().expect("surfaces");
    assert_eq!(surfaces.len(), 13);
    for surface in &surfaces {
        let found = rows.iter().filter(|row| row["surface"] == surface.name).count();
        assert_eq!(found, settings::sizes().count(), "{}", surface.name);
    }
    assert_eq!(rows.len(), surfaces.len() * settings::sizes().count());
}

/// `--keep-times` takes over all times of the files and nothing else.
#[test]
fn kept_times_are_those_of_the_files() {
    let earlier = Measured::read(&docs()).expect("the files");
    let mut measured = earlier.clone();
    measured.growth.retain(|row| row.text("unit") != "ns");
    for row in &mut measured.settings {
        for column in ["host_pixel_ns", "host_light_ns", "host_pixel", "host_light"] {
            row.put(column, "");
        }
    }
    let mut other = earlier.clone();
    other.settings.iter_mut().for_each(|row| row.put("rms_median", 7));
    measured.keep_times(&other).expect("all times");
    assert_eq!(measured.settings, earlier.settings);
    assert_eq!(measured.growth, earlier.growth);
    measured.settings[0].put("setting", "9/7 K51 polynomial f32");
    assert!(measured.keep_times(&earlier).is_err());
    let folder = Folder::new();
    fs::create_dir(folder.path("docs")).unwrap();
    assert_fails(&folder, "accuracy-cost --out docs --keep-times", &["docs/accuracy-cost.csv"]);
    assert_eq!(folder.run("accuracy-cost --check docs --keep-times").status.code(), Some(2));
}

/// `--from-csv` makes the same files again, with a page where there is none.
#[test]
fn charts_and_tables_are_made_from_the_files() {
    let folder = Folder::new();
    for form in [&SETTINGS, &MODEL, &GROWTH] {
        folder.write(form.name, read(form.name));
    }
    folder.ok("accuracy-cost --out . --from-csv");
    for entry in fs::read_dir(docs()).expect("a folder") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(folder.read(&name) == read(&name), "{name}");
    }
}

/// A difference is reported with its line; times are not compared.
#[test]
fn damage_is_found() {
    assert_eq!(
        [check::ERROR, check::ROUNDING, check::BYTES, check::EXPONENT],
        [COST_ERROR, COST_ROUNDING, COST_BYTES, COST_EXPONENT]
    );
    let folder = Folder::new();
    let name = "accuracy-cost.csv";
    let good = read(name);
    let fresh = sheet::read(&SETTINGS, &docs()).expect("the file");
    let compared = |text: &str| {
        folder.write(name, text);
        let mut compared = Compared::default();
        compare(&SETTINGS, &fresh, &folder.path("."), true, &mut compared)
            .map(|()| compared)
            .map_err(|error| error.to_string())
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

/// A run without times is compared with the committed files, except for rows of times.
#[test]
fn a_run_without_times_is_compared_whole() {
    let mut untimed = Measured::read(&docs()).expect("the files");
    check::exponents(&untimed.growth).expect("exponents of theory");
    untimed.growth.retain(|row| row.text("unit") != "ns");
    for row in &mut untimed.settings {
        row.put("host_pixel", "");
    }
    let mut compared = Compared::default();
    for (form, rows) in untimed.sheets() {
        compare(form, rows, &docs(), true, &mut compared).unwrap_or_else(|error| panic!("{error}"));
    }
    assert!(compared.rows > 300, "{compared:?}");
    let short = &untimed.growth[..18];
    let error = compare(&GROWTH, short, &docs(), true, &mut compared).expect_err("missing rows");
    assert!(error.to_string().contains("rows where 18 belong"), "{error}");
    compare(&GROWTH, short, &docs(), false, &mut compared).expect("a quick run has fewer rows");
    for row in untimed.growth.iter_mut().filter(|row| row.text("unit") == "bytes") {
        let cube = row.number("size").unwrap().powi(3);
        row.put("counted", cube);
    }
    assert!(check::exponents(&untimed.growth).is_err());
}

#[test]
fn bad_input_is_reported_before_the_work() {
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
}
