//! Fits of materials: in range everywhere, and true to what was measured.

use crate::tolerances;
use eigenshade_generator::material::fit::{Fit, HIGHEST, LOWEST, fit, write_figures};
use eigenshade_generator::material::fit_constraints::DirectionGrid;
use eigenshade_generator::material::measurements::{Measured, Measurement, read};
use eigenshade_model::inputs::coefficient_csv::read_materials;
use eigenshade_model::scattering::{brdf, modes};
use eigenshade_table::material;
use faer::linalg::solvers::SolveLstsq;
use faer::{Col, Mat};
use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};
use std::path::PathBuf;

/// A BRDF in range and fully measured comes back, of its largest coefficient: the
/// small term of the fit moves the weakest by (1e-5 condition)².
const RECOVERED_MATERIAL: f64 = 2e-8;

/// Rms relative error of order 7 on the sintered PTFE of NIST: 1.07 % by NIST's
/// own coefficients, the rest is noise and order.
const PTFE_RELATIVE: f64 = 0.011;

/// Median |Xb - y| / |y| of the CUReT fits at order 7: 8.3 % when held in range.
const CURET_RESIDUAL: f64 = 0.09;

/// Residual of order 7 on a lobe of 20 degrees measured to 60: what the order cannot follow.
const LOBE_RESIDUAL: f64 = 0.03;

/// Residual of more coefficients than measurements: what holding the fit in range costs.
const FREE_RESIDUAL: f64 = 0.005;

fn path(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(name)
}

fn ptfe() -> Measured {
    read(path("tests/data/nist_ptfe/measurements_633.csv")).unwrap()
}

fn fit_one(measured: Measured, order: usize) -> Fit {
    let (materials, mut fits) = fit(&[measured], order, &mut |_, _| ()).unwrap();
    let fit = fits.pop().unwrap();
    assert_eq!(materials.order, order);
    assert_eq!(materials.entries, std::slice::from_ref(&fit.material));
    fit
}

/// A lattice of directions up to `rim`, with these values.
fn measured(rim: f64, steps: usize, value: impl Fn(f64, f64, f64) -> [f64; 3]) -> Measured {
    let angle = |step: usize| rim * step as f64 / steps as f64;
    let mut samples = Vec::new();
    for i in 0..=steps {
        for r in 0..=steps {
            for azimuth in 0..=12 {
                let delta_phi = PI * f64::from(azimuth) / 12.0;
                let (theta_i, theta_r) = (angle(i), angle(r));
                samples.push(Measurement {
                    theta_i,
                    theta_r,
                    delta_phi,
                    rgb: value(theta_i, theta_r, delta_phi),
                });
            }
        }
    }
    Measured { name: "made".into(), samples }
}

/// √mean(((model - value) / value)²).
fn rms_relative(measured: &Measured, order: usize, coefficients: &[f64]) -> f64 {
    let squares = measured.samples.iter().map(|s| {
        let model = brdf(order, coefficients, s.theta_i, s.theta_r, s.delta_phi);
        (model / s.rgb[0] - 1.0).powi(2)
    });
    (squares.sum::<f64>() / measured.samples.len() as f64).sqrt()
}

#[test]
fn nist_coefficients_give_what_nist_measured() {
    let nist = read_materials(path("tests/data/nist_ptfe/kvd_633.csv"), None).unwrap();
    assert_eq!(nist.order, 7);
    let error = rms_relative(&ptfe(), 7, &nist.entries[0].rgb[0]);
    println!("{error}");
    assert!(error <= PTFE_RELATIVE, "{error}");
}

#[test]
fn our_fit_of_nist_measurements_is_as_good() {
    let fit = fit_one(ptfe(), 7);
    let error = rms_relative(&ptfe(), 7, &fit.material.rgb[0]);
    println!("{error}");
    assert!(error <= PTFE_RELATIVE, "{error}");
    assert!(fit.material.is_gray());
    let recorded = figures();
    let recorded = &recorded.iter().find(|row| row.0 == "ptfe-633nm-fit").unwrap().1;
    let found = [fit.samples as f64, fit.maximum[0], fit.residual, fit.lowest, fit.highest];
    for (found, recorded) in found.iter().zip(recorded) {
        assert!((found - recorded).abs() <= tolerances::RECORDED_FIGURE);
    }
    assert!((fit.condition / recorded[5] - 1.0).abs() <= tolerances::RECORDED_FIGURE);
}

/// Fully measured and in range, a BRDF comes back, channel by channel.
#[test]
fn known_brdf_is_recovered() {
    let mut reference = [(); 3].map(|()| vec![0.0; material::count(7)]);
    for (channel, scale) in reference.iter_mut().zip([1.0, 0.5, 2.0]) {
        channel[material::position(0, 0, 0)] = 2.0 * scale;
        channel[material::position(1, 1, 1)] = -0.2;
        channel[material::position(7, 5, 3)] = 0.02 * scale;
        channel[material::position(6, 6, 0)] = -0.01;
    }
    let made = measured(FRAC_PI_2, 9, |theta_i, theta_r, delta_phi| {
        reference.each_ref().map(|channel| brdf(7, channel, theta_i, theta_r, delta_phi))
    });
    let fit = fit_one(made.clone(), 7);
    for (channel, reference) in fit.material.rgb.iter().zip(&reference) {
        let error = channel.iter().zip(reference).map(|(a, b)| (a - b).abs());
        let error = error.fold(0.0, f64::max) / reference[0];
        println!("{error:e}");
        assert!(error <= RECOVERED_MATERIAL, "{error}");
    }
    assert!(fit.residual <= RECOVERED_MATERIAL);
    assert_eq!(fit, fit_one(made, 7), "the same input, the same output");
}

/// A glossy material measured to 60 degrees only: least squares alone swings far
/// out of range beyond, the fit does not, and is as good where it was measured.
#[test]
fn nothing_swings_out_of_range_where_nothing_was_measured() {
    let made = measured(FRAC_PI_3, 5, |theta_i, theta_r, delta_phi| {
        let mirror =
            theta_i.cos() * theta_r.cos() - theta_i.sin() * theta_r.sin() * delta_phi.cos();
        [0.1 + (6.0 * (mirror - 1.0)).exp(); 3]
    });
    let values = Col::from_fn(made.samples.len(), |k| made.samples[k].rgb[0]);
    let rows: Vec<Vec<f64>> =
        made.samples.iter().map(|s| modes(7, s.theta_i, s.theta_r, s.delta_phi)).collect();
    let design = Mat::from_fn(rows.len(), rows[0].len(), |row, column| rows[row][column]);
    let plain = design.qr().solve_lstsq(&values);
    let plain: Vec<f64> = plain.iter().copied().collect();
    let grid = DirectionGrid::for_order(7);
    let (lowest, highest) = grid.range(&plain);
    assert!(lowest < 10.0 * LOWEST || highest > 2.0 * HIGHEST);

    let fit = fit_one(made, 7);
    let fine = DirectionGrid::new(7, 141, 281).range(&fit.material.rgb[0]);
    println!("{lowest} {highest}, held {fine:?}, residual {}", fit.residual);
    let maximum = fit.maximum[0];
    assert!(fine.0 >= LOWEST * maximum && fine.1 <= HIGHEST * maximum);
    assert!(fit.lowest >= LOWEST && fit.highest <= HIGHEST);
    assert!(fit.residual <= LOBE_RESIDUAL, "{}", fit.residual);
}

/// 40 measurements leave 15 of the 55 coefficients of order 8 free.
#[test]
fn too_few_measurements_give_a_fit_in_range() {
    let mut few = ptfe();
    few.samples = few.samples.into_iter().step_by(46).collect();
    let fit = fit_one(few, 8);
    println!("{} {} {}", fit.residual, fit.lowest, fit.highest);
    assert_eq!((fit.samples, fit.condition), (40, f64::INFINITY));
    assert!(fit.residual <= FREE_RESIDUAL);
    assert!(fit.lowest >= LOWEST && fit.highest <= HIGHEST);
    assert!(fit.material.rgb[0].iter().all(|b| b.abs() < 10.0));
}

#[test]
fn black_channels_are_black() {
    let fit = fit_one(measured(1.4, 4, |_, _, _| [0.3, 0.0, 0.3]), 4);
    let [red, green, blue] = &fit.material.rgb;
    assert!(green.iter().all(|&b| b == 0.0));
    assert_eq!(red, blue);
    assert!((red[0] - 0.3 * 2.0 * PI).abs() <= RECOVERED_MATERIAL);
}

#[test]
fn faults_name_the_material_and_a_remedy() {
    let fault = |measured: Measured| {
        let text = fit(&[measured], 3, &mut |_, _| ()).unwrap_err().to_string();
        assert!(text.starts_with("made: ") && text.contains("; "), "{text}");
        text
    };
    assert!(fault(measured(1.0, 3, |_, _, _| [-0.1; 3])).contains("no positive value"));
    let infinite = measured(1.0, 3, |theta_i, _, _| [1.0, 1.0, 1.0 / theta_i]);
    assert!(fault(infinite).contains("not finite"));
    let mut none = ptfe();
    none.name = "made".into();
    none.samples.clear();
    assert!(fault(none).contains("no measurements"));
    let high = fit(&[ptfe()], 17, &mut |_, _| ()).unwrap_err().to_string();
    assert!(high.contains("order 16 at most, not to 17; "), "{high}");
}

#[test]
fn progress_counts_the_materials() {
    let made = measured(1.0, 3, |_, _, _| [0.1; 3]);
    let mut heard = Vec::new();
    let two = [made.clone(), made];
    let (_, fits) = fit(&two, 0, &mut |done, of| heard.push((done, of))).unwrap();
    assert_eq!(heard, [(0, 2), (1, 2), (2, 2)]);
    let mut text = Vec::new();
    write_figures(&fits, &mut text).unwrap();
    let text = String::from_utf8(text).unwrap();
    assert!(text.starts_with("name,samples,maximum,residual,lowest,highest,condition\n"));
    assert_eq!(text.lines().count(), 3);
}

/// samples, maximum, residual, lowest, highest, condition of every recorded fit.
fn figures() -> Vec<(String, Vec<f64>)> {
    let file = path("../../tables/inputs/materials.fit.csv");
    let mut reader = csv::ReaderBuilder::new().comment(Some(b'#')).from_path(file).unwrap();
    let rows = reader.records().map(|record| {
        let record = record.unwrap();
        let numbers = record.iter().skip(1).map(|field| field.parse().unwrap());
        (record[0].to_owned(), numbers.collect())
    });
    rows.collect()
}

/// The committed coefficients: ranges recomputed on the grid, and on one that
/// shares few points with it; residuals as recorded when they were fitted.
#[test]
fn committed_materials_are_in_range_and_true_to_measurements() {
    let materials = read_materials(path("../../tables/inputs/materials.csv"), None).unwrap();
    let nist = read_materials(path("tests/data/nist_ptfe/kvd_633.csv"), None).unwrap();
    let (last, curet) = materials.entries.split_last().unwrap();
    assert_eq!((materials.order, curet.len()), (7, 61));
    assert_eq!(*last, nist.entries[0], "read in unchanged");
    let grids = [DirectionGrid::for_order(7), DirectionGrid::new(7, 141, 281)];
    let mut residuals = Vec::new();
    for (material, (name, figures)) in curet.iter().zip(figures()) {
        let &[samples, maximum, residual, lowest, highest, _] = &figures[..] else {
            panic!("six figures")
        };
        assert_eq!((&material.name, samples), (&name, 205.0));
        assert!(material.is_gray());
        let ranges = grids.each_ref().map(|grid| grid.range(&material.rgb[0]));
        for (low, high) in ranges {
            assert!(low >= LOWEST * maximum && high <= HIGHEST * maximum, "{name}");
        }
        assert!((ranges[0].0 / maximum - lowest).abs() <= tolerances::RECORDED_FIGURE);
        assert!((ranges[0].1 / maximum - highest).abs() <= tolerances::RECORDED_FIGURE);
        residuals.push(residual);
    }
    residuals.sort_by(f64::total_cmp);
    println!("{} to {}", residuals[0], residuals[60]);
    assert!(residuals[30] <= CURET_RESIDUAL, "{}", residuals[30]);
}
