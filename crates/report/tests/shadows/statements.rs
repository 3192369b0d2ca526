//! The statements of the paper for an object with shadows, in modes E_s of degree 3 and order 2 that are
//! summed pixel by pixel.

use super::{lights, surface};
use eigenshade_shadows::eigenimages::{Eigenimages, eigenimages};
use eigenshade_shadows::light_root::{LightRoot, Turns};
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::Object;
use eigenshade_table::material;
use faer::Mat;
use report::shadow_shapes::SHAPES;
use std::sync::LazyLock;

const DEGREE: usize = 3;
const COUNT: usize = 16;
const ORDER: usize = 2;

/// The exactness in f64, of the largest number.
const EXACT: f64 = 1e-10;

/// Components with a smaller share of the first variance are not compared over modes: M has rounding
/// errors of 1e-16 of that variance.
const LEAST: f64 = 1e-5;

/// The modes of an object, and a root of the covariance of their coefficients c = L ⊗ b.
struct Modes {
    /// E_s of each pixel: mode k of the light and j of the material is in column j `COUNT` + k.
    all: Mat<f64>,
    transports: Vec<Mat<f32>>,
    light: LightRoot,
    /// The deviations of the coefficients b.
    weights: Vec<f64>,
}

/// For each mode of the material the transports of the bowl.
static TRANSPORTS: LazyLock<Vec<Mat<f32>>> = LazyLock::new(|| {
    let (_, mesh) = SHAPES[5];
    let count = material::count(ORDER);
    let units: Vec<Vec<f64>> =
        (0..count).map(|j| (0..count).map(|k| f64::from(u8::from(j == k))).collect()).collect();
    let parts: Vec<Material<'_>> = units.iter().map(|one| Material::Series(one)).collect();
    let surface = surface(&mesh(), false);
    Object::new(&surface, 16, DEGREE, &parts, &()).unwrap().transports
});

impl Modes {
    fn new() -> Self {
        let (count, transports) = (material::count(ORDER), TRANSPORTS.clone());
        let light = LightRoot::new(&lights().truncated(DEGREE), Turns::All).unwrap();
        let weights = (0..count).map(|j| 1.0 / (1.0 + j as f64)).collect();
        Self { all: Self::all(&transports), transports, light, weights }
    }

    fn all(transports: &[Mat<f32>]) -> Mat<f64> {
        Mat::from_fn(transports[0].nrows(), COUNT * transports.len(), |row, s| {
            f64::from(transports[s / COUNT][(row, s % COUNT)])
        })
    }

    fn images(&self, rank: usize) -> Eigenimages {
        let transports: Vec<_> = self.transports.iter().map(Mat::as_ref).collect();
        eigenimages(&transports, &self.weights, &self.light, rank).unwrap()
    }

    /// M, a sum over pixels.
    fn gram(&self) -> Mat<f64> {
        let (count, modes) = (self.all.nrows(), self.all.ncols());
        let mut gram = Mat::zeros(modes, modes);
        for x in 0..count {
            for (s, t) in (0..modes).flat_map(|s| (0..modes).map(move |t| (s, t))) {
                gram[(s, t)] += self.all[(x, s)] * self.all[(x, t)] / count as f64;
            }
        }
        gram
    }

    /// L ⊗ b of some light and material.
    fn coefficients(&self) -> Vec<f64> {
        let light = &lights().truncated(DEGREE).entries[3].rgb[1];
        let material = (0..self.weights.len()).map(|j| (1.0 + j as f64).sin());
        material.flat_map(|b| light.iter().map(move |l| b * l)).collect()
    }
}

/// d of coefficients over modes.
fn projected(images: &Eigenimages, c: &[f64]) -> Vec<f64> {
    let of = |i: usize| {
        let parts = images.rows.iter().zip(c.chunks(COUNT));
        parts.map(|(rows, c)| (0..COUNT).map(|k| rows[(i, k)] * c[k]).sum::<f64>()).sum()
    };
    (0..images.pixels.ncols()).map(of).collect()
}

/// U over modes, each of mean square 1 over the pixels: C times the rows of d, over the deviation of d.
fn over_modes(modes: &Modes, images: &Eigenimages, kept: usize) -> Vec<Vec<f64>> {
    let covariance = &modes.light.root * &modes.light.root;
    let of = |i: usize| -> Vec<f64> {
        let scale = images.variances[i].sqrt().recip();
        let mode = |s: usize| {
            let (rows, weight) = (&images.rows[s / COUNT], modes.weights[s / COUNT]);
            let products = (0..COUNT).map(|k| covariance[(s % COUNT, k)] * rows[(i, k)]);
            scale * weight * weight * products.sum::<f64>()
        };
        (0..modes.all.ncols()).map(mode).collect()
    };
    (0..kept).map(of).collect()
}

fn product(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[test]
fn the_eigenbasis_of_an_object_is_that_of_the_paper() {
    let modes = Modes::new();
    let images = modes.images(usize::MAX);
    let Eigenimages { pixels, variances, .. } = &images;
    let kept = variances.iter().take_while(|&&one| one > LEAST * variances[0]).count();
    println!("{} pixels, {kept} of {} images", pixels.nrows(), variances.len());
    assert!(kept > 20 && variances.is_sorted_by(|a, b| a >= b));
    let gram = modes.gram();
    let u = over_modes(&modes, &images, kept);
    let with_gram: Vec<Vec<f64>> = u
        .iter()
        .map(|u| (0..u.len()).map(|s| (0..u.len()).map(|t| gram[(s, t)] * u[t]).sum()).collect())
        .collect();

    // UᵀMU = I.
    for (i, j) in (0..kept).flat_map(|i| (0..kept).map(move |j| (i, j))) {
        let found = product(&with_gram[i], &u[j]);
        assert!((found - f64::from(u8::from(i == j))).abs() < EXACT, "{i} {j}: {found}");
    }

    // d = UᵀMc; here d has unit variances.
    let c = modes.coefficients();
    let d = projected(&images, &c);
    let largest = d.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    for ((row, variance), expected) in with_gram.iter().zip(variances).zip(&d) {
        let found = product(row, &c) / variance.sqrt();
        assert!((found - expected).abs() < EXACT * largest, "{found}, {expected}");
    }

    // Σ d_i U_i is the direct sum of each pixel.
    let direct: Vec<f64> = (0..pixels.nrows())
        .map(|x| c.iter().enumerate().map(|(s, c)| c * modes.all[(x, s)]).sum())
        .collect();
    let white = direct.iter().fold(0.0, |most: f64, one| most.max(one.abs()));
    for (x, direct) in direct.iter().enumerate() {
        let found: f64 = d.iter().enumerate().map(|(i, d)| d * pixels[(x, i)]).sum();
        assert!((found - direct).abs() < EXACT * white, "{x}: {found}, {direct}");
    }

    // c = Ud of an image in the span has these coefficients again, (42).
    let d: Vec<f64> = (0..kept).map(|i| ((i * i) as f64).sin()).collect();
    let lifted: Vec<f64> = (0..c.len())
        .map(|s| (0..kept).map(|i| u[i][s] * variances[i].sqrt() * d[i]).sum())
        .collect();
    for (i, (found, expected)) in projected(&images, &lifted).iter().zip(&d).enumerate() {
        assert!((found - expected).abs() < EXACT, "{i}: {found}, {expected}");
    }
}

/// The variance that truncation to `kept` components leaves: the residual of each column of the root,
/// pixel by pixel.
fn left(modes: &Modes, kept: usize) -> f64 {
    let images = modes.images(kept);
    let count = modes.all.nrows();
    let mut sum = 0.0;
    for (j, k) in (0..modes.weights.len()).flat_map(|j| (0..COUNT).map(move |k| (j, k))) {
        let mut c = vec![0.0; modes.all.ncols()];
        (0..COUNT).for_each(|t| c[j * COUNT + t] = modes.weights[j] * modes.light.root[(t, k)]);
        let d = projected(&images, &c);
        for x in 0..count {
            let whole: f64 = c.iter().enumerate().map(|(s, c)| c * modes.all[(x, s)]).sum();
            let found: f64 = d.iter().enumerate().map(|(i, d)| d * images.pixels[(x, i)]).sum();
            sum += (whole - found).powi(2) / count as f64;
        }
    }
    sum
}

/// Under both criteria truncation leaves the variances of the other components: of images about the
/// mean over light, (17), and about their own mean over pixels, (18).
#[test]
fn truncation_leaves_the_other_variances() {
    let whole = Modes::new();
    // Light of a deviating mean radiance: its covariance in place of its second moment.
    let mut standard = Modes::new();
    let deviation = 0.3;
    standard.light.root[(0, 0)] *= deviation;
    standard.light.inverse[(0, 0)] /= deviation;
    let mut centered = Modes::new();
    for transport in &mut centered.transports {
        let count = transport.nrows();
        for k in 0..COUNT {
            let sum: f64 = (0..count).map(|x| f64::from(transport[(x, k)])).sum();
            (0..count).for_each(|x| transport[(x, k)] -= (sum / count as f64) as f32);
        }
    }
    centered.all = Modes::all(&centered.transports);
    for (name, modes) in [("whole", whole), ("(17)", standard), ("(18)", centered)] {
        let Eigenimages { pixels, variances, .. } = modes.images(usize::MAX);
        let total: f64 = variances.iter().sum();
        for kept in [1, 4, 16] {
            let expected: f64 = variances[kept..].iter().sum();
            let found = left(&modes, kept);
            println!("{name}, {kept}: {found:.3e} of {total:.3e}");
            assert!((found - expected).abs() < EXACT * total, "{found}, {expected}");
        }
        if name == "(18)" {
            // The constant is in no component: f32 rounds the centered transports.
            let sum = |i: usize| (0..pixels.nrows()).map(|x| pixels[(x, i)]).sum::<f64>();
            let most = 1e-6 * pixels.nrows() as f64 * variances[0].sqrt();
            assert!((0..16).all(|i| sum(i).abs() < most));
        }
    }
}
