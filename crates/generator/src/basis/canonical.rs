//! The canonical order and sign of the components: every run, thread count and instruction set
//! gives the same basis.
//!
//! Order: falling eigenvalue, then |m|, then +m before -m. Sign: h = u / sin^|m| is positive at the
//! pole.
//!
//! Eigenimages that are sums of several azimuths, and have equal eigenvalues, are determined only
//! up to a rotation among them. `settle` rotates each such set so that its strongest span
//! function occurs in one component only, the strongest of the remaining functions in the next, and
//! so on. For the normals of a sphere this gives the products u(α) Φ_m(β) again. Each component is
//! assigned the m that is strongest in it. A set is sorted by rising |m|, +m before -m, and the
//! sign makes the polynomial of that m positive at the pole.

use crate::basis::profile;
use faer::Mat;

/// A profile with the values that determine its place in the order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ranked {
    /// |m|.
    pub azimuth: usize,
    /// Index within the block of its |m|, by falling eigenvalue.
    pub number: usize,
    /// Eigenvalue; `None` for the constant image, which comes first.
    pub eigenvalue: Option<f64>,
}

/// Sorts profiles into canonical order.
pub fn sort(profiles: &mut [Ranked]) {
    let size = |ranked: &Ranked| ranked.eigenvalue.unwrap_or(f64::INFINITY);
    profiles.sort_by(|a, b| {
        size(b).total_cmp(&size(a)).then(a.azimuth.cmp(&b.azimuth)).then(a.number.cmp(&b.number))
    });
}

/// The signed orders of one profile, +m before -m.
#[must_use]
pub fn orders(azimuth: usize) -> &'static [i32] {
    if azimuth == 0 { &[1] } else { &[1, -1] }
}

/// The factor ±1 that makes h positive at the pole, z = 1.
#[must_use]
pub fn sign(chebyshev: &[f64]) -> f64 {
    if profile::evaluate(chebyshev, 1.0) < 0.0 { -1.0 } else { 1.0 }
}

/// Singular values with a smaller relative difference are equal.
const EQUAL: f64 = 1e-9;

/// Singular values that differ by less than this fraction of the largest are also equal: the
/// difference is rounding.
const ROUNDING: f64 = 1e-14;

/// Properties of the span's functions, in their order.
pub(crate) struct Functions {
    /// m, signed.
    pub(crate) orders: Vec<i32>,
    /// h(1) of the profile.
    pub(crate) poles: Vec<f64>,
}

/// Rotates, sorts and signs the columns of `shown`, whose coordinates in the span are the columns
/// of `coordinates`. `eigenvalues` are falling; the constant's is `None`.
pub(crate) fn settle(
    shown: &mut Mat<f64>,
    coordinates: &mut Mat<f64>,
    eigenvalues: &[Option<f64>],
    functions: &Functions,
) {
    let values: Vec<Option<f64>> = eigenvalues.iter().map(|value| value.map(f64::sqrt)).collect();
    let largest = values.iter().flatten().copied().fold(0.0, f64::max);
    let mut start = 0;
    while start < values.len() {
        let mut end = start + 1;
        while let (Some(value), Some(Some(next))) = (values[end - 1], values.get(end)) {
            if value - next > EQUAL * value + ROUNDING * largest {
                break;
            }
            end += 1;
        }
        if values[start].is_some() {
            separate(shown, coordinates, start, end);
            sort_set(shown, coordinates, start, end, functions);
            for column in start..end {
                if at_pole(coordinates, column, functions) < 0.0 {
                    for matrix in [&mut *shown, &mut *coordinates] {
                        matrix.col_mut(column).iter_mut().for_each(|value| *value = -*value);
                    }
                }
            }
        }
        start = end;
    }
}

/// Rotates the columns so that each function in turn, strongest first, occurs in one column only.
fn separate(shown: &mut Mat<f64>, coordinates: &mut Mat<f64>, start: usize, end: usize) {
    for first in start..end.saturating_sub(1) {
        let strength =
            |k: usize| -> f64 { (first..end).map(|column| coordinates[(k, column)].powi(2)).sum() };
        let strengths: Vec<f64> = (0..coordinates.nrows()).map(strength).collect();
        let most = strengths.iter().copied().fold(0.0, f64::max);
        // If several are equal up to rounding, take the first.
        let Some(strongest) = strengths.iter().position(|one| *one >= most * (1.0 - 1e-6)) else {
            continue;
        };
        for column in first + 1..end {
            let (a, b) = (coordinates[(strongest, first)], coordinates[(strongest, column)]);
            let length = a.hypot(b);
            if length == 0.0 {
                continue;
            }
            for matrix in [&mut *shown, &mut *coordinates] {
                rotate(matrix, first, column, a / length, b / length);
            }
        }
    }
}

/// Maps two columns (u, v) to (c u + s v, c v - s u).
fn rotate(matrix: &mut Mat<f64>, first: usize, second: usize, c: f64, s: f64) {
    for row in 0..matrix.nrows() {
        let (u, v) = (matrix[(row, first)], matrix[(row, second)]);
        matrix[(row, first)] = c * u + s * v;
        matrix[(row, second)] = c * v - s * u;
    }
}

fn sort_set(
    shown: &mut Mat<f64>,
    coordinates: &mut Mat<f64>,
    start: usize,
    end: usize,
    functions: &Functions,
) {
    let mut ranked: Vec<(u32, bool, usize)> = (start..end)
        .map(|column| {
            let order = strongest_order(coordinates, column, functions);
            (order.unsigned_abs(), order < 0, column)
        })
        .collect();
    ranked.sort_unstable();
    for matrix in [shown, coordinates] {
        let copy = matrix.get(.., start..end).to_owned();
        for (to, (_, _, from)) in (start..end).zip(&ranked) {
            matrix.col_mut(to).copy_from(copy.col(from - start));
        }
    }
}

/// The m whose functions contribute most to a component. Ties go to the lowest |m|, then to +m.
fn strongest_order(coordinates: &Mat<f64>, column: usize, functions: &Functions) -> i32 {
    let top = functions.orders.iter().copied().max().unwrap_or(0);
    let share = |order: i32| -> f64 {
        let of = functions.orders.iter().enumerate().filter(|(_, found)| **found == order);
        of.map(|(k, _)| coordinates[(k, column)].powi(2)).sum()
    };
    let orders = (0..=top).flat_map(|m| [m, -m]);
    let (mut best, mut most) = (0, 0.0);
    for order in orders {
        let share = share(order);
        if share > most * (1.0 + 1e-6) {
            (best, most) = (order, share);
        }
    }
    best
}

/// The polynomial of a component's strongest m, evaluated at the pole.
fn at_pole(coordinates: &Mat<f64>, column: usize, functions: &Functions) -> f64 {
    let order = strongest_order(coordinates, column, functions);
    let of = functions.orders.iter().zip(&functions.poles).enumerate();
    of.filter(|(_, (found, _))| **found == order)
        .map(|(k, (_, pole))| coordinates[(k, column)] * pole)
        .sum()
}
