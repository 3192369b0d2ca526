//! A light on a material to 50 coefficients, against dense products.

use crate::dense::{ByHand, Dense, Vector, WAYS, padded};
use crate::report::{Table, Way, median_and_worst, ratios, standing};
use crate::shipped::{
    Pair, Shipped, View, all_modes, coefficients, gram_rows, only, selected_modes,
};
use eigenshade::{Tolerance, sphere};
use eigenshade_index::{light, material};
use std::hint::black_box;

/// A dense product takes up to a quarter longer with where its matrix lies: rounds take these
/// in turn.
const PLACES: usize = 5;
const ROUNDS: usize = 27 * PLACES;
/// Pairs for the errors.
const PAIRS: usize = 45;

/// Rows of UᵀM over some modes and c over the same, in single precision.
struct Product {
    places: Vec<Dense>,
    c: Vec<Vector>,
}

impl Product {
    fn new(rows: &[Vec<f64>], c: &[Vec<f64>], kept: &[bool]) -> Self {
        let single = |values: &Vec<f64>| -> Vec<f32> {
            only(values, kept).into_iter().map(|value| value as f32).collect()
        };
        let rows: Vec<Vec<f32>> = rows.iter().map(single).collect();
        Self {
            places: (0..PLACES).map(|_| Dense::new(&rows)).collect(),
            c: c.iter().map(|c| Vector::new(&single(c))).collect(),
        }
    }

    fn run(&self, way: usize, round: usize, d: &mut Vector) {
        self.places[round % PLACES].multiply(way, &self.c[round % self.c.len()], black_box(d));
    }
}

/// The transfer of a pair's material as a dense matrix: a column for each coefficient of the light.
struct DenseTransfer {
    dense: Dense,
    by_hand: ByHand<{ padded(sphere::COMPONENTS) }>,
    light: Vector,
    padded: Vec<f32>,
}

/// Those of [`WAYS`], and by hand by columns and by rows.
const TRANSFER_WAYS: usize = WAYS.len() + 2;

impl DenseTransfer {
    fn new(rows: &[Vec<f64>], pair: &Pair) -> Self {
        let transfer = |row: &Vec<f64>| -> Vec<f32> {
            let mut sums = vec![0.0; pair.light.len()];
            for ((l, m, o, p, q), value) in all_modes().into_iter().zip(row) {
                sums[light::position(l, m)] += value * pair.material[material::position(o, p, q)];
            }
            sums.into_iter().map(|sum| sum as f32).collect()
        };
        let rows: Vec<Vec<f32>> = rows.iter().map(transfer).collect();
        let light = pair.light_single();
        let mut filled = light.coefficients().to_vec();
        filled.resize(padded(filled.len()), 0.0);
        Self {
            dense: Dense::new(&rows),
            by_hand: ByHand::new(&rows),
            light: Vector::new(light.coefficients()),
            padded: filled,
        }
    }

    fn run(&self, way: usize, d: &mut Vector) {
        match way.checked_sub(WAYS.len()) {
            None => self.dense.multiply(way, &self.light, d),
            Some(0) => d.fill(&self.by_hand.by_columns(black_box(self.light.of(0)))),
            Some(_) => d.fill(&self.by_hand.by_rows(black_box(&self.padded))),
        }
    }

    fn product(&self, way: usize) -> Vec<f32> {
        let mut d = Vector::zeros(sphere::COMPONENTS);
        self.run(way, &mut d);
        d.of(if way < WAYS.len() { way } else { 0 }).to_vec()
    }
}

/// The comparison; times only if `measured`.
pub fn table(shipped: &Shipped, measured: bool) -> Table {
    let pairs = shipped.pairs(PAIRS);
    let c: Vec<Vec<f64>> = pairs.iter().map(coefficients).collect();
    let rows = gram_rows(shipped);
    let kept = selected_modes(shipped);
    let all = Product::new(&rows, &c, &vec![true; kept.len()]);
    let thousand = Product::new(&rows, &c, &kept);

    let view = View::new();
    let at = view.modes();
    let images: Vec<Vec<f64>> = pairs.iter().map(|pair| View::image(&at, pair)).collect();
    // Of d, of its largest, the worst; of the image, of the peak, median and worst.
    let errors = |d: &mut dyn FnMut(usize) -> Vec<f32>| {
        let (mut of_d, mut of_image) = (0.0f64, Vec::new());
        for (k, (c, image)) in c.iter().zip(&images).enumerate() {
            let d = d(k);
            let dot = |row: &Vec<f64>| row.iter().zip(c).map(|(a, b)| a * b).sum::<f64>();
            let exact: Vec<f64> = rows.iter().map(dot).collect();
            let largest = exact.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
            let off = exact.iter().zip(&d).map(|(exact, &d)| (exact - f64::from(d)).abs());
            of_d = of_d.max(off.fold(0.0, f64::max) / largest);
            of_image.push(view.error(image, &shaded(&view, &d)));
        }
        [&[Some(of_d)], &median_and_worst(&of_image)[..]].concat()
    };

    let transfers: Vec<sphere::Transfer> = pairs
        .iter()
        .map(|pair| sphere::transfer(&pair.material_single()).expect("it fits"))
        .collect();
    let ds: Vec<sphere::Coefficients> = pairs.iter().map(Pair::project).collect();
    let relit = |k: usize| sphere::relight(&transfers[k], &pairs[k].light_single());
    let mut room = [0.0f32; sphere::SCENE];
    let dense: Vec<DenseTransfer> =
        pairs.iter().map(|pair| DenseTransfer::new(&rows, pair)).collect();
    let zeros = |_| Vector::zeros(sphere::COMPONENTS);
    let mut outs: Vec<Vector> = (0..2 * WAYS.len()).map(zeros).collect();
    let mut transfer_outs: Vec<Vector> = (0..TRANSFER_WAYS).map(zeros).collect();
    let ratios = measured.then(|| {
        let mut ways = vec![
            Way::new(|round| drop(black_box(black_box(&pairs[round % PAIRS]).project()))),
            Way::new(|round| drop(black_box(relit(black_box(round % PAIRS))))),
            Way::new(|round| drop(black_box(sphere::collapse(black_box(&ds[round % PAIRS]))))),
            Way::new(|round| {
                let mut lengths = [0; 16];
                let within = sphere::BASIS.collapse_within(
                    black_box(&ds[round % PAIRS]),
                    Tolerance::OfPeak(1e-2),
                    &mut lengths,
                    black_box(&mut room[..]),
                );
                within.map(drop).expect("it fits");
            }),
        ];
        for (k, d) in outs.iter_mut().enumerate() {
            let (product, way) = (if k < WAYS.len() { &all } else { &thousand }, k % WAYS.len());
            ways.push(Way::new(move |round| product.run(way, round, d)));
        }
        for (way, d) in transfer_outs.iter_mut().enumerate() {
            let dense = &dense;
            ways.push(Way::new(move |round| dense[round % PAIRS].run(way, black_box(&mut *d))));
        }
        ratios(ROUNDS, &mut ways)
    });
    let ratio = |k: usize| ratios.as_ref().map(|ratios| ratios[k]);

    let mut table = Table::new(
        "A light on a material: d = UᵀMc",
        &[
            "time relative to `project`",
            "who is ahead",
            "error of d",
            "error of the image",
            "worst",
        ],
    );
    let project = errors(&mut |k| ds[k].to_vec());
    table.row("`project`", ratio(0), String::new(), project);
    let relight = errors(&mut |k| relit(k).expect("it fits").to_vec());
    table.row("`relight`", ratio(1), String::new(), relight);
    let first = 4 + 2 * WAYS.len();
    let best = (0..TRANSFER_WAYS).filter_map(|way| Some((ratio(first + way)?, way)));
    let best = best.min_by(|a, b| a.0.total_cmp(&b.0));
    let (ratio_of_dense, way) = best.map_or((None, 0), |(ratio, way)| (Some(ratio), way));
    let of_dense = errors(&mut |k| dense[k].product(way));
    let factor = ratio_of_dense.zip(ratio(1)).map(|(theirs, ours)| theirs / ours);
    let ahead_of_dense = standing("`relight`", "the dense transfer", factor);
    table.row("dense transfer, the best of eight", ratio_of_dense, ahead_of_dense, of_dense);
    for (way, name) in WAYS.iter().enumerate() {
        let ratio = ratio(4 + way);
        let library = name.split(',').next().unwrap_or(name);
        let errors = errors(&mut |k| product(&all, way, k));
        let standing = standing("`project`", library, ratio);
        table.row(format!("dense, {name}"), ratio, standing, errors);
    }
    let best = (0..WAYS.len()).filter_map(|way| Some((ratio(4 + WAYS.len() + way)?, way)));
    let best = best.min_by(|a, b| a.0.total_cmp(&b.0));
    let (ratio_of_best, way) = best.map_or((None, 1), |(ratio, way)| (Some(ratio), way));
    let errors_of_best = errors(&mut |k| product(&thousand, way, k));
    let standing = standing("`project`", "the dense product", ratio_of_best);
    let way = "dense, 1,000 modes, the best of the six";
    table.row(way, ratio_of_best, standing, errors_of_best);
    table.row("`collapse`, which both need", ratio(2), String::new(), [None; 3]);
    table.row("`collapse_within` 1e-2 in its place", ratio(3), String::new(), [None; 3]);
    table
}

fn product(product: &Product, way: usize, k: usize) -> Vec<f32> {
    let mut d = Vector::zeros(sphere::COMPONENTS);
    product.places[0].multiply(way, &product.c[k], &mut d);
    d.of(way).to_vec()
}

/// The image of coefficients at every normal.
fn shaded(view: &View, d: &[f32]) -> Vec<f64> {
    let scene = sphere::BASIS.collapse::<{ sphere::SCENE }>(d).expect("it fits");
    view.shade(&scene)
}
