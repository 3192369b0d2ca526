//! What the tests of reading share: dense formulas by another library, and how far two
//! lists of numbers are apart.
#![allow(dead_code, reason = "each test takes the parts that it needs")]

pub mod sphere;

pub mod object;

pub(crate) use crate::{oracle, tolerances};

use eigenshade::index::{light, material};
use eigenshade_generator::reading::light_estimate::Explained;
use eigenshade_generator::reading::modes::ModeCoefficients;
use eigenshade_model::irradiance;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};

pub const CRITERIA: [Criterion; 2] = [Criterion::ImageCentered, Criterion::Standard];
/// Pixels of an image.
pub const COUNT: usize = 300;
/// Standard deviation of a pixel.
pub const NOISE: f64 = 0.01;

pub fn to_dense(matrix: &faer::Mat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// Largest difference, of the largest number expected.
pub fn apart<'a>(
    found: impl IntoIterator<Item = &'a f64>,
    expected: impl IntoIterator<Item = &'a f64>,
) -> f64 {
    let (found, expected): (Vec<_>, Vec<_>) =
        (found.into_iter().collect(), expected.into_iter().collect());
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    found.iter().zip(&expected).fold(0.0f64, |most, (a, b)| most.max((*a - *b).abs())) / largest
}

#[track_caller]
pub fn assert_near(what: &str, found: f64, allowed: f64) {
    println!("{what}: {found:.1e}");
    assert!(found <= allowed, "{what}: {found:e} > {allowed:e}");
}

/// Σ c_s E_s at a normal, (16), mode by mode.
pub fn image_of_modes(c: &ModeCoefficients, [x, y, z]: [f64; 3]) -> f64 {
    let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
    let mut sum = 0.0;
    for (row, (l, m)) in light::indices(c.degree).enumerate() {
        for (column, (o, p, q)) in material::indices(c.order).enumerate() {
            if q <= l {
                sum += c.values[(row, column)] * irradiance::value(l, m, o, p, q, alpha, beta);
            }
        }
    }
    sum
}

/// An image of one material under unknown light: √W I = s E T L + noise, L of this mean and
/// covariance.
pub struct LitImage {
    /// √W E T, a column for each coefficient of the light.
    pub images: DMatrix<f64>,
    /// What is left of √W I without what light does not change.
    pub target: DVector<f64>,
    pub mean: DVector<f64>,
    pub covariance: DMatrix<f64>,
    /// Standard deviation of a number of the target.
    pub noise: f64,
}

impl LitImage {
    /// The posterior mean of s L, and log N(I; s E T L, s² E T P (E T)ᵀ + noise²) without
    /// that of white noise.
    pub fn explain(&self, s: f64) -> (DVector<f64>, f64) {
        let cross = s * s * &self.covariance * self.images.transpose();
        let count = self.target.len();
        let white = DMatrix::identity(count, count) * self.noise * self.noise;
        let left = &self.target - s * &self.images * &self.mean;
        let cholesky = (&self.images * &cross + white).cholesky().expect("a positive matrix");
        let solved = cholesky.solve(&left);
        let roots = cholesky.l();
        let logs: f64 = (0..count).map(|k| 2.0 * (roots[(k, k)] / self.noise).ln()).sum();
        (s * &self.mean + cross * &solved, -0.5 * (left.dot(&solved) + logs))
    }
}

/// The light that was found is the dense formula's, and its exposure the likeliest.
pub fn assert_likeliest(image: &LitImage, found: &Explained) {
    let (expected, evidence) = image.explain(found.exposure);
    assert_near("light", apart(&found.light, &expected), tolerances::READ_POSTERIOR);
    let far = apart([&found.evidence], [&evidence]);
    assert_near("evidence", far, tolerances::READ_POSTERIOR);
    for other in [0.5, 0.9, 1.1, 2.0] {
        let other = image.explain(other * found.exposure).1;
        assert!(other < evidence, "not the likeliest exposure");
    }
}
