//! The direct sum (15) with its weakest terms left out, and the error that this can cause (4.4).
//!
//! A term c_s E_s has the size |c_s| √m_ss, the root of its variance (2.4). Leaving out a set D of
//! terms changes the image by Σ_D c_s E_s. The sizes give
//!
//! * the triangle bound: the norm is at most the sum of the sizes;
//! * the bound by azimuth: images of different m are orthogonal, so the squared norm is at most the
//!   sum over m of the squared sums of the sizes of that m. It never exceeds the triangle bound;
//! * the root of the sum of the squared sizes, which would be the norm if the terms were
//!   orthogonal. They are not, so it is not a bound.

use eigenshade_table::{GramFactor, light, material, mode};

/// The modes with their sizes, prepared for any light and material.
#[derive(Clone, Debug)]
pub struct PartialSum<'a> {
    gram: &'a GramFactor,
    /// The columns of A, by |m|.
    columns: Vec<Vec<Vec<f64>>>,
    /// √m_ss, by |m|.
    roots: Vec<Vec<f64>>,
    /// Whether a selection keeps each mode, by |m|.
    kept: Vec<Vec<bool>>,
}

/// The error and the bounds of one partial sum; norms are root mean squares over the normals.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Number of terms in the sum, with both signs of m included.
    pub terms: usize,
    /// The norm of the omitted terms.
    pub error: f64,
    /// The bound by azimuth.
    pub bound: f64,
    /// The triangle bound.
    pub triangle: f64,
    /// The root of the sum of the squared sizes.
    pub uncorrelated: f64,
}

/// One term c_s E_s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Term {
    /// l, m, o, p, q.
    pub mode: (usize, isize, usize, usize, usize),
    /// c_s, which is L_l^m times b_op^q.
    pub coefficient: f64,
    /// |c_s| √m_ss.
    pub size: f64,
    /// Index among the modes of its |m|.
    place: usize,
    is_kept: bool,
}

impl<'a> PartialSum<'a> {
    /// Prepares the modes of `gram`. `kept` selects modes in the layout of `Table::selection`, and
    /// empty selects all. Modes that are not selected are left out of every sum.
    pub fn new(gram: &'a GramFactor, kept: &[bool]) -> Self {
        let azimuths = 0..=gram.degree;
        let columns: Vec<_> = azimuths.clone().map(|azimuth| gram.columns(azimuth)).collect();
        let norm = |column: &Vec<f64>| column.iter().map(|a| a * a).sum::<f64>().sqrt();
        let keeps = |azimuth| {
            mode::indices(gram.degree, gram.order, azimuth)
                .map(|(l, o, p, q)| kept.is_empty() || kept[gram.place(azimuth, l, o, p, q)])
                .collect()
        };
        Self {
            gram,
            roots: columns.iter().map(|columns| columns.iter().map(norm).collect()).collect(),
            kept: azimuths.map(keeps).collect(),
            columns,
        }
    }

    /// Every partial sum of a light on a material of the degree and order of the Gram factor, from
    /// all terms that the selection keeps down to none. The weakest terms are left out first.
    ///
    /// Terms of equal size are left out in the order of m, then of the modes.
    pub fn steps(&self, light: &[f64], material: &[f64]) -> Vec<Step> {
        let terms = self.terms(light, material);
        let orders = 2 * self.gram.degree + 1;
        let mut missing = vec![vec![0.0; self.gram.nodes.len()]; orders];
        let (mut squares, mut sums) = (vec![0.0; orders], vec![0.0; orders]);
        let mut sum_of_squares = 0.0;
        let mut left = terms.iter().filter(|term| term.is_kept).count();
        let note = |terms: usize, squares: &[f64], sums: &[f64], sum_of_squares: f64| Step {
            terms,
            error: squares.iter().sum::<f64>().sqrt(),
            bound: sums.iter().map(|sum| sum * sum).sum::<f64>().sqrt(),
            triangle: sums.iter().sum(),
            uncorrelated: sum_of_squares.sqrt(),
        };
        let mut steps = Vec::new();
        for term in &terms {
            if term.is_kept {
                steps.push(note(left, &squares, &sums, sum_of_squares));
                left -= 1;
            }
            let m = term.mode.1;
            let place = self.gram.degree.saturating_add_signed(m);
            let column = &self.columns[m.unsigned_abs()][term.place];
            // f of -m is (-1)^m times f of m.
            let coefficient =
                if m < 0 && m % 2 != 0 { -term.coefficient } else { term.coefficient };
            let values = &mut missing[place];
            values.iter_mut().zip(column).for_each(|(value, a)| *value += coefficient * a);
            squares[place] = values.iter().map(|value| value * value).sum();
            sums[place] += term.size;
            sum_of_squares += term.size * term.size;
        }
        steps.push(note(left, &squares, &sums, sum_of_squares));
        steps
    }

    /// The terms that the selection keeps, strongest first. The first n of them form the sum of
    /// [`steps`](Self::steps) with n terms.
    pub fn strongest(&self, light: &[f64], material: &[f64]) -> Vec<Term> {
        let terms = self.terms(light, material);
        terms.into_iter().rev().take_while(|term| term.is_kept).collect()
    }

    /// Every term: first those that no sum includes, then from weak to strong. Terms of equal size
    /// are sorted by m, then in the order of the modes.
    fn terms(&self, light: &[f64], material: &[f64]) -> Vec<Term> {
        let top = self.gram.degree.cast_signed();
        let mut terms = Vec::new();
        for m in -top..=top {
            let azimuth = m.unsigned_abs();
            let modes = mode::indices(self.gram.degree, self.gram.order, azimuth);
            for (place, (l, o, p, q)) in modes.enumerate() {
                let b = material[material::position(o, p, q)];
                let coefficient = light[light::position(l, m)] * b;
                let size = coefficient.abs() * self.roots[azimuth][place];
                let is_kept = self.kept[azimuth][place];
                terms.push(Term { mode: (l, m, o, p, q), coefficient, size, place, is_kept });
            }
        }
        terms.sort_by(|a, b| a.is_kept.cmp(&b.is_kept).then(a.size.total_cmp(&b.size)));
        terms
    }
}
