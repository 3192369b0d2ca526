//! Pictures from palettes: the recorded errors are found again, and bounds that pages state.

use eigenshade_testing::fixtures::ROOT;
use indicatif::ProgressBar;
use report::palette_errors;
use report::sheet::Sheet;
use std::collections::BTreeMap;
use std::path::Path;

fn recorded() -> Sheet {
    Sheet::read(&Path::new(ROOT).join("docs/palette.csv")).unwrap()
}

/// The columns of a row with numbers, in order.
const NUMBERS: [&str; 7] = [
    "rgb565_mean",
    "rgb565_p95",
    "palette_mean",
    "palette_p95",
    "palette565_mean",
    "palette565_p95",
    "palette_worst",
];

#[test]
fn recorded_errors_are_found_again() {
    let sheet = recorded();
    let names = sheet.texts("material").into_iter().zip(sheet.texts("light"));
    let numbers = NUMBERS.map(|column| sheet.numbers(column));
    let recorded: BTreeMap<_, _> =
        names.enumerate().map(|(k, name)| (name, numbers.each_ref().map(|of| of[k]))).collect();
    let chosen = ["gold-metallic-paint", "pink-felt", "brass"];
    let found = palette_errors::errors(&chosen, &ProgressBar::hidden()).unwrap();
    assert_eq!(found.len(), chosen.len() * palette_errors::LIGHTS.len());
    for row in found {
        let fields = row.fields();
        let recorded = recorded[&(fields[0].as_str(), fields[1].as_str())];
        for (found, recorded) in fields[2..].iter().zip(recorded) {
            let found: f64 = found.parse().unwrap();
            // Floats differ between machines at the edge of a level.
            assert!((found - recorded).abs() <= 0.02 * recorded + 0.01, "{fields:?}");
        }
    }
}

#[test]
fn a_palette_adds_a_quarter_of_what_rounding_does() {
    let sheet = recorded();
    let median = |column: &str| {
        let mut numbers = sheet.numbers(column);
        numbers.sort_by(f64::total_cmp);
        numbers[numbers.len() / 2]
    };
    let medians = NUMBERS.map(median);
    let stated = [1.48, 3.01, 0.361, 0.738, 1.7, 3.24];
    for (found, stated) in medians.into_iter().zip(stated) {
        assert!((found - stated).abs() <= 0.05 * stated, "{found} {stated}");
    }
    let largest = |column: &str| sheet.numbers(column).into_iter().fold(0.0, f64::max);
    assert!(largest("palette_mean") < 5.0 && largest("palette_p95") < 17.5);
    // One picture in five is off by more than 1, and one in four beyond 2 in 5 of 100 pixels.
    let above = |column: &str, least: f64| {
        let numbers = sheet.numbers(column);
        numbers.iter().filter(|&&one| one > least).count() as f64 / numbers.len() as f64
    };
    assert!(above("palette_mean", 1.0) < 0.22 && above("palette_p95", 2.0) < 0.26);
}
