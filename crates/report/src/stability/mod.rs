//! The numerically hard cases, which `docs/accuracy.md` describes: the error measured against an
//! oracle, and what a naive method would give. `report stability` checks every bound.

use crate::pages;
use crate::sheet::{Record, Sheet};
use csv::StringRecord;
use eigenshade_testing::largest;
use nalgebra::{DMatrix, DVector, SymmetricEigen};

mod databases;
mod degrees;
mod inputs;
mod objects;
mod ranges;
mod rotations;
pub mod spectrum;

/// A measured number and its bound.
struct Figure {
    /// The quantity, one digit of the error, and the bound, as on the page.
    cells: [String; 3],
    /// Whether the number is within its bound; false for NaN.
    holds: bool,
}

impl Figure {
    fn new(what: impl Into<String>, found: String, bound: String, holds: bool) -> Self {
        Self { cells: [what.into(), found, bound], holds }
    }
}

/// An error with an upper bound.
fn most(what: impl Into<String>, found: f64, bound: f64) -> Figure {
    let found = found.abs();
    Figure::new(what, format!("{found:.0e}"), format!("≤ {bound:e}"), found <= bound)
}

/// An error with an upper bound that is at most ten times the error. This keeps the tolerances
/// tight that only the hard cases use, and those of all components.
fn tight(what: impl Into<String>, found: f64, bound: f64) -> Figure {
    let figure = most(what, found, bound);
    Figure { holds: figure.holds && bound <= 10.0 * found.abs(), ..figure }
}

/// An error of the naive method, with a lower bound; below it, the case is not hard.
fn least(what: impl Into<String>, found: f64, bound: f64) -> Figure {
    Figure::new(what, format!("{found:.0e}"), format!("≥ {bound:e}"), found >= bound)
}

/// A count, which must be this number.
fn exactly(what: impl Into<String>, found: usize, bound: usize) -> Figure {
    Figure::new(what, found.to_string(), format!("= {bound}"), found == bound)
}

/// A case's name on the page, and what measures its figures.
type Case = (&'static str, fn() -> Vec<Figure>);
/// All cases, in the order of the page.
const CASES: &[Case] = &[
    ("special functions to degree 64", degrees::functions),
    ("pole and rim", degrees::pole_and_rim),
    ("rotated frames, degree 64", rotations::composition),
    ("third Euler angle", rotations::third_angle),
    ("a thousand small rotations, f32", rotations::drift),
    ("a matrix that is almost a rotation, f32", rotations::almost),
    ("degree 32, order 32", degrees::high),
    ("M is singular", spectrum::root),
    ("rank of M", spectrum::ranks),
    ("more components than rank", spectrum::more_than_rank),
    ("order and sign of components", spectrum::order_and_sign),
    ("nearly equal eigenvalues", spectrum::nearly_equal),
    ("one light or one material", databases::few),
    ("identical materials", databases::alike),
    ("black lights and materials", databases::zeros),
    ("ambient lights, Lambertian materials", databases::plain),
    ("a covariance of rank one", databases::rank_one),
    ("a sun in a map", inputs::sun_in_a_map),
    ("maps of 2 x 1 and 8192 x 4096", inputs::map_sizes),
    ("degenerate triangles", objects::degenerate),
    ("coefficients at 1e-30 and 1e+30, f64", ranges::double),
    ("coefficients at 1e-30 and 1e+30, f32", ranges::single),
    ("light at 1e-30, f32", ranges::subnormal),
    ("a million pixels, f32", ranges::million),
    ("65,536 pixels at full weight, Q15", ranges::full_weight),
    ("a normal map of 8 bits", inputs::eight_bits),
    ("normals behind the rim", inputs::behind),
    ("a sun, by every method", inputs::sun),
    ("light from one direction, by every method", inputs::delta),
];
/// Factor by which a figure on the page may differ from one measured now: errors are a few last
/// bits, which depend on a host's library and vector width.
const PAGE_FACTOR: f64 = 8.0;
/// Errors on the page below this may be zero on another host.
const PAGE_ROUNDING: f64 = 1e-13;

/// Whether a recorded cell is the same as a new one: measured numbers may differ.
pub fn same(_: &StringRecord, column: usize, old: &str, new: &str) -> bool {
    let numbers = [old, new].map(|cell| cell.parse::<f64>().ok().filter(|_| cell.contains('e')));
    match numbers {
        [Some(old), Some(new)] if column == MEASURED => {
            let within = old / new <= PAGE_FACTOR && new / old <= PAGE_FACTOR;
            within || old.max(new) < PAGE_ROUNDING
        }
        _ => old == new,
    }
}

/// The columns of `docs/stability.csv`, and the place of the measured numbers.
pub const COLUMNS: &str = "case,quantity,measured,bound";
const MEASURED: usize = 2;

/// Measures every case. The error lists the figures beyond their bounds, or whose bounds are loose.
pub fn rows(progress: impl Fn(&str)) -> Result<Vec<Vec<String>>, String> {
    let (mut rows, mut broken) = (Vec::new(), Vec::new());
    for (case, measure) in CASES {
        progress(case);
        for (k, figure) in measure().iter().enumerate() {
            if !figure.holds {
                broken.push(format!("{case}: {}", figure.cells.join(" ")));
            }
            let case = if k == 0 { *case } else { "" };
            rows.push([&[case.to_owned()], &figure.cells[..]].concat());
        }
    }
    if broken.is_empty() { Ok(rows) } else { Err(broken.join("; ")) }
}

/// The part of the page: of each case the largest error with an upper bound, or else its first
/// count.
pub fn summary(sheet: &Sheet) -> (&'static str, String) {
    let rows = sheet.rows.chunk_by(|_, next| next.text("case").is_empty()).map(|of_case| {
        let measured = |row: &&Record| row.number("measured").unwrap_or_default();
        let errors = of_case.iter().filter(|row| row.text("bound").starts_with('≤'));
        let worst = errors.max_by(|a, b| measured(a).total_cmp(&measured(b)));
        let worst = worst.unwrap_or(&of_case[0]);
        let cells = ["quantity", "measured", "bound"].map(|column| worst.text(column));
        [&[of_case[0].text("case")], &cells[..]].concat().into_iter().map(str::to_owned).collect()
    });
    ("hard cases", pages::table("case | quantity | measured: | bound:", rows))
}

/// The distance of WᵀW from the identity.
pub fn off_orthonormal(vectors: &DMatrix<f64>) -> f64 {
    let count = vectors.ncols();
    largest((vectors.tr_mul(vectors) - DMatrix::identity(count, count)).iter().copied())
}

/// M^(-1/2) by eigenvalues, (28) and (33).
pub struct GramRoot {
    /// Eigenvalues that are negative, and their number.
    pub negative: [usize; 2],
    /// Elements of M^(-1/2) that are NaN, and their number.
    pub not_numbers: [usize; 2],
    /// |UᵀMU - I| for U = M^(-1/2) of the eigenvalues' absolute values.
    pub off: f64,
}

impl GramRoot {
    /// The root for M = AᵀA.
    pub fn new(a: &DMatrix<f64>) -> Self {
        let gram = a.tr_mul(a);
        let count = gram.ncols();
        let SymmetricEigen { eigenvalues: values, eigenvectors: vectors } =
            gram.clone().symmetric_eigen();
        let inverse_root = |size: fn(f64) -> f64| {
            let roots = values.map(|value| size(value).sqrt().recip());
            &vectors * DMatrix::from_diagonal(&roots) * vectors.transpose()
        };
        let (literal, whitened) = (inverse_root(|value| value), inverse_root(f64::abs));
        let product = &whitened * &gram * &whitened - DMatrix::identity(count, count);
        let negative = values.iter().filter(|value| **value < 0.0).count();
        let elements = (0..count * count).map(|k| (k / count, k % count));
        let not_numbers = elements.clone().filter(|&at| literal[at].is_nan());
        Self {
            negative: [negative, count],
            not_numbers: [not_numbers.count(), count * count],
            off: largest(elements.map(|at| product[at])),
        }
    }
}

/// Left singular vectors of the images as products with the eigenvectors of their squares, divided
/// by the roots of the eigenvalues' absolute values. Also returns the eigenvalues, descending.
pub fn left_vectors(images: &DMatrix<f64>) -> (DMatrix<f64>, Vec<f64>) {
    let eigen = images.tr_mul(images).symmetric_eigen();
    let mut order: Vec<usize> = (0..images.ncols()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
    let values: Vec<f64> = order.iter().map(|&k| eigen.eigenvalues[k]).collect();
    let columns: Vec<DVector<f64>> = order
        .iter()
        .map(|&k| images * eigen.eigenvectors.column(k) / eigen.eigenvalues[k].abs().sqrt())
        .collect();
    (DMatrix::from_columns(&columns), values)
}

#[cfg(test)]
mod tests {
    use super::{exactly, least, most, tight};

    #[test]
    fn figures_hold_within_their_bounds() {
        let holds = [most("", -1.0, 2.0), tight("", 0.2, 2.0), least("", 2.0, 2.0)];
        assert!(holds.iter().all(|figure| figure.holds) && exactly("", 3, 3).holds);
        let broken = [tight("", 0.19, 2.0), tight("", 3.0, 2.0), least("", 1.0, 2.0)];
        let nan = [most, tight, least].map(|figure| figure("", f64::NAN, 2.0));
        assert!(!broken.iter().chain(&nan).any(|figure| figure.holds) && !exactly("", 2, 3).holds);
    }
}
