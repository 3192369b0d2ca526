//! Shared by the tests of reading: dense formulas by another library, how far two lists of numbers
//! are apart, an object of some hundred normals with the runtime over its pixels, and part of a
//! sphere's image with the shipped scene cut small.
#![allow(dead_code, reason = "each test takes the parts that it needs")]

pub(crate) use crate::{oracle, tolerances};

use crate::oracle::Numbers;
use eigenshade::index::{light, material};
use eigenshade::{GeneralBasis, Light, Material, Normal};
use eigenshade_generator::basis;
use eigenshade_generator::basis::general;
use eigenshade_generator::basis::moments::LightStatistics;
use eigenshade_generator::basis::moments::{MaterialMoments, equal};
use eigenshade_generator::object::geometry::{Geometry, WeightedNormals};
use eigenshade_generator::reading::light_estimate::Explained;
use eigenshade_generator::reading::modes::ModeCoefficients;
use eigenshade_generator::reading::observation::{EigenimageValues, Observation, Observer};
use eigenshade_generator::reading::posterior::Prior;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_model::database::Named;
use eigenshade_model::irradiance;
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::{AnyBasis, OwnedBasis};
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation};
use nalgebra::{DMatrix, DVector};
use std::path::Path;

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

pub const DEGREE: usize = 4;
pub const ORDER: usize = 3;

/// An object of some hundred normals, and its table.
pub struct Object {
    pub loaded: Loaded,
    pub normals: WeightedNormals,
    pub table: Table,
}

impl Object {
    pub fn new(criterion: Criterion, rotation: LightRotation, components: usize) -> Self {
        let mut loaded = scene_file::load(Path::new("tables/curet.toml")).expect("a scene");
        loaded.lights = loaded.lights.truncated(DEGREE);
        loaded.materials = loaded.materials.truncated(ORDER);
        loaded.lights.entries.truncate(12);
        loaded.materials.entries.truncate(20);
        let scene = &mut loaded.scene;
        (scene.light.degree, scene.material.order) = (DEGREE, ORDER);
        (scene.basis.criterion, scene.light.rotation) = (criterion, rotation);
        scene.basis.components = Some(components);
        scene.basis.profile_tolerance = 1e-13;
        let mut numbers = Numbers(3);
        let pairs = std::iter::from_fn(|| Some((numbers.normal(), 1.5 + numbers.next())));
        let pairs = pairs.filter(|([x, _, _], _)| *x > -0.4).take(COUNT);
        let normals = WeightedNormals::new(pairs).expect("normals");
        let geometry = Geometry::Listed(normals.clone());
        let (lights, materials) = (&loaded.lights, &loaded.materials);
        let table = general::build(&loaded.scene, &geometry, lights, materials).expect("a table");
        Self { loaded, normals, table }
    }

    /// The runtime's basis, its d and images.
    fn with_basis<T>(&self, work: impl FnOnce(GeneralBasis<'_, f64>) -> T) -> T {
        match OwnedBasis::<f64>::new(&self.table).any().expect("a basis") {
            AnyBasis::General(basis) => work(basis),
            AnyBasis::Sphere(_) => panic!("a table of the sphere"),
        }
    }

    /// d of lights on materials, (material, light) -> d.
    pub fn projected(&self, pairs: &[(&[f64], &[f64])]) -> Vec<DVector<f64>> {
        self.with_basis(|basis| {
            let mut workspace = vec![0.0; basis.workspace_len()];
            let project = |(light, material): &(&[f64], &[f64])| {
                let mut d = DVector::zeros(basis.components());
                let light = Light::new(light).expect("a light");
                let material = Material::new(material).expect("a material");
                basis
                    .project_into(&light, &material, &mut workspace, d.as_mut_slice())
                    .expect("a projection");
                d
            };
            pairs.iter().map(project).collect()
        })
    }

    /// √W E and √W m by the runtime.
    pub fn dense(&self) -> (DMatrix<f64>, DVector<f64>) {
        self.with_basis(|basis| {
            let mut workspace = vec![0.0; basis.workspace_len()];
            let mut value = |d: &[f64], pixel: usize| {
                let [x, y, z] = self.normals.normals()[pixel];
                let normal = Normal::new(x, y, z).expect("a visible normal");
                let value = basis.reconstruct(d, normal, &mut workspace).expect("an image");
                self.normals.weights()[pixel].sqrt() * value
            };
            let mut unit = vec![0.0; basis.components()];
            let mean = DVector::from_fn(COUNT, |pixel, _| value(&unit, pixel));
            let mut design = DMatrix::zeros(COUNT, basis.components());
            for component in 0..basis.components() {
                unit[component] = 1.0;
                for pixel in 0..COUNT {
                    design[(pixel, component)] = value(&unit, pixel) - mean[pixel];
                }
                unit[component] = 0.0;
            }
            (design, mean)
        })
    }

    /// The direct sum of a light on a material at the object's normals.
    pub fn image(&self, light: &[f64], material: &[f64]) -> DVector<f64> {
        let reference = DirectSum::new(DEGREE, ORDER);
        let value = |pixel: usize| {
            let modes = reference.at(self.normals.normals()[pixel]);
            modes.irradiance(light, &modes.scatter(material))
        };
        DVector::from_fn(COUNT, |pixel, _| value(pixel))
    }

    pub fn rooted(&self, image: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(COUNT, |pixel, _| self.normals.weights()[pixel].sqrt() * image[pixel])
    }

    pub fn observe(&self, image: &DVector<f64>) -> Observation {
        let values = EigenimageValues::new(&self.table, usize::MAX);
        let mut observer = Observer::new(values, 1);
        let weights = self.normals.weights();
        for ((normal, value), weight) in self.normals.normals().iter().zip(image).zip(weights) {
            observer.see(*normal, &[*value], *weight);
        }
        observer.finish()
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

    pub fn prior(&self) -> (Transfers, Prior) {
        let transfers = Transfers::new(&self.table, usize::MAX);
        let lights = &self.loaded.lights;
        let (normalize, rotation) =
            (self.loaded.scene.light.normalize, self.loaded.scene.light.rotation);
        let weights = equal(lights.entries.len());
        let light =
            LightStatistics::new(lights, normalize, rotation, &weights).expect("statistics");
        let materials = MaterialMoments::new(&self.loaded.materials);
        let prior = Prior::new(&self.table, &transfers, &light, materials).expect("a prior");
        (transfers, prior)
    }
}

/// The shipped databases, cut to a degree and an order, and their table.
pub fn small(criterion: Criterion, components: usize) -> (Loaded, Table) {
    let mut loaded = scene_file::load(Path::new("tables/curet.toml")).expect("a scene");
    loaded.lights = loaded.lights.truncated(4);
    loaded.materials = loaded.materials.truncated(3);
    let scene = &mut loaded.scene;
    (scene.light.degree, scene.material.order) = (4, 3);
    scene.basis.criterion = criterion;
    scene.basis.components = Some(components);
    scene.basis.profile_tolerance = 1e-13;
    let table = basis::build(&loaded.scene, &loaded.lights, &loaded.materials).expect("a table");
    (loaded, table)
}

/// Pixels of half a sphere, seen twice as well above as below.
pub struct Pixels {
    pub normals: Vec<[f64; 3]>,
    pub image: Vec<f64>,
    pub weights: Vec<f64>,
}

pub fn pixels(loaded: &Loaded, seed: u64) -> Pixels {
    let mut numbers = Numbers(seed);
    let reference = eigenshade_model::reference::DirectSum::new(4, 3);
    let light = loaded.lights.entries[4].luminance();
    let coefficients = loaded.materials.entries[6].luminance();
    let mut pixels = Pixels { normals: vec![], image: vec![], weights: vec![] };
    while pixels.normals.len() < COUNT {
        let normal @ [x, y, _] = numbers.normal();
        if x < -0.2 {
            continue;
        }
        let modes = reference.at(normal);
        let value = modes.irradiance(&light, &modes.scatter(&coefficients));
        pixels.normals.push(normal);
        pixels.image.push(value + NOISE * numbers.next());
        pixels.weights.push(if y > 0.0 { 2.0 } else { 0.5 });
    }
    pixels
}

pub fn observe(table: &Table, pixels: &Pixels) -> Observation {
    let values = EigenimageValues::new(table, table.components.len());
    let mut observer = Observer::new(values, 1);
    for ((normal, value), weight) in pixels.normals.iter().zip(&pixels.image).zip(&pixels.weights) {
        observer.see(*normal, &[*value], *weight);
    }
    observer.finish()
}

/// √W E, √W m and √W I, by the runtime.
pub fn dense(table: &Table, pixels: &Pixels) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().expect("a basis");
    let components = table.components.len();
    let value = |d: &[f64], pixel: usize| {
        let [x, y, z] = pixels.normals[pixel];
        let normal = Normal::new(x, y, z).expect("a visible normal");
        pixels.weights[pixel].sqrt() * basis.reconstruct(d, normal).expect("an image")
    };
    let mean = DVector::from_fn(COUNT, |pixel, _| value(&vec![0.0; components], pixel));
    let design = DMatrix::from_fn(COUNT, components, |pixel, component| {
        let mut unit = vec![0.0; components];
        unit[component] = 1.0;
        value(&unit, pixel) - mean[pixel]
    });
    let image =
        DVector::from_fn(COUNT, |pixel, _| pixels.weights[pixel].sqrt() * pixels.image[pixel]);
    (design, mean, image)
}

pub fn prior(loaded: &Loaded, table: &Table) -> (Transfers, Prior) {
    let transfers = Transfers::new(table, table.components.len());
    let light = &loaded.scene.light;
    let weights = equal(loaded.lights.entries.len());
    let light = LightStatistics::new(&loaded.lights, light.normalize, light.rotation, &weights)
        .expect("statistics");
    let prior = Prior::new(table, &transfers, &light, MaterialMoments::new(&loaded.materials))
        .expect("a prior");
    (transfers, prior)
}
