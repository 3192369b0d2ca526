//! Shared by the tests of reading: half a sphere with the runtime over its pixels, dense formulas by
//! another library, and how far two lists of numbers are apart.

use crate::oracle::Numbers;
use crate::tolerances;
use eigenshade_generator::basis::moments::{LightMoments, MaterialMoments};
use eigenshade_generator::reading::light_estimate::Explained;
use eigenshade_generator::reading::modes::ModeCoefficients;
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_generator::reading::posterior::{Estimate, Posterior, Prior};
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::database::Named;
use eigenshade_model::irradiance;
use eigenshade_model::reference::DirectSum;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, light, material};
use eigenshade_testing::fixtures::{self, Projector};
use eigenshade_testing::largest;
use nalgebra::{DMatrix, DVector};

pub const CRITERIA: [Criterion; 2] = [Criterion::ImageCentered, Criterion::Standard];
/// Pixels of an image.
pub const COUNT: usize = 300;
/// Standard deviation of a pixel.
const NOISE: f64 = 0.01;

const DEGREE: usize = 4;
const ORDER: usize = 3;
const LIGHT: usize = light::count(DEGREE);

pub fn to_dense(matrix: &faer::Mat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// Largest difference, of the largest number expected.
pub fn apart<'a>(
    found: impl IntoIterator<Item = &'a f64>,
    expected: impl IntoIterator<Item = &'a f64>,
) -> f64 {
    let (found, expected): (Vec<f64>, Vec<f64>) =
        (found.into_iter().copied().collect(), expected.into_iter().copied().collect());
    eigenshade_testing::relative_error(&found, &expected)
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

/// The shipped databases, cut to a degree and an order.
pub fn scene(criterion: Criterion, components: usize) -> Loaded {
    let mut loaded = fixtures::shipped("curet");
    loaded.lights = loaded.lights.truncated(DEGREE);
    loaded.materials = loaded.materials.truncated(ORDER);
    let scene = &mut loaded.scene;
    (scene.light.degree, scene.material.order) = (DEGREE, ORDER);
    (scene.basis.criterion, scene.basis.components) = (criterion, Some(components));
    scene.basis.profile_tolerance = 1e-13;
    loaded
}

/// The pixels of half a sphere, and its table.
pub struct Subject {
    pub loaded: Loaded,
    pub table: Table,
    pub normals: Vec<[f64; 3]>,
    pub weights: Vec<f64>,
    projector: Projector,
}

impl Subject {
    /// Half a sphere, seen twice as well above as below.
    pub fn new(criterion: Criterion, components: usize) -> Self {
        let loaded = scene(criterion, components);
        let table = fixtures::table(&loaded);
        let mut numbers = Numbers(3);
        let normals = std::iter::from_fn(|| Some(numbers.normal()));
        let normals: Vec<_> = normals.filter(|[x, ..]| *x > -0.2).take(COUNT).collect();
        let weights = normals.iter().map(|[_, y, _]| if *y > 0.0 { 2.0 } else { 0.5 }).collect();
        let projector = Projector::new(&table);
        Self { loaded, table, normals, weights, projector }
    }

    /// d by the runtime.
    pub fn project(&self, light: &[f64], material: &[f64]) -> DVector<f64> {
        DVector::from_vec(self.projector.project(light, material))
    }

    /// d of no light: minus the components of the mean image.
    pub fn dark(&self) -> DVector<f64> {
        self.project(&[0.0; LIGHT], &self.pair().1)
    }

    /// A vector times the roots of the weights.
    pub fn rooted(&self, image: &[f64]) -> DVector<f64> {
        let values = image.iter().zip(&self.weights);
        DVector::from_iterator(COUNT, values.map(|(value, weight)| weight.sqrt() * value))
    }

    /// √W E and √W m by the runtime.
    pub fn dense(&self) -> (DMatrix<f64>, DVector<f64>) {
        let image = |k| self.rooted(&self.projector.eigenimage(k, &self.normals));
        let columns: Vec<_> = (0..self.table.count()).map(image).collect();
        let mean = self.rooted(&self.projector.shade(&[], &self.normals));
        (DMatrix::from_columns(&columns), mean)
    }

    /// The fifth light, at L_0^0 = 1 like all, and the seventh material.
    pub fn pair(&self) -> (Vec<f64>, Vec<f64>) {
        (self.lights()[4].clone(), self.loaded.materials.entries[6].luminance())
    }

    pub fn lights(&self) -> Vec<Vec<f64>> {
        let unit = |entry: &Named| {
            let light = entry.luminance();
            light.iter().map(|value| value / light[0]).collect()
        };
        self.loaded.lights.entries.iter().map(unit).collect()
    }

    /// The direct sum of that pair.
    pub fn image(&self) -> Vec<f64> {
        let (reference, (light, material)) = (DirectSum::new(DEGREE, ORDER), self.pair());
        let value = |&normal: &[f64; 3]| {
            let modes = reference.at(normal);
            modes.irradiance(&light, &modes.scatter(&material))
        };
        self.normals.iter().map(value).collect()
    }

    /// The same with noise.
    pub fn noisy(&self) -> Vec<f64> {
        let mut numbers = Numbers(11);
        self.image().into_iter().map(|value| value + NOISE * numbers.next()).collect()
    }

    /// Standard deviation of a pixel times the root of its weight.
    pub fn noise(&self) -> f64 {
        NOISE * (self.weights.iter().sum::<f64>() / COUNT as f64).sqrt()
    }

    pub fn observe(&self, image: &[f64]) -> Observation {
        let values = EigenimageValues::new(&self.table, self.table.count());
        let mut observer = Observer::new(values, 1);
        for ((normal, value), weight) in self.normals.iter().zip(image).zip(&self.weights) {
            observer.see(*normal, &[*value], *weight);
        }
        observer.finish()
    }

    pub fn prior(&self) -> (Transfers, Prior) {
        let transfers = Transfers::new(&self.table, usize::MAX);
        let (lights, normalize) = (&self.loaded.lights, self.loaded.scene.light.normalize);
        let light = LightMoments::new(lights, normalize);
        let materials = MaterialMoments::new(&self.loaded.materials);
        let prior = Prior::new(&self.table, &transfers, &light.expect("moments"), materials);
        (transfers, prior.expect("a prior"))
    }

    /// The posterior estimate of an image with this noise.
    pub fn estimate(&self, image: &[f64], noise: f64) -> Estimate {
        let (observation, (_, prior)) = (self.observe(image), self.prior());
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        posterior.estimate(0, noise)
    }

    /// The mean square of a coefficient of degree l.
    fn power(&self, l: usize) -> f64 {
        let lights = self.lights();
        let square =
            |light: &Vec<f64>| light[l * l..(l + 1) * (l + 1)].iter().map(|x| x * x).sum::<f64>();
        lights.iter().map(square).sum::<f64>() / (lights.len() * (2 * l + 1)) as f64
    }

    /// Mean and covariance of all rotations of the lights.
    pub fn statistics(&self) -> (DVector<f64>, DMatrix<f64>) {
        let mut center = DVector::zeros(LIGHT);
        // Every L_0^0 is 1.
        center[0] = 1.0;
        let power = light::indices(DEGREE).map(|(l, _)| if l == 0 { 0.0 } else { self.power(l) });
        (center, DMatrix::from_diagonal(&DVector::from_iterator(LIGHT, power)))
    }

    /// E{d dᵀ} by the runtime's projections of L_0^0, then of every harmonic alone.
    pub fn second_moment(&self) -> DMatrix<f64> {
        let dark = self.dark();
        let materials = &self.loaded.materials.entries;
        let mut moment = DMatrix::zeros(dark.len(), dark.len());
        for material in materials.iter().map(Named::luminance) {
            for (place, (l, _)) in light::indices(DEGREE).enumerate() {
                let mut light = vec![0.0; LIGHT];
                light[place] = self.power(l).sqrt();
                let mut d = self.project(&light, &material);
                // Every L_0^0 is 1: another harmonic alone is a difference from it.
                if place > 0 {
                    d -= &dark;
                }
                moment += &d * d.transpose() / materials.len() as f64;
            }
        }
        moment
    }

    /// √W E T: a column for each coefficient of the light.
    pub fn lit(&self, design: &DMatrix<f64>) -> DMatrix<f64> {
        let (dark, material) = (self.dark(), self.pair().1);
        let unit = DMatrix::<f64>::identity(LIGHT, LIGHT);
        let lights = unit.as_slice().chunks(LIGHT);
        let columns: Vec<_> = lights.map(|one| self.project(one, &material) - &dark).collect();
        design * DMatrix::from_columns(&columns)
    }

    /// The eigenvalue of each component; the constant has none.
    pub fn eigenvalues(&self) -> Vec<Option<f64>> {
        self.table.components.iter().map(|one| one.eigenvalue).collect()
    }
}

/// An image of one material under unknown light: √W I = s E T L + noise, L of this mean and
/// covariance.
pub struct LitImage {
    /// √W E T, a column for each coefficient of the light.
    pub images: DMatrix<f64>,
    /// √W I less the part that does not depend on the light.
    pub target: DVector<f64>,
    pub statistics: (DVector<f64>, DMatrix<f64>),
    /// Standard deviation of a number of the target.
    pub noise: f64,
}

impl LitImage {
    /// The posterior mean of s L, and log N(I; s E T L, s² E T P (E T)ᵀ + noise²) without
    /// that of white noise.
    fn explain(&self, s: f64) -> (DVector<f64>, f64) {
        let (mean, covariance) = &self.statistics;
        let cross = s * s * covariance * self.images.transpose();
        let count = self.target.len();
        let white = DMatrix::identity(count, count) * self.noise * self.noise;
        let left = &self.target - s * &self.images * mean;
        let cholesky = (&self.images * &cross + white).cholesky().expect("a positive matrix");
        let solved = cholesky.solve(&left);
        let roots = cholesky.l();
        let logs: f64 = (0..count).map(|k| 2.0 * (roots[(k, k)] / self.noise).ln()).sum();
        (s * mean + cross * &solved, -0.5 * (left.dot(&solved) + logs))
    }

    /// The light that was found is the dense formula's, and its exposure the likeliest.
    pub fn assert_likeliest(&self, found: &Explained) {
        let (expected, evidence) = self.explain(found.exposure);
        assert_near("light", apart(&found.light, &expected), tolerances::READ_POSTERIOR);
        let far = apart([&found.evidence], [&evidence]);
        assert_near("evidence", far, tolerances::READ_POSTERIOR);
        let others = [0.5, 0.9, 1.1, 2.0].map(|other| self.explain(other * found.exposure).1);
        assert!(others.iter().all(|other| *other < evidence), "not the likeliest exposure");
    }
}

/// The largest eigenvalue.
pub fn strongest(values: &[Option<f64>]) -> f64 {
    largest(values.iter().flatten().copied())
}
