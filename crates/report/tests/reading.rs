//! The conclusions of `docs/reading.md` hold for its figures, which `reading --check docs` reproduces.

use crate::support::repository;
use crate::tolerances::REPORT;
use report::sheet::{Record, Sheet};
use std::collections::HashMap;
use std::ops::Range;

/// The numbers in the cells of each row, by table (estimates or scenes), components and image. Each
/// cell has a median and a worst error; the first two of a row of scenes are ranks.
struct Tables([HashMap<String, Vec<[f64; 2]>>; 2]);

impl Tables {
    fn recorded() -> Self {
        let tables = Self(["estimates", "scenes"].map(|name| {
            let path = repository().join(format!("docs/reading-{name}.csv"));
            let sheet = Sheet::read(&path).expect("a CSV");
            let pair = |cell: &str| {
                let mut numbers = cell.split([',', ' ']).filter_map(|word| word.parse().ok());
                let first = numbers.next().unwrap_or(f64::NAN);
                [first, numbers.next_back().unwrap_or(first)]
            };
            let row = |row: &Record| {
                let name = ["components", "image"].map(|one| row.text(one)).join(" ");
                (name, sheet.columns[2..].iter().map(|one| pair(row.text(one))).collect())
            };
            sheet.rows.iter().map(row).collect()
        }));
        assert_eq!(tables.0.each_ref().map(HashMap::len), [24, 24]);
        tables
    }

    /// The errors by scalar product, least squares and posterior mean: of d, then of the image.
    fn errors(&self, name: &str) -> [[[f64; 2]; 3]; 2] {
        let row = &self.0[0][name];
        [&row[..3], &row[3..]].map(|cells| cells.try_into().expect("three methods"))
    }
}

/// On half a disc with noise the posterior mean is at least three times better than least squares,
/// of d and of the hidden image, in the median and at worst.
#[test]
fn only_the_posterior_mean_completes_a_noisy_half() {
    let tables = Tables::recorded();
    for components in ["50", "218"] {
        for image in
            ["half hidden, noise 1 %", "half hidden, noise 5 %", "unknown, half hidden, noise 1 %"]
        {
            let name = format!("{components} {image}");
            for [_, squares, posterior] in tables.errors(&name) {
                for (squares, posterior) in squares.iter().zip(posterior) {
                    assert!(3.0 * posterior < *squares, "{name}: {posterior} {squares}");
                }
            }
            // 5 to 8 % of the peak, 29 % at worst; least squares 50 % and more.
            let [_, [_, squares, [median, worst]]] = tables.errors(&name);
            assert!(median < 0.085 && worst < 0.295, "{name}: {median} {worst}");
            assert!(squares[0] >= 0.495, "{name}: {squares:?}");
        }
    }
    // Without noise, least squares: 38 % with 50 components and 19 % with all.
    for (name, expected) in [("50 half hidden", 0.375..0.385), ("218 half hidden", 0.185..0.195)] {
        let [_, [_, squares, _]] = tables.errors(name);
        assert!(expected.contains(&squares[0]), "{name}: {squares:?}");
    }
    // Without noise, all components: 1.0 %, 9 % at worst.
    let [_, [.., [median, worst]]] = tables.errors("218 half hidden");
    assert!(median < 0.0105 && worst < 0.095, "{median} {worst}");
    // d of 50 components: 17 % with noise, 24 % without, because the omitted ones are not white.
    let [[.., [noiseless, _]], _] = tables.errors("50 half hidden");
    let [[.., [noisy, _]], _] = tables.errors("50 half hidden, noise 1 %");
    assert!(noiseless >= 0.235 && noisy < 0.175, "{noiseless} {noisy}");
}

#[test]
fn on_a_whole_disc_statistics_help_all_components() {
    let tables = Tables::recorded();
    for components in ["50", "218"] {
        // 2 to 3 % of the peak by the scalar product, worst images included.
        let [_, [product, ..]] = tables.errors(&format!("{components} as it is"));
        assert!(product.iter().all(|error| (0.02..0.04).contains(error)), "{product:?}");
    }
    let [[_, squares, posterior], _] = tables.errors("50 noise 1 %");
    assert!((squares[0] / posterior[0]).ln().abs() < REPORT, "{squares:?} {posterior:?}");
    // Least squares fit the noise.
    let [[_, squares, posterior], _] = tables.errors("218 noise 1 %");
    assert!(20.0 * posterior[0] < squares[0], "{squares:?} {posterior:?}");
    // The posterior mean's median image is better by 1.4 and 1.7, its worst is 2.2 and 1.4 times
    // that of least squares.
    let noises: [(&str, f64, Range<f64>); 2] =
        [("218 noise 1 %", 0.01, 2.0..2.5), ("218 noise 5 %", 0.05, 1.3..1.6)];
    for (name, noise, worst) in noises {
        let [_, [_, squares, posterior]] = tables.errors(name);
        assert!(1.3 * posterior[0] < squares[0], "{name}: {squares:?} {posterior:?}");
        assert!(worst.contains(&(posterior[1] / squares[1])), "{name}: {squares:?} {posterior:?}");
        // √(218 / 3000) = 0.27 of the noise; 0.26 to 0.29.
        let quarter = 0.24 * noise..0.31 * noise;
        assert!(squares.iter().all(|error| quarter.contains(error)), "{name}: {squares:?}");
    }
}

/// The number of images whose material is found, of 28.
#[test]
fn materials_are_found_if_the_noise_is_small() {
    let tables = Tables::recorded();
    for (name, first) in [
        ("218 as it is", 28.0),
        ("218 8 bits, linear", 28.0),
        ("218 8 bits, sRGB", 28.0),
        ("218 clipped, left out", 28.0),
        ("218 half hidden", 28.0),
        ("218 noise 1 %", 23.0),
        ("218 half hidden, noise 1 %", 16.0),
        ("218 clipped, kept", 3.0),
        ("50 as it is", 17.0),
    ] {
        assert_eq!(tables.0[1][name][0], [first, 28.0], "{name}");
    }
}

/// Medians of the light to degree 2.
#[test]
fn the_light_is_found_to_degree_two() {
    let tables = Tables::recorded();
    // 14 %, 8 % if the material is known, and a third from the product in the posterior modes.
    let noisy = &tables.0[1]["218 noise 1 %"];
    for (cell, bound) in [(2, 0.145), (4, 0.085), (6, 0.34)] {
        assert!(noisy[cell][0] < bound, "{cell}: {noisy:?}");
    }
    // Most of it is lost in the least-norm modes: 73 % at least.
    for (name, row) in &tables.0[1] {
        assert!(row[7][0] >= 0.725, "{name}: {row:?}");
    }
}
