//! The files of `report accuracy-cost`: what they hold, and the checks that find differences.

use super::{docs, rows};
use crate::support::{Folder, assert_fails};
use report::accuracy_cost::scope::modelled;
use report::accuracy_cost::sheet::{MODEL, SETTINGS, compare};
use report::accuracy_cost::{Measured, settings};
use std::fs;

fn read(name: &str) -> String {
    fs::read_to_string(docs().join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// The file has the settings of the list, in its order.
#[test]
fn the_file_has_all_settings() {
    let rows = rows(&SETTINGS);
    let found: Vec<_> =
        rows.iter().map(|row| (row.text("parameter"), row.text("setting").to_owned())).collect();
    let all = settings::all(false);
    let all: Vec<_> = all.iter().map(|one| (one.parameter, one.setting.to_string())).collect();
    assert_eq!(found, all);
}

/// Each surface is there at every degree and order, and seven of them are measured.
#[test]
fn the_model_has_all_surfaces() {
    let rows = rows(&MODEL);
    let surfaces = modelled().expect("surfaces");
    assert_eq!(surfaces.len(), 13);
    for surface in &surfaces {
        let found = rows.iter().filter(|row| row.text("surface") == surface.name).count();
        assert_eq!(found, settings::sizes().count(), "{}", surface.name);
    }
    assert_eq!(rows.len(), surfaces.len() * settings::sizes().count());
}

/// `--keep-times` takes over all times of the files and nothing else.
#[test]
fn kept_times_are_those_of_the_files() {
    let earlier = Measured::read(&docs()).expect("the files");
    let mut measured = earlier.clone();
    for row in &mut measured.settings {
        let columns = ["host_pixel_ns", "host_light_ns", "host_pixel", "host_light"];
        columns.into_iter().for_each(|column| row.put(column, ""));
    }
    let mut other = earlier.clone();
    other.settings.iter_mut().for_each(|row| row.put("rms_median", 7));
    measured.keep_times(&other).expect("all times");
    assert_eq!(measured.settings, earlier.settings);
    measured.settings[0].put("setting", "9/7 K51 polynomial f32");
    assert!(measured.keep_times(&earlier).is_err());
    let folder = Folder::new();
    fs::create_dir(folder.path("docs")).unwrap();
    assert_fails(&folder, "accuracy-cost --out docs --keep-times", &["docs/accuracy-cost.csv"]);
    assert_eq!(folder.run("accuracy-cost --check docs --keep-times").status.code(), Some(2));
}

/// A difference is reported with its line; times are not compared.
#[test]
fn damage_is_found() {
    let folder = Folder::new();
    let name = "accuracy-cost.csv";
    let good = read(name);
    let fresh = rows(&SETTINGS);
    let compared = |text: &str| {
        folder.write(name, text);
        compare(&SETTINGS, &fresh, &folder.path("."), true).map_err(|error| error.to_string())
    };
    let [rows, numbers] = compared(&good).expect("nothing is damaged");
    assert!(rows > 100 && numbers > 1500, "{rows} {numbers}");
    let lines: Vec<&str> = good.lines().collect();
    let header: Vec<&str> = lines[1].split(',').collect();
    let find = |name: &str| lines.iter().position(|line| line.contains(name)).unwrap();
    let (place, exact) = (find("9/7 K50 polynomial f32,"), find("9/7 all polynomial f64,"));
    let changed_at = |place: usize, column: &str, to: &dyn Fn(f64) -> f64| {
        let mut fields: Vec<String> = lines[place].split(',').map(str::to_owned).collect();
        let at = header.iter().position(|name| *name == column).unwrap();
        let old: f64 = fields[at].parse().unwrap_or_else(|_| panic!("{column}"));
        fields[at] = to(old).to_string();
        good.replacen(lines[place], &fields.join(","), 1)
    };
    let changed = |column: &str, to: &dyn Fn(f64) -> f64| changed_at(place, column, to);
    for column in ["host_pixel_ns", "host_light_ns", "host_pixel"] {
        compared(&changed(column, &|time| 3.0 * time)).expect("times are not compared");
    }
    for column in ["rms_median", "table_bytes"] {
        compared(&changed(column, &|value| 1.019 * value)).expect("within the tolerance");
    }
    for (column, factor) in [
        ("rms_median", 1.022),
        ("rms_worst", 0.97),
        ("unseen_rms_most", 1.1),
        ("unseen_largest_worst", 1.1),
        ("model_median", 1.1),
        ("total_mean_most", 1.1),
        ("total_p95_median", 1.1),
        ("table_bytes", 1.022),
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
    // Errors may always differ by rounding. The setting in f64 has the smallest.
    let off = |by: f64| compared(&changed_at(exact, "rms_median", &|old| old + by));
    assert!(off(0.9e-6).is_ok() && off(1.1e-6).is_err());
    let without = good.replacen(&format!("{}\n", lines[place]), "", 1);
    assert!(compared(&without).expect_err("a row").contains("no row of `9/7 K50 polynomial f32`"));
    let twice = format!("{good}{}\n", lines[place].replace("K50", "K51"));
    assert!(compared(&twice).expect_err("a row").contains("rows where"));
    let renamed = good.replacen("rms_worst", "rms_largest", 1);
    assert!(compared(&renamed).expect_err("a header").contains("rms_worst"));
    compared(&good).expect("all is whole again");
}

/// A run without times is compared with the committed files.
#[test]
fn a_run_without_times_is_compared_whole() {
    let mut untimed = Measured::read(&docs()).expect("the files");
    untimed.settings.iter_mut().for_each(|row| row.put("host_pixel", ""));
    let compared = untimed.sheets().map(|(form, rows)| compare(form, rows, &docs(), true));
    let rows = compared.map(|one| one.unwrap_or_else(|error| panic!("{error}"))[0]);
    assert!(rows.iter().sum::<usize>() > 300, "{rows:?}");
    let short = &untimed.model[..18];
    let error = compare(&MODEL, short, &docs(), true).expect_err("missing rows");
    assert!(error.to_string().contains("rows where 18 belong"), "{error}");
    compare(&MODEL, short, &docs(), false).expect("a quick run has fewer rows");
}

#[test]
fn bad_folders_fail_before_the_work() {
    let folder = Folder::new();
    folder.write("file", "");
    assert_fails(&folder, "accuracy-cost --out file", &["file"]);
    assert_fails(&folder, "accuracy-cost --check nowhere", &["nowhere", "accuracy-cost.csv"]);
    for usage in ["", "--out a --check b"] {
        let status = folder.run(&format!("accuracy-cost {usage}")).status;
        assert_eq!(status.code(), Some(2), "{usage}");
    }
    fs::create_dir(folder.path("docs")).unwrap();
    folder.write("docs/accuracy-cost.csv", "");
    let missing = &["esplanade.exr", "no such map", "--maps"];
    assert_fails(&folder, "accuracy-cost --check docs --maps nowhere", missing);
}
