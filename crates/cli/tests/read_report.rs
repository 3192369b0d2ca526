//! The figures of `docs/reading.md`: what the command gives, and what they promise.

use crate::tolerances;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What has no error but rounding, where all components are there.
const EXACT: [&str; 3] = ["as it is", "clipped, left out", "half hidden"];

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// Cells of every row of the tables with figures.
fn cells(text: &str) -> Vec<Vec<String>> {
    let row = |line: &str| -> Vec<String> {
        line.trim_matches('|').split('|').map(|cell| cell.trim().to_owned()).collect()
    };
    text.lines()
        .filter(|line| line.starts_with("| 50 |") || line.starts_with("| 218 |"))
        .map(row)
        .collect()
}

/// The numbers of a cell, `median, worst` or `first of all`.
fn numbers(cell: &str) -> Vec<f64> {
    cell.split([',', ' ']).filter_map(|word| word.parse().ok()).collect()
}

#[test]
fn committed_figures_are_what_the_command_gives() {
    let output = Command::new(env!("CARGO_BIN_EXE_eigenshade"))
        .current_dir(repository())
        .arg("read-report")
        .output()
        .expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let fresh = String::from_utf8(output.stdout).expect("text");
    let committed = std::fs::read_to_string(repository().join("docs/reading.md")).expect("a text");
    let prose = |text: &str| -> Vec<String> {
        text.lines().filter(|line| !line.starts_with('|')).map(str::to_owned).collect()
    };
    let remedy = "make it again: eigenshade read-report --out docs/reading.md";
    assert_eq!(prose(&fresh), prose(&committed), "{remedy}");
    let [fresh, committed] = [cells(&fresh), cells(&committed)];
    assert_eq!(fresh.len(), 48);
    assert_eq!(fresh.len(), committed.len(), "{remedy}");
    for (fresh, committed) in fresh.iter().zip(&committed) {
        assert_eq!(fresh[..2], committed[..2], "{remedy}");
        let is_exact = committed[0] == "218" && EXACT.contains(&committed[1].as_str());
        for (a, b) in fresh.iter().zip(committed).skip(2) {
            let (a, b) = (numbers(a), numbers(b));
            assert_eq!(a.len(), b.len(), "{remedy}");
            for (a, b) in a.iter().zip(&b) {
                let allowed =
                    if is_exact { tolerances::REPORT_ROUNDING } else { tolerances::REPORT };
                let far = (a / b).ln().abs();
                // Counts may be off by one.
                let is_near = far <= allowed || (a.fract() == 0.0 && (a - b).abs() <= 1.0);
                assert!(is_near, "{a} for {b} in {committed:?}; {remedy}");
            }
        }
    }
}

/// What the text says is so in the figures that are committed.
#[test]
fn committed_figures_are_as_the_text_says() {
    let committed = std::fs::read_to_string(repository().join("docs/reading.md")).expect("a text");
    promises(&cells(&committed));
}

/// Both, the first below the first and the second below the second.
fn assert_below(found: &[f64], bounds: [f64; 2]) {
    assert!(found[0] < bounds[0] && found[1] < bounds[1], "{found:?} {bounds:?}");
}

/// What the text says of the figures.
fn promises(committed: &[Vec<String>]) {
    let row = |table: usize, components: &str, name: &str| -> Vec<Vec<f64>> {
        let rows = &committed[24 * table..24 * (table + 1)];
        let found = rows.iter().find(|row| row[0] == components && row[1] == name);
        found.expect("a row").iter().skip(2).map(|cell| numbers(cell)).collect()
    };
    // On half a disc with noise the posterior mean is better than least squares, of d
    // and of the hidden image, the median and the worst.
    for components in ["50", "218"] {
        for name in
            ["half hidden, noise 1 %", "half hidden, noise 5 %", "unknown, half hidden, noise 1 %"]
        {
            let cells = row(0, components, name);
            for (squares, posterior) in [(&cells[1], &cells[2]), (&cells[4], &cells[5])] {
                for (squares, posterior) in squares.iter().zip(posterior) {
                    assert!(
                        tolerances::READ_STATISTICS * posterior < *squares,
                        "{components} {name}: {cells:?}"
                    );
                }
            }
            assert_below(&cells[5], tolerances::READ_HALF_NOISY);
            assert!(cells[4][0] > tolerances::READ_HALF_SQUARES, "{cells:?}");
        }
    }
    let noiseless = row(0, "218", "half hidden");
    assert_below(&noiseless[5], tolerances::READ_HALF_NOISELESS);
    for components in ["50", "218"] {
        let product = &row(0, components, "as it is")[3];
        assert!(
            product.iter().all(|error| tolerances::READ_PRODUCT.contains(error)),
            "{product:?}"
        );
    }
    // Least squares and posterior mean on a whole disc.
    let few = row(0, "50", "noise 1 %");
    assert!((few[1][0] / few[2][0]).ln().abs() < tolerances::REPORT, "{few:?}");
    let all = row(0, "218", "noise 1 %");
    assert!(tolerances::READ_NOISE_FITTED * all[2][0] < all[1][0], "{all:?}");
    // With all components and noise the median image is better by the posterior mean, the
    // worst by least squares; with 50 the medians are alike.
    let noises = [("noise 1 %", 0.01), ("noise 5 %", 0.05)];
    for ((name, noise), bounds) in noises.into_iter().zip(tolerances::READ_SHRUNK_WORST) {
        let cells = row(0, "218", name);
        let (squares, posterior) = (&cells[4], &cells[5]);
        assert!(tolerances::READ_SHRUNK_MEDIAN * posterior[0] < squares[0], "{name}: {cells:?}");
        assert!(bounds.contains(&(posterior[1] / squares[1])), "{name}: {cells:?}");
        let quarter = tolerances::READ_QUARTER.map(|share| share * noise);
        assert!(squares.iter().all(|e| (quarter[0]..quarter[1]).contains(e)), "{name}: {cells:?}");
    }
    // What 50 components leave is not white.
    let [none, some] = ["half hidden", "half hidden, noise 1 %"].map(|name| row(0, "50", name));
    let [white, not_white] = tolerances::READ_NOT_WHITE;
    assert!(none[2][0] >= not_white && some[2][0] < white, "{none:?} {some:?}");
    // Without noise, or in 8 bits, all components tell every material apart.
    for name in ["as it is", "8 bits, linear", "8 bits, sRGB", "clipped, left out", "half hidden"] {
        assert_eq!(row(1, "218", name)[0], [28.0, 28.0], "{name}");
    }
    for (components, name, first) in [
        ("218", "noise 1 %", 23.0),
        ("218", "half hidden, noise 1 %", 16.0),
        ("218", "clipped, kept", 3.0),
        ("50", "as it is", 17.0),
    ] {
        assert_eq!(row(1, components, name)[0], [first, 28.0], "{components} {name}");
    }
    let noisy = row(1, "218", "noise 1 %");
    assert_below(&[noisy[2][0], noisy[4][0]], tolerances::READ_LIGHT);
    assert!(noisy[6][0] < tolerances::READ_LIGHT_BY_PRODUCT, "{noisy:?}");
    for row in &committed[24..] {
        assert!(numbers(&row[9])[0] >= tolerances::READ_LEAST_NORM, "{row:?}");
    }
}
