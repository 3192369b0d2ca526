//! The figures of `docs/reading.md`: what the command gives, and what they promise.

use crate::support::repository;
use experiments::reading::figures::{cells, compare, numbers};
use experiments::reading::report::{COMMAND, parts};
use experiments::{pages, tolerances};

/// The posterior mean on half a disc with noise, of the peak, median and worst: 5 to 8 %, 29 %.
const READ_HALF_NOISY: [f64; 2] = [0.085, 0.295];

/// The same without noise, by all components: 1.0 %, 9 %.
const READ_HALF_NOISELESS: [f64; 2] = [0.0105, 0.095];

/// Least squares there with noise: 40 % and more.
const READ_HALF_SQUARES: f64 = 0.4;

/// Least squares over the posterior mean there: a third at most is what "only the posterior mean is
/// of use" means.
const READ_STATISTICS: f64 = 3.0;

/// The scalar product on 64 pixels without noise: 2 to 3 %, worst images included.
const READ_PRODUCT: std::ops::Range<f64> = 0.02..0.04;

/// Least squares over the posterior mean on a whole disc with 1 % noise and all components: "they fit
/// the noise".
const READ_NOISE_FITTED: f64 = 20.0;

/// d of half a disc by 50 components: 17 % with noise, and 24 % without, for what they leave is not
/// white, as the posterior mean takes it to be.
const READ_NOT_WHITE: [f64; 2] = [0.175, 0.235];

/// The light to degree 2 at 1 % noise, median: 14 %, and 8 % of a known material.
const READ_LIGHT: [f64; 2] = [0.145, 0.085];

/// The same from the product in the posterior modes: a third.
const READ_LIGHT_BY_PRODUCT: f64 = 0.34;

/// The light to degree 2 from the product in the least-norm modes, the least median: 0.73, most of it is
/// lost.
const READ_LEAST_NORM: f64 = 0.725;

/// All components and noise of 1 and 5 %: the least squares' median image is off by so many times the posterior
/// mean's and more, 1.4 and 1.7.
const READ_SHRUNK_MEDIAN: f64 = 1.3;

/// The posterior mean's worst image over the least squares' at 1 and 5 %: 2.2 and 1.4 times.
const READ_SHRUNK_WORST: [std::ops::Range<f64>; 2] = [2.0..2.5, 1.3..1.6];

/// Least squares of 218 components on a disc of 64 pixels, of the noise: √(218 / 3000) is 0.27; 0.26 to 0.29.
const READ_QUARTER: [f64; 2] = [0.24, 0.31];

#[test]
fn committed_figures_are_what_the_command_gives() {
    let committed = std::fs::read_to_string(repository().join("docs/reading.md")).expect("a text");
    let parts = parts(&repository().join("tables")).expect("figures");
    let now = pages::with_parts(&committed, &parts).expect("the page's markers");
    assert_eq!(cells(&now).len(), 48);
    assert_eq!(compare(&committed, &now), Ok(()), "make it again: {COMMAND}");
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
                        READ_STATISTICS * posterior < *squares,
                        "{components} {name}: {cells:?}"
                    );
                }
            }
            assert_below(&cells[5], READ_HALF_NOISY);
            assert!(cells[4][0] > READ_HALF_SQUARES, "{cells:?}");
        }
    }
    let noiseless = row(0, "218", "half hidden");
    assert_below(&noiseless[5], READ_HALF_NOISELESS);
    for components in ["50", "218"] {
        let product = &row(0, components, "as it is")[3];
        assert!(product.iter().all(|error| READ_PRODUCT.contains(error)), "{product:?}");
    }
    // Least squares and posterior mean on a whole disc.
    let few = row(0, "50", "noise 1 %");
    assert!((few[1][0] / few[2][0]).ln().abs() < tolerances::REPORT, "{few:?}");
    let all = row(0, "218", "noise 1 %");
    assert!(READ_NOISE_FITTED * all[2][0] < all[1][0], "{all:?}");
    // With all components and noise the median image is better by the posterior mean, the
    // worst by least squares; with 50 the medians are alike.
    let noises = [("noise 1 %", 0.01), ("noise 5 %", 0.05)];
    for ((name, noise), bounds) in noises.into_iter().zip(READ_SHRUNK_WORST) {
        let cells = row(0, "218", name);
        let (squares, posterior) = (&cells[4], &cells[5]);
        assert!(READ_SHRUNK_MEDIAN * posterior[0] < squares[0], "{name}: {cells:?}");
        assert!(bounds.contains(&(posterior[1] / squares[1])), "{name}: {cells:?}");
        let quarter = READ_QUARTER.map(|share| share * noise);
        assert!(squares.iter().all(|e| (quarter[0]..quarter[1]).contains(e)), "{name}: {cells:?}");
    }
    // What 50 components leave is not white.
    let [none, some] = ["half hidden", "half hidden, noise 1 %"].map(|name| row(0, "50", name));
    let [white, not_white] = READ_NOT_WHITE;
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
    assert_below(&[noisy[2][0], noisy[4][0]], READ_LIGHT);
    assert!(noisy[6][0] < READ_LIGHT_BY_PRODUCT, "{noisy:?}");
    for row in &committed[24..] {
        assert!(numbers(&row[9])[0] >= READ_LEAST_NORM, "{row:?}");
    }
}
