//! A light on a material to 46 coefficients d = UᵀMc, against dense products.

use crate::dense::{ByHand, Dense, FAER, NALGEBRA};
use crate::{Method, rows};
use eigenshade::sphere;
use eigenshade_benches::sheet::Row;
use eigenshade_benches::shipped::{Pair, Shipped, tables};
use eigenshade_model::selection;
use eigenshade_table::{Component, Table, light, material, mode};
use std::hint::black_box;

/// Lights on materials.
pub const PAIRS: usize = 45;

/// Calls of a pair in a row, so that what they read is near.
const CALLS: usize = 20;

/// Rows of the matrix by hand: whole vectors.
const ROWS: usize = sphere::COMPONENTS.next_multiple_of(8);

/// l, m, o, p, q.
type Mode = (usize, isize, usize, usize, usize);

/// The modes of the table, m by m.
pub struct Modes {
    table: Table,
    all: Vec<Mode>,
    /// Those that the paper's selection of 1,000 keeps; ties stay whole.
    kept: Vec<usize>,
}

impl Modes {
    pub fn read() -> Self {
        let bytes = std::fs::read(tables().join("sphere.bin")).expect("the shipped table");
        let table = eigenshade_table::decode(&bytes).expect("a table");
        let top = sphere::DEGREE.cast_signed();
        let of = |m: isize| {
            let modes = mode::indices(sphere::DEGREE, sphere::ORDER, m.unsigned_abs());
            modes.map(move |(l, o, p, q)| (l, m, o, p, q))
        };
        let all: Vec<Mode> = (-top..=top).flat_map(of).collect();
        let highest = selection::highest(&table.gram, 1000);
        let keeps = |&k: &usize| {
            let (l, m, o, p, q) = all[k];
            highest[table.gram.place(m.unsigned_abs(), l, o, p, q)]
        };
        let kept = (0..all.len()).filter(keeps).collect();
        Self { table, all, kept }
    }

    /// c of a pair.
    pub fn coefficients(&self, pair: &Pair) -> Vec<f64> {
        let c = |&(l, m, o, p, q): &Mode| {
            pair.light[light::position(l, m)] * pair.material[material::position(o, p, q)]
        };
        self.all.iter().map(c).collect()
    }

    /// UᵀM, a row for each component.
    fn gram_rows(&self) -> Vec<Vec<f64>> {
        let row = |component: &Component| {
            let mut values =
                self.table.gram_row(&self.table.profiles[component.profile]).into_iter();
            let sign = if component.order < 0 && component.order % 2 != 0 { -1.0 } else { 1.0 };
            let entry = |&(_, m, ..): &Mode| {
                if m as i32 != component.order {
                    return 0.0;
                }
                sign * values.next().expect("a value for each mode of its azimuth")
            };
            self.all.iter().map(entry).collect()
        };
        self.table.components.iter().map(row).collect()
    }

    /// The matrix with a pair's material multiplied in: a column for each coefficient of the light.
    fn multiplied_in(&self, matrix: &[Vec<f64>], pair: &Pair) -> Vec<Vec<f32>> {
        let transfer = |row: &Vec<f64>| {
            let mut sums = vec![0.0; pair.light.len()];
            for (&(l, m, o, p, q), value) in self.all.iter().zip(row) {
                sums[light::position(l, m)] += value * pair.material[material::position(o, p, q)];
            }
            single(&sums)
        };
        matrix.iter().map(transfer).collect()
    }

    /// Those that the selection keeps.
    pub fn selected(&self) -> impl Iterator<Item = Mode> {
        self.kept.iter().map(|&k| self.all[k])
    }

    /// Of values for all modes, those of the selected modes.
    pub fn kept(&self, values: &[f64]) -> Vec<f64> {
        self.kept.iter().map(|&k| values[k]).collect()
    }
}

pub fn single(values: &[f64]) -> Vec<f32> {
    values.iter().map(|&value| value as f32).collect()
}

pub fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The largest error of d, relative to the largest d.
fn error(exact: &[f64], d: &[f32]) -> f64 {
    let largest = exact.iter().fold(0.0, |most: f64, d| most.max(d.abs()));
    let off = exact.iter().zip(d).map(|(exact, &d)| (exact - f64::from(d)).abs());
    off.fold(0.0, f64::max) / largest
}

pub fn compare(timed: bool) -> Vec<Row> {
    let modes = Modes::read();
    let pairs = Shipped::read().pairs(PAIRS);
    let matrix = modes.gram_rows();
    let c: Vec<Vec<f64>> = pairs.iter().map(|pair| modes.coefficients(pair)).collect();
    let d = |c: &Vec<f64>| matrix.iter().map(|row| dot(row, c)).collect();
    let exact: Vec<Vec<f64>> = c.iter().map(d).collect();
    // Every pair with a matrix of its own, or with the only one.
    let dense = |name, matrices, vectors, ways: [usize; 2]| {
        method(name, &exact, ways.map(|way| product(matrices, vectors, way)))
    };

    let all = [Dense::new(&matrix.iter().map(|row| single(row)).collect::<Vec<_>>())];
    let all_c: Vec<_> = c.iter().map(|c| single(c)).collect();
    let kept: Vec<_> = matrix.iter().map(|row| single(&modes.kept(row))).collect();
    let kept = [Dense::new(&kept)];
    let kept_c: Vec<_> = c.iter().map(|c| single(&modes.kept(c))).collect();
    let methods = vec![
        method("`project`", &exact, [|k: usize| pairs[k].project()]),
        dense("dense product, faer", &all, &all_c, FAER),
        dense("dense product, nalgebra", &all, &all_c, NALGEBRA),
        dense("dense product of 1,000 modes, faer", &kept, &kept_c, FAER),
        dense("dense product of 1,000 modes, nalgebra", &kept, &kept_c, NALGEBRA),
    ];
    let mut found = rows("a light on a material, d", methods, timed);

    let transfer = |pair: &Pair| sphere::transfer(&pair.material()).expect("it fits");
    let transfers: Vec<sphere::Transfer> = pairs.iter().map(transfer).collect();
    let relight = |k: usize| sphere::relight(&transfers[k], &pairs[k].light()).expect("it fits");
    let multiplied: Vec<_> = pairs.iter().map(|pair| modes.multiplied_in(&matrix, pair)).collect();
    let matrices: Vec<Dense> = multiplied.iter().map(|rows| Dense::new(rows)).collect();
    let by_hand: Vec<_> = multiplied.iter().map(|rows| ByHand::<ROWS>::new(rows)).collect();
    let lights: Vec<_> = pairs.iter().map(|pair| single(&pair.light)).collect();
    let methods = vec![
        method("`relight`", &exact, [relight]),
        dense("dense transfer, faer", &matrices, &lights, FAER),
        dense("dense transfer, nalgebra", &matrices, &lights, NALGEBRA),
        method("dense transfer, by hand", &exact, [|k: usize| by_hand[k].multiply(&lights[k])]),
    ];
    found.extend(rows("a light on a transferred material, d", methods, timed));
    found
}

fn product<'a>(
    matrices: &'a [Dense],
    vectors: &'a [Vec<f32>],
    way: usize,
) -> impl Fn(usize) -> [f32; sphere::COMPONENTS] + Copy + 'a {
    move |k| {
        let mut d = [0.0; sphere::COMPONENTS];
        matrices[k % matrices.len()].multiply(way, &vectors[k], &mut d);
        d
    }
}

/// Forms that compute d of the pair of a number.
fn method<'a, D: AsRef<[f32]>, F: Fn(usize) -> D + Copy + 'a, const FORMS: usize>(
    name: &'static str,
    exact: &[Vec<f64>],
    forms: [F; FORMS],
) -> Method<'a> {
    let larger = |(k, exact): (usize, &Vec<f64>)| {
        forms.iter().map(|form| error(exact, form(k).as_ref())).fold(0.0, f64::max)
    };
    let errors = exact.iter().enumerate().map(larger).collect();
    let run = |form: F| {
        let call = move |k: usize| {
            black_box(form(black_box(k / CALLS)));
        };
        Box::new(move || (0..PAIRS * CALLS).for_each(call)) as Box<dyn FnMut()>
    };
    Method { name, forms: forms.map(run).into(), part: 1.0, errors }
}
