//! `eigenshade accuracy-cost`: its errors, its fronts, the page's tables, and what it says of
//! a folder that is not so.

mod support;

#[path = "../../../tests/oracle/mod.rs"]
mod oracle;
#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

use eigenshade_cli::accuracy_cost::bases::Bases;
use eigenshade_cli::accuracy_cost::check::{self, compare};
use eigenshade_cli::accuracy_cost::front::front;
use eigenshade_cli::accuracy_cost::images::{Image, Images};
use eigenshade_cli::accuracy_cost::materials::Scope;
use eigenshade_cli::accuracy_cost::method;
use eigenshade_cli::accuracy_cost::setting::{Recipe, Setting, Way};
use eigenshade_cli::owned_basis::OwnedBasis;
use eigenshade_cli::shader::{OwnedNormals, Shader};
use eigenshade_index::material;
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use support::{Folder, assert_fails, repository};

/// The errors that the page's tables ask for.
const LIMITS: [f64; 7] = [0.1, 0.05, 0.01, 3e-3, 1e-3, 1e-4, 1e-5];
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
    let truth = |image: &Image, normal: [f64; 3]| {
        let light = oracle::ExplicitLight::new(&image.light);
        let terms: Vec<_> = material::indices(order)
            .zip(&image.material)
            .map(|((o, p, q), b)| (o, p, q, *b))
            .collect();
        oracle::irradiance(&light, &terms, normal)
    };
    for image in &images.images {
        for k in (0..images.normals.len()).step_by(97) {
            let apart = (image.truth[k] - truth(image, images.normals[k])).abs();
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
            let truths = normals.iter().map(|&normal| truth(image, normal));
            let square: f64 =
                shaded.iter().zip(truths).map(|(&a, b)| (f64::from(a) - b).powi(2)).sum();
            (square / normals.len() as f64).sqrt() / image.peak
        };
        images.images.iter().filter(|image| image.seen == seen).map(of).collect::<Vec<f64>>()
    };
    let (seen, unseen) = (errors(true), errors(false));
    let most = |errors: &[f64]| errors.iter().copied().fold(0.0, f64::max);
    let near = |a: f64, b: f64| (a / b - 1.0).abs() <= tolerances::COST_NORMALS;
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
    assert!(found.seen.largest.worst < tolerances::COST_ROUNDING, "{found:?}");
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

/// The part of the page below a title.
fn section<'a>(page: &'a str, title: &str) -> &'a str {
    let start = page.find(&format!("\n## {title}\n")).unwrap_or_else(|| panic!("no {title}"));
    let rest = &page[start + 4..];
    rest.find("\n## ").map_or(rest, |end| &rest[..end])
}

/// Tables of a part of the page, by row.
fn tables(text: &str) -> Vec<Vec<Vec<String>>> {
    let mut tables: Vec<Vec<Vec<String>>> = Vec::new();
    let mut inside = false;
    for line in text.lines() {
        if !line.starts_with("| ") {
            inside = false;
            continue;
        }
        if !inside {
            tables.push(Vec::new());
            inside = true;
        }
        let fields = line.trim_matches('|').split(" | ").map(|field| field.trim().to_owned());
        tables.last_mut().expect("a table").push(fields.collect());
    }
    tables
}

/// A number of the page: grouped, or in per cent.
fn stated(text: &str) -> f64 {
    let (text, scale) = text.strip_suffix(" %").map_or((text, 1.0), |text| (text, 0.01));
    scale * text.replace(',', "").parse::<f64>().unwrap_or_else(|_| panic!("{text}"))
}

/// Each row of the page's tables is in the file, its error is below the limit, and nothing in
/// the file does it for less.
#[test]
fn the_page_takes_the_cheapest_that_suffices() {
    let (page, rows) = (read("accuracy-cost.md"), sheet("accuracy-cost.csv"));
    let mut checked = 0;
    for (title, key) in MACHINES {
        for (number_of_table, table) in tables(section(&page, title)).iter().enumerate() {
            assert_eq!(table.len(), 2 + LIMITS.len(), "{title}");
            for (fields, limit) in table[2..].iter().zip(LIMITS) {
                assert!((stated(&fields[0]) / limit - 1.0).abs() < 1e-9, "{title}: {fields:?}");
                let frame = |row: &HashMap<String, String>| {
                    let pixels = 9216.0 * number(row, &format!("{key}_pixel"))?;
                    match number_of_table {
                        0 => Some(pixels),
                        _ => Some(pixels + number(row, &format!("{key}_light"))?),
                    }
                };
                let suffices = |row: &&HashMap<String, String>| {
                    let of_paper = row["degree"] == "9" && row["order"] == "7";
                    let modelled = number(row, "model_median").is_some_and(|one| one <= limit);
                    let error = number(row, "rms_median").expect("an error");
                    row["knob"] != "mathematics" && error <= limit && (of_paper || modelled)
                };
                let able = rows.iter().filter(suffices);
                let costs = able.filter_map(|row| frame(row).map(|cost| (cost, row)));
                let least = costs.min_by(|a, b| a.0.total_cmp(&b.0));
                let Some((cost, _)) = least else {
                    assert_eq!(fields[2], "—", "{title}: {fields:?}");
                    continue;
                };
                // The file has four digits, the page two of errors.
                let near = |a: f64, b: f64| (a / b - 1.0).abs() <= tolerances::STATED;
                assert!((stated(&fields[8]) / cost - 1.0).abs() < 1e-3, "{title}: {fields:?}");
                let holds = rows.iter().filter(suffices).any(|row| {
                    frame(row).is_some_and(|other| (other / cost - 1.0).abs() < 1e-3)
                        && near(stated(&fields[2]), number(row, "rms_median").expect("one"))
                        && near(stated(&fields[3]), number(row, "rms_worst").expect("one"))
                        && number(row, "table_bytes") == Some(stated(&fields[9]))
                });
                assert!(holds, "{title}: {fields:?}");
                assert!(stated(&fields[2]) <= limit * (1.0 + tolerances::STATED));
                checked += 1;
            }
        }
    }
    assert!(checked > 30, "{checked}");
}

/// What a reader does who has the page alone: a Cortex-M4F at 60 pictures of 96 x 96 pixels
/// with an error below one per cent.
#[test]
fn a_reader_finds_a_setting_for_a_board() {
    let page = read("accuracy-cost.md");
    let tables = tables(section(&page, "Cortex-M4F"));
    assert_eq!(tables.len(), 2);
    let minute = section(&page, "In a minute");
    assert!(minute.contains("1,066,667"));
    for (table, moves) in tables.iter().zip([false, true]) {
        let header = table[0].join(" ");
        assert!(header.contains("instructions") && header.contains("96 x 96 pixels"));
        let row = table.iter().find(|row| row[0] == "1 %").expect("a row");
        let (instructions, error) = (stated(&row[8]), stated(&row[2]));
        assert!(instructions <= 64e6 / 60.0 && error <= 0.01, "{row:?}");
        let light = if moves { stated(&row[7]) } else { 0.0 };
        assert_eq!(instructions, 9216.0 * stated(&row[6]) + light, "{row:?}");
        let share =
            format!("{}: {:.0} % of the cycles", row[8], 100.0 * instructions * 60.0 / 64e6);
        assert!(minute.contains(&row[1]) && minute.contains(&share), "{share}: {minute}");
    }
}

/// Every board has an answer for light that changes with every picture, and says what the
/// program takes.
#[test]
fn boards_have_rows_for_moving_light() {
    let page = read("accuracy-cost.md");
    for (title, _) in &MACHINES[1..5] {
        let table = &tables(section(&page, title))[1];
        assert_eq!(table[0][11..], ["program: flash", "RAM and stack"], "{title}");
        for row in &table[2..] {
            let is_there = row[7] != "—";
            assert!(is_there || row[0] == "1e-5", "{title}: {row:?}");
            if is_there {
                let [light, flash, ram] = [7, 11, 12].map(|column| stated(&row[column]));
                assert!(light > 100.0 && flash > 1e4 && ram > 300.0, "{title}: {row:?}");
            }
        }
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
            row["quantity"] == quantity && row["measure"] == measure
        };
        let points: Vec<(f64, f64)> = rows
            .iter()
            .filter(of)
            .map(|row| (number(row, "size").unwrap().ln(), number(row, "bytes").unwrap().ln()))
            .collect();
        assert!(points.len() >= 4, "{quantity}, {measure}");
        // From the middle to the end.
        let (first, last) = (points[points.len() / 2], points[points.len() - 1]);
        let slope = (last.1 - first.1) / (last.0 - first.0);
        assert!(
            (slope - expected).abs() <= tolerances::COST_EXPONENT,
            "{quantity}, {measure}: {slope}"
        );
    }
}

/// No words of a chart lie upon others, and all are within it.
#[test]
fn words_of_charts_keep_apart() {
    let attribute = |line: &str, name: &str| -> Option<f64> {
        line.split(&format!(" {name}=\"")).nth(1)?.split('"').next()?.parse().ok()
    };
    let mut seen = 0;
    for (_, key) in MACHINES {
        let svg = read(&format!("{key}.svg"));
        let mut frames: Vec<([f64; 4], String)> = Vec::new();
        let mut lines = svg.lines();
        while let Some(line) = lines.next() {
            if !line.starts_with("<text") || line.contains("rotate") {
                continue;
            }
            let word = lines.next().unwrap_or_default().to_owned();
            let (x, y) = (attribute(line, "x").unwrap(), attribute(line, "y").unwrap());
            let (size, width) = (15.3, 0.5 * 15.3 * word.chars().count() as f64);
            let left = match line {
                line if line.contains("\"middle\"") => x - 0.5 * width,
                line if line.contains("\"end\"") => x - width,
                _ => x,
            };
            assert!(left > -2.0 && left + width < 730.0, "{key}: {word}");
            let frame = [left, y - 0.5 * size, left + width, y + 0.5 * size];
            for ([a, b, c, d], other) in &frames {
                let [e, f, g, h] = frame;
                let meet = *a < g && e < *c && *b < h - 4.0 && f + 4.0 < *d;
                assert!(!meet, "{key}: `{word}` upon `{other}`");
            }
            frames.push((frame, word));
            seen += 1;
        }
    }
    assert!(seen > 60, "{seen}");
}

#[test]
fn all_that_the_page_shows_is_there_and_signed() {
    let page = read("accuracy-cost.md");
    let links = page.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    for link in links.filter(|link| !link.starts_with('#')) {
        assert!(docs().join(link).is_file(), "{link}");
    }
    for entry in fs::read_dir(docs()).expect("a folder") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        assert!(name == "accuracy-cost.md" || page.contains(&name), "{name}");
        let first = read(&name).lines().next().unwrap_or_default().to_owned();
        assert!(first.contains("eigenshade accuracy-cost"), "{name}");
    }
}

/// What is compared is told with its line; times are not compared.
#[test]
fn damage_is_found() {
    assert_eq!(
        [check::ERROR, check::ROUNDING, check::BYTES, check::EXPONENT],
        [
            tolerances::COST_ERROR,
            tolerances::COST_ROUNDING,
            tolerances::COST_BYTES,
            tolerances::COST_EXPONENT
        ]
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
    let renamed = good.replacen("rms_worst", "rms_most", 1);
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
    assert!(start.elapsed().as_secs() < 5);
    assert!(Path::new(&folder.path("docs/accuracy-cost.csv")).exists());
}

/// The README's tables are the page's.
#[test]
fn the_readme_has_the_pages_rows() {
    let readme = fs::read_to_string(repository().join("README.md")).expect("a README");
    let start = readme.find("<!-- accuracy:").expect("the mark");
    let end = readme.find("<!-- end of accuracy -->").expect("the other");
    let page = read("accuracy-cost.md");
    let rows: Vec<&str> = readme[start..end].lines().filter(|line| line.starts_with('|')).collect();
    assert!(rows.len() >= 3 * (2 + LIMITS.len()), "{}", rows.len());
    for row in rows {
        assert!(page.lines().any(|line| line == row), "{row}");
    }
    let minute = "A Cortex-M4F of 64 MHz has";
    let of = |text: &str| {
        let line = text.lines().find(|line| line.starts_with(minute)).expect("the sentence");
        line.split(" ([").next().map(str::to_owned)
    };
    assert_eq!(of(&readme), of(&page));
}
