//! Blended roughnesses: the shipped weights are the fitted ones, and how far pictures are off under
//! lights that the fit did not see.

use eigenshade_model::shipped;
use eigenshade_shading::textured::Weights;
use report::roughness_weights::{ROWS, errors, fitted, pictures};

/// The weights of another processor.
const FITTED: f64 = 1e-3;

/// The rms error over the picture's own peak, in the median picture, of the worst roughness.
const MEDIAN: f64 = 0.002;

/// The same of one picture in twenty.
const ONE_IN_TWENTY: f64 = 0.005;

#[test]
fn weights_are_those_of_the_fit() {
    let table = eigenshade_table::decode(shipped::PBR).expect("a table");
    let expected = fitted(&pictures(&table, false).expect("pictures"));
    let found = shipped::roughness_weights().expect("weights");
    assert_eq!(found.len(), ROWS);
    for (found, expected) in found.iter().flatten().zip(expected.iter().flatten()) {
        assert!((found - expected).abs() < FITTED, "{found} {expected}");
    }
}

#[test]
fn blends_are_near_under_other_lights() {
    for (name, table) in [("pbr", shipped::PBR), ("sphere", shipped::TABLE)] {
        let table = eigenshade_table::decode(table).expect("a table");
        let pictures = pictures(&table, true).expect("pictures");
        let weights = Weights::shipped().expect("weights");
        let (mut median, mut twentieth) = (0.0_f64, 0.0_f64);
        for row in 0..ROWS {
            let mut errors = errors(&pictures, &weights, row);
            errors.sort_by(f64::total_cmp);
            median = median.max(errors[errors.len() / 2]);
            twentieth = twentieth.max(errors[errors.len() * 19 / 20]);
        }
        println!("{name}: median {median:.5}, one in twenty {twentieth:.5}");
        assert!(median < MEDIAN && twentieth < ONE_IN_TWENTY, "{name}: {median} {twentieth}");
    }
}
