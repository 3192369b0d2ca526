//! Settings with light sources: their pictures, their errors and their costs.

use super::rows;
use eigenshade_model::highlights::{self, Highlights};
use eigenshade_model::shipped;
use eigenshade_model::source::Gloss;
use eigenshade_table::light::count;
use eigenshade_testing::fixtures::of_equal_areas;
use report::accuracy_cost::images::Shaded;
use report::accuracy_cost::machines::MACHINES;
use report::accuracy_cost::settings::{Format, Recipe, Setting};
use report::accuracy_cost::sheet::{SETTINGS, TOTAL};
use report::accuracy_cost::total::lamps::Lamps;
use report::sheet::{Counts, M0, M4F, Record};

/// In f32 against f64, of the peak, from a roughness of 0.3 on: as `Highlights::shade` states.
const OF_F32: f64 = 3e-6;
/// In integers of 17 bits, of the peak, off the rim: as `q15::Highlights::shade` states.
const OF_Q15: f64 = 4e-3;
/// A light without its sources in f32, of their energy: as `Rgb::residual` states.
const OF_REST: f64 = 1e-5;
/// Costs of four digits against a sum with one, relative: twice half of the last digit of 1,000.
const OF_COSTS: f64 = 1e-3;
/// A program with a pixel and two sources in one loop against the sum of both, relative.
const OF_SUM: f64 = 0.04;

/// An irradiance of 0.25 in each channel.
fn shaded(count: usize, exponent: i32) -> [Shaded; 3] {
    [0; 3].map(|_| Shaded { irradiances: vec![0.25; count], terms: 0, bytes: 0, exponent })
}

/// A picture is that of the rest of the light and the highlights of the sources taken out of it.
#[test]
fn lamps_are_the_sources_that_lights_lack() {
    let lights = shipped::lights().expect("the lights");
    let named = |name: &str| lights.entries.iter().find(|light| light.name == name).cloned();
    let lights = ["studio", "lobby"].map(|name| named(name).expect("a light"));
    let all = shipped::sources().expect("the sources");
    let mut normals = of_equal_areas(60);
    normals.retain(|[.., z]| *z > 0.1);
    let albedo = [0.2, 0.1, 0.3];
    let gloss =
        Gloss { roughness: 0.35, reflectance: [0.5, 0.4, 0.3], grazing: [1.0, 0.9, 0.8], albedo };
    for (k, light) in lights.iter().enumerate() {
        let of_light = all.iter().find(|sources| sources.name == light.name).expect("sources");
        let sources = of_light.first(4);
        assert!(sources.len() > 1, "{}", light.name);
        let setting = Setting { sources: 4, ..Setting::of(Recipe::all(9, 7)) };
        let lamps = Lamps::new(&setting, &lights, &all, &normals).expect("sources");
        for c in 0..3 {
            let mut whole = lamps.rest(k)[c].clone();
            assert_eq!(whole.len(), count(9));
            for source in sources {
                let blob = highlights::harmonics(source, 9);
                whole.iter_mut().zip(&blob).for_each(|(to, y)| *to += source.energy[c] * y);
            }
            let energy: f64 = sources.iter().map(|source| source.energy[c]).sum();
            for (whole, light) in whole.iter().zip(&light.rgb[c]) {
                let apart = (whole - light).abs();
                assert!(apart <= OF_REST * energy + 1e-6 * light.abs(), "{apart:e}");
            }
        }
        // In f64, on an irradiance of 0.25.
        let in_f64 = Highlights::new(&gloss, sources);
        let of = |&normal: &[f64; 3]| in_f64.irradiance(normal).map(|one| one + 0.25);
        let expected: Vec<[f64; 3]> = normals.iter().map(of).collect();
        let peak = expected.iter().flatten().fold(0.0, |most: f64, one| one.max(most));
        assert!(peak > 0.3, "{peak}");
        // 17 bits of the peak.
        let exponent = peak.log2().ceil() as i32 - 17;
        for (format, exponent, most) in [(Format::F32, 0, OF_F32), (Format::Q15, exponent, OF_Q15)]
        {
            let setting = setting.in_format(format);
            let lamps = Lamps::new(&setting, &lights, &all, &normals).expect("sources");
            let rest = shaded(normals.len(), exponent);
            let picture = lamps.add(k, &gloss, &rest).expect("a picture");
            for (j, expected) in expected.iter().enumerate() {
                for (channel, expected) in picture.iter().zip(expected) {
                    let apart = (channel[j] - expected).abs() / peak;
                    assert!(apart <= most, "{format} {:?}: {apart:e}", normals[j]);
                }
            }
        }
        let setting = setting.in_format(Format::F64);
        let lamps = Lamps::new(&setting, &lights, &all, &normals).expect("sources");
        assert!(lamps.add(k, &gloss, &shaded(normals.len(), 0)).is_err());
    }
}

fn of<'a>(rows: &'a [Record], setting: &str) -> &'a Record {
    let is_it = |row: &&Record| row.text("setting") == setting;
    rows.iter().find(is_it).unwrap_or_else(|| panic!("no row of {setting}"))
}

/// The settings with sources, and the same settings without.
fn pairs(rows: &[Record]) -> Vec<(&Record, &Record)> {
    let with =
        rows.iter().filter(|row| row.text("sources") != "0" && row.text("parameter") != "window");
    let pair = |row| {
        let name = Record::text(row, "setting");
        (row, of(rows, name.split_once(" sources").expect("a name with sources").0))
    };
    with.map(pair).collect()
}

/// The cost of sources is that of programs with them alone, and nearly of a program with both.
#[test]
fn costs_of_sources_are_added() {
    let (rows, counts) = (rows(&SETTINGS), Counts::recorded());
    let mut checked = 0;
    for (with, without) in pairs(&rows) {
        for machine in &MACHINES {
            for kind in ["pixel", "light"] {
                let [all, table] = [with, without].map(|row| machine.number(row, kind));
                let Some(board) = machine.board.filter(|_| table.is_some()) else {
                    // On this machine they were timed.
                    assert_eq!(all.is_some(), machine.key == "host", "{with:?}");
                    continue;
                };
                let operation = format!("sources/{kind}_{}", with.text("sources"));
                let sources = counts.get([board, with.text("format")], &operation, "instructions");
                let sum = table.zip(sources).map(|(table, sources)| table + sources as f64);
                assert_eq!(all.is_some(), sum.is_some(), "{with:?}");
                let near = |(all, sum): (f64, f64)| (all / sum - 1.0).abs() <= OF_COSTS;
                assert!(all.zip(sum).is_none_or(near), "{with:?}");
                checked += usize::from(all.is_some());
            }
        }
    }
    assert!(checked > 100, "{checked}");
    // Each source takes its time of a pixel: they are measured in one run.
    let of_host = |row: &Record| row.number("host_pixel_ns").expect("a time");
    for (with, _) in pairs(&rows).into_iter().filter(|(with, _)| with.text("sources") != "1") {
        let (name, count) = with.text("setting").split_once(" sources").expect("their number");
        let count: usize = count.parse().expect("a number");
        let half = of(&rows, &format!("{name} sources{}", count / 2));
        assert!(of_host(with) > of_host(half), "{with:?}");
    }
    for on in [M0, ["mps2-an386", "q15"], M4F] {
        let count = |operation| counts.get(on, operation, "instructions").expect("a count") as f64;
        let ratio = count("shade_highlights") / (count("shade") + count("sources/pixel_2"));
        println!("{on:?}: {ratio:.3}");
        assert!((ratio - 1.0).abs() <= OF_SUM, "{ratio}");
    }
}

/// Sources bring glTF and measured materials nearer and leave matte ones as they are.
#[test]
fn sources_bring_pictures_nearer() {
    let total = rows(&TOTAL);
    let most = |setting: &str, kind: &str| {
        let is_it = |row: &&Record| row.text("setting") == setting && row.text("kind") == kind;
        let row = total.iter().find(is_it).unwrap_or_else(|| panic!("{setting}, {kind}"));
        ["mean_median", "mean_most"].map(|column| row.number(column).expect("a number"))
    };
    for table in
        ["9/7 all polynomial f32", "12/12 K400 polynomial f32", "9/7 K130 trim2e-4 polynomial q15"]
    {
        let of =
            |kind| ["", " sources4", " sources8"].map(|one| most(&format!("{table}{one}"), kind));
        for kind in ["gltf", "measured", "all"] {
            let [none, four, eight] = of(kind);
            for k in 0..2 {
                assert!(four[k] < 0.95 * none[k] && eight[k] < four[k], "{table}, {kind}");
            }
        }
        let [none, four, _] = of("matte");
        assert_eq!(none, four, "{table}");
    }
    // With 4 sources, degree 9 and order 7 is as near as 12 and 12 without, and nearer in the worse.
    let [low, high] = ["9/7 all polynomial f32 sources4", "12/12 K400 polynomial f32"]
        .map(|one| most(one, "all"));
    assert!(low[0] <= 1.05 * high[0] && low[1] < 0.85 * high[1], "{low:?} {high:?}");
}
