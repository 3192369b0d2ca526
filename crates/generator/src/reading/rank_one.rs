//! c into light and material: the best L (x) b, in the sense of least squares over
//! the modes that exist.
//!
//! Modes with q > l do not exist, so those entries of the matrix are missing, not
//! zero: a singular value decomposition alone does not do. L and b are solved for in
//! turn, each exactly, which never raises the error. It may end in a minimum that is
//! not the least: of two starts the better end is taken.
//!
//! L (x) b stays the same when L is multiplied by a number and b divided by it. Here
//! b has length 1 and b_00^0 >= 0; [`RankOne::scaled_to`] gives it the scale of a
//! known material instead.

use super::coefficients::decompose;
use super::modes::ModeCoefficients;
use eigenshade_index::light;
use eigenshade_model::error::Result;
use faer::Mat;

/// Turns at most.
const TURNS: usize = 10_000;

/// It has converged where a turn lowers the error by less than this share of it.
const SETTLED: f64 = 1e-14;

/// A light and a material whose product is near c.
#[derive(Clone, Debug, PartialEq)]
pub struct RankOne {
    /// L_l^m in the order of [`eigenshade_index::light`].
    pub light: Vec<f64>,
    /// b_op^q in the order of [`eigenshade_index::material`].
    pub material: Vec<f64>,
    /// |c - L (x) b|² / |c|², over the modes that exist; 0 for c = 0.
    pub left: f64,
    /// Whether the turns came to an end: the last lowered the error by less than 1e-14
    /// of it. If not, the product is as near as the turns bring it.
    pub has_converged: bool,
}

impl RankOne {
    /// The best product of c.
    ///
    /// # Errors
    ///
    /// If the singular values of c do not converge (a number that is not finite).
    pub fn of(c: &ModeCoefficients) -> Result<Self> {
        Self::within(c, TURNS)
    }

    /// The same with another limit than 10,000 turns.
    ///
    /// # Errors
    ///
    /// As of [`RankOne::of`].
    pub fn within(c: &ModeCoefficients, turns: usize) -> Result<Self> {
        // From the whole with zeros, good where little is missing, and from the rows
        // that lack nothing, right where c is a product.
        let complete = light::count(c.order.saturating_sub(1)).min(c.values.nrows() - 1);
        let mut best = solve(c, first_right(&c.values)?, turns);
        if c.order > 0 {
            let rows = c.values.get(complete.., ..).to_owned();
            let other = solve(c, first_right(&rows)?, turns);
            best = if other.2 < best.2 { other } else { best };
        }
        let (light, material, left, has_converged) = best;
        let whole = c.values.squared_norm_l2();
        let share = if whole > 0.0 { left / whole } else { 0.0 };
        let length = material.iter().map(|b| b * b).sum::<f64>().sqrt();
        let sign = if material.first().is_some_and(|b| *b < 0.0) { -1.0 } else { 1.0 };
        let mut product = Self { light, material, left: share, has_converged };
        product.rescale(if length > 0.0 { sign / length } else { 1.0 });
        Ok(product)
    }

    /// The same product, b in the scale of the material that it is most like (the
    /// one with the largest cosine to b, coefficients beyond either's order apart):
    /// b is then as near to it as a factor can bring it, and L in true radiance as
    /// far as that material's albedo is the object's. Returns which it is; none if
    /// all are at right angles to b or there are none.
    pub fn scaled_to(&mut self, materials: &[Vec<f64>]) -> Option<usize> {
        let alike = |known: &Vec<f64>| {
            let product: f64 = known.iter().zip(&self.material).map(|(a, b)| a * b).sum();
            let length = known.iter().map(|a| a * a).sum::<f64>().sqrt();
            (product, if length > 0.0 { product / length } else { 0.0 })
        };
        let (nearest, (product, cosine)) =
            materials.iter().map(alike).enumerate().max_by(|(_, a), (_, b)| a.1.total_cmp(&b.1))?;
        if cosine <= 0.0 {
            return None;
        }
        let square: f64 = self.material.iter().map(|b| b * b).sum();
        self.rescale(product / square);
        Some(nearest)
    }

    /// b times a factor, L divided by it.
    fn rescale(&mut self, factor: f64) {
        self.material.iter_mut().for_each(|b| *b *= factor);
        self.light.iter_mut().for_each(|l| *l /= factor);
    }
}

/// The first right singular vector.
fn first_right(matrix: &Mat<f64>) -> Result<Vec<f64>> {
    Ok(decompose(matrix)?.V().col(0).iter().copied().collect())
}

/// L, b, the square of the error, and whether the turns came to an end.
type Found = (Vec<f64>, Vec<f64>, f64, bool);

/// L and b solved for in turn from this b, so many times at most.
fn solve(c: &ModeCoefficients, mut material: Vec<f64>, turns: usize) -> Found {
    let exists = c.exists();
    let (rows, columns) = (c.values.nrows(), c.values.ncols());
    let mut light = vec![0.0; rows];
    let mut before = f64::INFINITY;
    for _ in 0..turns {
        for (row, light) in light.iter_mut().enumerate() {
            let pairs = (0..columns).filter(|&column| exists(row, column));
            *light = ratio(pairs.map(|column| (c.values[(row, column)], material[column])));
        }
        for (column, material) in material.iter_mut().enumerate() {
            let pairs = (0..rows).filter(|&row| exists(row, column));
            *material = ratio(pairs.map(|row| (c.values[(row, column)], light[row])));
        }
        let left = left(c, &light, &material);
        // Of no number before the first, an infinite one, no share is reached.
        if left >= (1.0 - SETTLED) * before {
            return (light, material, left, true);
        }
        before = left;
    }
    (light, material, before, false)
}

/// The x that minimises Σ (c - x b)² over pairs (c, b).
fn ratio(pairs: impl Iterator<Item = (f64, f64)>) -> f64 {
    let (product, square) =
        pairs.fold((0.0, 0.0), |(product, square), (c, b)| (product + c * b, square + b * b));
    if square > 0.0 { product / square } else { 0.0 }
}

fn left(c: &ModeCoefficients, light: &[f64], material: &[f64]) -> f64 {
    let exists = c.exists();
    let mut sum = 0.0;
    for (column, b) in material.iter().enumerate() {
        for (row, l) in light.iter().enumerate() {
            if exists(row, column) {
                sum += (c.values[(row, column)] - l * b).powi(2);
            }
        }
    }
    sum
}
