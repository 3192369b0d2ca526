//! Pixels: of measured materials against the nine-term formula and the direct sum of the paper's
//! 1,000 modes, and of a white matte against the formula, which is exact there to degree 2.

use crate::dense::{Dense, Vector, WAYS};
use crate::report::{Table, Way, ratios, standing};
use crate::shipped::{Mode, Shipped, View, all_modes, coefficients, only, selected_modes};
use crate::subject::{Lengths, Picture, WITHIN, errors, nine_terms_image, subjects};
use eigenshade::sphere;
use eigenshade_model::reference::Modes;
use std::hint::black_box;

const PIXELS: usize = 65_536;
/// Normals whose 1,000 modes are held.
const HELD: usize = 4096;
/// Normals at which 1,000 modes are evaluated.
const EVALUATED: usize = 32;
/// Pairs, one a round.
const PAIRS: usize = 45;

const HEADS: [&str; 4] = ["time relative to nine terms", "who is ahead", "rms error", "worst"];

/// The comparison on measured materials; times only if `measured`.
pub fn measured(shipped: &Shipped, measured: bool) -> Table {
    let pairs = shipped.pairs(PAIRS);
    let view = View::new();
    let at = view.modes();
    let mut lengths = vec![Default::default(); PAIRS];
    let subjects = subjects(&pairs, &at, &mut lengths);

    let kept = selected_modes(shipped);
    let names: Vec<Mode> = only(&all_modes(), &kept);
    let c: Vec<Vec<f64>> = pairs.iter().map(|pair| only(&coefficients(pair), &kept)).collect();
    let values = |at: &Modes<'_>| -> Vec<f64> {
        names.iter().map(|&(l, m, o, p, q)| at.value(l, m, o, p, q)).collect()
    };
    let dot = |row: &[f64], c: &[f64]| row.iter().zip(c).map(|(a, b)| a * b).sum::<f64>();
    let seen: Vec<Vec<f64>> = at.iter().map(values).collect();

    let ratios = measured.then(|| {
        let picture = Picture::new(PIXELS);
        let held = Picture::new(HELD);
        let single = |values: Vec<f64>| -> Vec<f32> {
            values.into_iter().map(|value| value as f32).collect()
        };
        let [x, y, z] = held.axes();
        let normals: Vec<[f64; 3]> = (0..HELD).map(|k| [x[k], y[k], z[k]].map(f64::from)).collect();
        let rows: Vec<Vec<f32>> =
            normals.iter().map(|&normal| single(values(&view.reference.at(normal)))).collect();
        let dense = Dense::new(&rows);
        let by: Vec<Vector> = c.iter().map(|c| Vector::new(&single(c.clone()))).collect();
        let mut outs: Vec<Vector> = WAYS.iter().map(|_| Vector::zeros(HELD)).collect();
        let mut ways = vec![
            picture.nine_terms(&subjects),
            picture.shade(&subjects, |subject| &subject.full),
            picture.shade(&subjects, |subject| &subject.within[0]),
            picture.shade(&subjects, |subject| &subject.within[1]),
            Way::new(|round| {
                for &normal in normals.iter().step_by(HELD / EVALUATED) {
                    let at = view.reference.at(black_box(normal));
                    let mode = names.iter().zip(&c[round % PAIRS]);
                    let sum: f64 =
                        mode.map(|(&(l, m, o, p, q), c)| c * at.value(l, m, o, p, q)).sum();
                    black_box(sum);
                }
            }),
        ];
        for (way, out) in outs.iter_mut().enumerate() {
            let (dense, by) = (&dense, &by);
            ways.push(Way::new(move |round| {
                dense.multiply(way, &by[round % PAIRS], black_box(out));
            }));
        }
        let mut ratios = ratios(3 * PAIRS, &mut ways);
        // Of a pixel.
        ratios[4] *= PIXELS as f64 / EVALUATED as f64;
        ratios[5..].iter_mut().for_each(|ratio| *ratio *= PIXELS as f64 / HELD as f64);
        ratios
    });
    let best = |ratios: &Vec<f64>| ratios[5..].iter().copied().fold(f64::INFINITY, f64::min);
    let ratio = |k: usize| ratios.as_ref().map(|ratios| ratios[k]);

    let mut table = Table::new("A pixel of a measured material", &HEADS);
    let ahead = |ratio: Option<f64>, ours: &str| {
        standing(ours, "the formula", ratio.map(|ratio| 1.0 / ratio))
    };
    let of_nine = errors(&view, &subjects, |_, subject| {
        with_best_albedo(&nine_terms_image(&view, subject), &subject.reference, &view.weights)
    });
    table.row("nine terms", ratio(0), String::new(), of_nine);
    let of_full = errors(&view, &subjects, |_, subject| view.shade(&subject.full));
    table.row("full scene", ratio(1), ahead(ratio(1), "the full scene"), of_full);
    for (k, share) in WITHIN.into_iter().enumerate() {
        let of_scene = errors(&view, &subjects, |_, subject| view.shade(&subject.within[k]));
        let standing = ahead(ratio(2 + k), "the scene");
        table.row(format!("scene within {share:e}"), ratio(2 + k), standing, of_scene);
    }
    let of_modes =
        errors(&view, &subjects, |k, _| seen.iter().map(|row| dot(row, &c[k])).collect());
    let full = ratio(1).unwrap_or(1.0);
    for (way, ratio) in [("held ready", ratios.as_ref().map(best)), ("evaluated", ratio(4))] {
        let standing = standing("the full scene", "the sum", ratio.map(|ratio| ratio / full));
        table.row(format!("1,000 modes, {way}"), ratio, standing, of_modes.clone());
    }
    table
}

/// The image times what brings it nearest to the reference: no albedo serves the formula better.
fn with_best_albedo(image: &[f64], reference: &[f64], weights: &[f64]) -> Vec<f64> {
    let (mut both, mut own) = (0.0, 0.0);
    for ((image, reference), weight) in image.iter().zip(reference).zip(weights) {
        both += weight * image * reference;
        own += weight * image * image;
    }
    image.iter().map(|value| both / own * value).collect()
}

/// Degrees of the light: what the formula takes, and what the table does.
const DEGREES: [usize; 2] = [2, sphere::DEGREE];
/// Rounds of the comparison on a white matte: a multiple of the number of lights.
const MATTE_ROUNDS: usize = 104;

/// The comparison on a white matte; times only if `measured`.
pub fn matte(shipped: &Shipped, measured: bool) -> Table {
    let view = View::new();
    let at = view.modes();
    let mut lengths: Vec<Vec<Lengths>> =
        DEGREES.map(|_| vec![Lengths::default(); shipped.lights.len()]).into();
    let sets: Vec<_> = DEGREES
        .into_iter()
        .zip(&mut lengths)
        .map(|(degree, lengths)| subjects(&shipped.on_matte(degree), &at, lengths))
        .collect();
    let picture = Picture::new(PIXELS);
    let ratios = measured.then(|| {
        let mut ways = Vec::new();
        for set in &sets {
            ways.push(picture.nine_terms(set));
            ways.push(picture.shade(set, |subject| &subject.within[0]));
            ways.push(picture.shade(set, |subject| &subject.within[1]));
            ways.push(picture.shade(set, |subject| &subject.full));
        }
        ratios(MATTE_ROUNDS, &mut ways)
    });

    let mut table = Table::new("A pixel of a white matte", &HEADS);
    for ((degree, set), first) in DEGREES.into_iter().zip(&sets).zip([0, 4]) {
        let ratio = |k: usize| ratios.as_ref().map(|ratios| ratios[first + k]);
        let mut row = |way: &str, ratio: Option<f64>, is_ours: bool, errors: Vec<Option<f64>>| {
            let way = format!("{way}, light to degree {degree}");
            let factor = ratio.filter(|_| is_ours).map(|ratio| 1.0 / ratio);
            table.row(way, ratio, standing("the scene", "the formula", factor), errors);
        };
        let of_nine = errors(&view, set, |_, subject| nine_terms_image(&view, subject));
        row("nine terms", ratio(0), false, of_nine);
        for (k, share) in WITHIN.into_iter().enumerate().rev() {
            let of_scene = errors(&view, set, |_, subject| view.shade(&subject.within[k]));
            row(&format!("scene within {share:e}"), ratio(1 + k), true, of_scene);
        }
        let of_full = errors(&view, set, |_, subject| view.shade(&subject.full));
        row("full scene", ratio(3), true, of_full);
    }
    table
}
