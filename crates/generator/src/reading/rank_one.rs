//! Factors c into light and material: the best L (x) b by least squares over the modes that exist.
//!
//! Modes with q > l do not exist, so those entries of the matrix are missing rather than zero, and
//! a singular value decomposition alone is not enough. L and b are solved for alternately, each
//! exactly, which never increases the error. The iteration may end in a local minimum, so it is run
//! from two starts and the better result is used.
//!
//! L (x) b does not change if L is multiplied by a number and b divided by it. Here b has length 1
//! and b_00^0 >= 0; [`RankOne::scaled_to`] uses the scale of a known material instead.

use super::linear::decompose;
use super::modes::ModeCoefficients;
use eigenshade_model::error::Result;
use eigenshade_table::light;
use faer::Mat;

/// Maximum number of alternations.
const TURNS: usize = 10_000;

/// The iteration has converged when an alternation lowers the error by less than this fraction of
/// it.
const SETTLED: f64 = 1e-14;

/// A light and a material whose product approximates c.
#[derive(Clone, Debug, PartialEq)]
pub struct RankOne {
    /// L_l^m in the order of [`eigenshade_table::light`].
    pub light: Vec<f64>,
    /// b_op^q in the order of [`eigenshade_table::material`].
    pub material: Vec<f64>,
    /// |c - L (x) b|² / |c|², over the modes that exist; 0 for c = 0.
    pub left: f64,
    /// Whether the iteration converged: the last alternation lowered the error by less than 1e-14
    /// of it. If false, the product is the best found within the limit.
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

    /// Like [`RankOne::of`], with at most `turns` alternations instead of 10,000.
    ///
    /// # Errors
    ///
    /// The errors of [`RankOne::of`].
    pub fn within(c: &ModeCoefficients, turns: usize) -> Result<Self> {
        // One start is the whole matrix with zeros, good if little is missing. The other is the
        // complete rows, correct if c is a product.
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

    /// Rescales the product so that b has the scale of the most similar material, which is the one
    /// with the largest cosine to b. Coefficients beyond either's order are ignored. b is then as
    /// near to that material as a scale factor can bring it, and L is true radiance to the extent
    /// that the object has that material's albedo. Returns the index of the material, or `None` if
    /// all are at right angles to b or there are none, and the scale stays.
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

    /// Multiplies b by a factor and divides L by it.
    fn rescale(&mut self, factor: f64) {
        self.material.iter_mut().for_each(|b| *b *= factor);
        self.light.iter_mut().for_each(|l| *l /= factor);
    }
}

/// The first right singular vector.
fn first_right(matrix: &Mat<f64>) -> Result<Vec<f64>> {
    Ok(decompose(matrix)?.V().col(0).iter().copied().collect())
}

/// L, b, the squared error, and whether the iteration converged.
type Found = (Vec<f64>, Vec<f64>, f64, bool);

/// Solves for L and b alternately from this b, at most `turns` times.
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
        // Before the first alternation the error is infinite, so this never holds then.
        if left >= (1.0 - SETTLED) * before {
            return (light, material, left, true);
        }
        before = left;
    }
    (light, material, before, false)
}

/// The x that minimizes Σ (c - x b)² over pairs (c, b).
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
