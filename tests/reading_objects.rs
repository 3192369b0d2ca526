//! Reading with tables of an object, under light as captured, about the vertical and
//! turned freely: against dense formulas over the pixels, by another library, the
//! direct sum, and the runtime.

#[path = "oracle/mod.rs"]
mod oracle;
#[path = "tolerances/mod.rs"]
mod tolerances;

use eigenshade::index::{light, material};
use eigenshade::{GeneralBasis, Light, Material, Normal};
use eigenshade_cli::owned_basis::{AnyBasis, OwnedBasis};
use eigenshade_generator::database::Named;
use eigenshade_generator::geometry::{Geometry, WeightedNormals};
use eigenshade_generator::light_statistics::LightStatistics;
use eigenshade_generator::moments::{MaterialMoments, equal};
use eigenshade_generator::reading::coefficients::{LeastSquares, scalar_product};
use eigenshade_generator::reading::eigenimage_values::EigenimageValues;
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::observation::{Observation, Observer};
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_generator::reading::prior::Prior;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::rotation::Rotation;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_generator::truth::Truth;
use eigenshade_generator::{general, irradiance};
use eigenshade_table::Table;
use eigenshade_table::scene::{Criterion, LightRotation};
use nalgebra::{DMatrix, DVector};
use oracle::Numbers;
use std::f64::consts::TAU;
use std::path::Path;

const DEGREE: usize = 4;
const ORDER: usize = 3;
const COUNT: usize = 300;
const NOISE: f64 = 0.01;
const CRITERIA: [Criterion; 2] = [Criterion::ImageCentered, Criterion::Standard];
const ROTATIONS: [LightRotation; 3] =
    [LightRotation::Any, LightRotation::Vertical, LightRotation::None];

/// An object of some hundred normals, and its table.
struct Object {
    loaded: Loaded,
    normals: WeightedNormals,
    table: Table,
}

impl Object {
    fn new(criterion: Criterion, rotation: LightRotation, components: usize) -> Self {
        let mut loaded = scene_file::load(Path::new("tables/sphere.toml")).expect("a scene");
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
    fn projected(&self, pairs: &[(&[f64], &[f64])]) -> Vec<DVector<f64>> {
        self.with_basis(|basis| {
            let mut workspace = vec![0.0; basis.workspace_len()];
            let project = |(light, material): &(&[f64], &[f64])| {
                let mut d = DVector::zeros(basis.components());
                let light = Light::new(DEGREE, light).expect("a light");
                let material = Material::new(ORDER, material).expect("a material");
                basis
                    .project_into(&light, &material, &mut workspace, d.as_mut_slice())
                    .expect("a projection");
                d
            };
            pairs.iter().map(project).collect()
        })
    }

    /// √W E and √W m by the runtime.
    fn dense(&self) -> (DMatrix<f64>, DVector<f64>) {
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
    fn image(&self, light: &[f64], material: &[f64]) -> DVector<f64> {
        let truth = Truth::new(DEGREE, ORDER);
        let value = |pixel: usize| {
            let modes = truth.at(self.normals.normals()[pixel]);
            modes.irradiance(light, &modes.scatter(material))
        };
        DVector::from_fn(COUNT, |pixel, _| value(pixel))
    }

    fn rooted(&self, image: &DVector<f64>) -> DVector<f64> {
        DVector::from_fn(COUNT, |pixel, _| self.normals.weights()[pixel].sqrt() * image[pixel])
    }

    fn observe(&self, image: &DVector<f64>) -> Observation {
        let values = EigenimageValues::new(&self.table, usize::MAX);
        let mut observer = Observer::new(values, 1);
        let weights = self.normals.weights();
        for ((normal, value), weight) in self.normals.normals().iter().zip(image).zip(weights) {
            observer.see(*normal, &[*value], *weight);
        }
        observer.finish()
    }

    /// The fifth light, at L_0^0 = 1 like all, and the seventh material.
    fn pair(&self) -> (Vec<f64>, Vec<f64>) {
        (self.lights()[4].clone(), self.loaded.materials.entries[6].luminance())
    }

    fn lights(&self) -> Vec<Vec<f64>> {
        let unit = |entry: &Named| {
            let light = entry.luminance();
            light.iter().map(|value| value / light[0]).collect()
        };
        self.loaded.lights.entries.iter().map(unit).collect()
    }

    fn prior(&self) -> (Transfers, Prior) {
        let transfers = Transfers::new(&self.table, usize::MAX);
        let lights = &self.loaded.lights;
        let (normalise, rotation) =
            (self.loaded.scene.light.normalise, self.loaded.scene.light.rotation);
        let weights = equal(lights.entries.len());
        let light =
            LightStatistics::new(lights, normalise, rotation, &weights).expect("statistics");
        let materials = MaterialMoments::new(&self.loaded.materials);
        let prior = Prior::new(&self.table, &transfers, &light, materials).expect("a prior");
        (transfers, prior)
    }
}

fn to_dense(matrix: &faer::Mat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// Largest difference, of the largest number expected.
#[track_caller]
fn assert_near<'a>(
    what: &str,
    found: impl IntoIterator<Item = &'a f64>,
    expected: impl IntoIterator<Item = &'a f64>,
    allowed: f64,
) {
    let (found, expected): (Vec<_>, Vec<_>) =
        (found.into_iter().collect(), expected.into_iter().collect());
    assert_eq!(found.len(), expected.len());
    let largest = expected.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    let both = found.iter().zip(&expected);
    let far = both.fold(0.0f64, |most, (a, b)| most.max((*a - *b).abs())) / largest;
    println!("{what}: {far:.1e}");
    assert!(far <= allowed, "{what}: {far:e} > {allowed:e}");
}

#[test]
fn components_are_those_of_the_direct_sum() {
    for criterion in CRITERIA {
        // An image of the database itself lies in the span of all its components.
        let object = Object::new(criterion, LightRotation::None, usize::MAX);
        let (light, material) = object.pair();
        let image = object.image(&light, &material);
        let observation = object.observe(&image);
        let (design, mean) = object.dense();
        // The weights sum to 1, so this is the mean over the object.
        let direct = design.transpose() * (object.rooted(&image) - mean);
        let product = scalar_product(&observation, 0);
        assert_near("scalar product", &product, &direct, tolerances::READ_LEAST_SQUARES);
        let projected = &object.projected(&[(&light, &material)])[0];
        assert_near("projection", &product, projected, tolerances::READ_MODES);
        let squares = LeastSquares::new(&observation, 1e-12).expect("singular values");
        assert_eq!(squares.rank(), object.table.count());
        let d = squares.solve(observation.centred(0).as_ref());
        assert_near("least squares", &d, projected, tolerances::READ_MODES);
    }
}

/// E{d dᵀ} by the runtime's projections: of each light at each angle, or, turned
/// freely, of L_0^0 and then of every harmonic alone.
fn second_moment(object: &Object) -> DMatrix<f64> {
    let materials: Vec<Vec<f64>> =
        object.loaded.materials.entries.iter().map(Named::luminance).collect();
    let rotation = object.loaded.scene.light.rotation;
    let lights = object.lights();
    let angles = if rotation == LightRotation::Vertical { 4 * DEGREE + 3 } else { 1 };
    let turned = |light: &Vec<f64>, k: usize| {
        let alpha = TAU * (k as f64 + 0.3) / angles as f64;
        Rotation { alpha, beta: 0.0, gamma: 0.0 }.turn(DEGREE, light)
    };
    let unit = |place: usize, length: f64| {
        let mut light = vec![0.0; light::count(DEGREE)];
        light[place] = length;
        light
    };
    let free = rotation == LightRotation::Any;
    let samples: Vec<Vec<f64>> = match rotation {
        LightRotation::None => lights,
        LightRotation::Vertical => {
            lights.iter().flat_map(|light| (0..angles).map(|k| turned(light, k))).collect()
        }
        LightRotation::Any => {
            let power = |l: usize| {
                let of = |light: &Vec<f64>| -> f64 {
                    light[l * l..(l + 1) * (l + 1)].iter().map(|x| x * x).sum()
                };
                lights.iter().map(of).sum::<f64>() / (lights.len() * (2 * l + 1)) as f64
            };
            light::indices(DEGREE)
                .map(|(l, m)| unit(light::position(l, m), power(l).sqrt()))
                .collect()
        }
    };
    let pairs: Vec<(&[f64], &[f64])> = materials
        .iter()
        .flat_map(|material| samples.iter().map(move |light| (&light[..], &material[..])))
        .collect();
    let black = unit(0, 0.0);
    let dark = &object.projected(&[(&black, &materials[0])])[0];
    let count = if free { materials.len() } else { pairs.len() } as f64;
    let mut moment = DMatrix::zeros(dark.len(), dark.len());
    for ((light, _), mut d) in pairs.iter().zip(object.projected(&pairs)) {
        // Every L_0^0 is 1 here: a harmonic alone is a difference from it.
        if free && light[0] == 0.0 {
            d -= dark;
        }
        moment += &d * d.transpose() / count;
    }
    moment
}

#[test]
fn prior_is_the_databases_second_moment() {
    for criterion in CRITERIA {
        for rotation in ROTATIONS {
            let object = Object::new(criterion, rotation, 20);
            let found = to_dense(&object.prior().1.second_moment());
            let expected = second_moment(&object);
            assert_near("V_d", &found, &expected, tolerances::READ_PRIOR);
            let general = object.table.general.as_ref().expect("a general table");
            let first = usize::from(general.eigenvalues[0].is_none());
            let values = || general.eigenvalues.iter().skip(first).flatten();
            let diagonal = found.diagonal();
            let found = diagonal.iter().skip(first);
            assert_near("eigenvalues", found, values(), tolerances::READ_PRIOR);
        }
    }
}

#[test]
fn posterior_is_the_dense_formula() {
    for (criterion, rotation) in CRITERIA.into_iter().zip([LightRotation::Vertical; 2]) {
        let object = Object::new(criterion, rotation, 20);
        let (light, material) = object.pair();
        let image = object.image(&light, &material);
        let observation = object.observe(&image);
        let (_, prior) = object.prior();
        // Of a pixel of weight 1, the mean weight being 1 / COUNT.
        let noise = NOISE / (COUNT as f64).sqrt();
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let found = posterior.estimate(0, noise);

        let (design, mean) = object.dense();
        let image = object.rooted(&image);
        let moment = second_moment(&object);
        let energy = (&design * &moment * design.transpose()).trace() + mean.norm_squared();
        let s = ((image.norm_squared() - NOISE * NOISE) / energy).sqrt();
        assert_near("exposure", [&found.exposure], [&s], tolerances::READ_POSTERIOR);
        let cross = s * s * &moment * design.transpose();
        let total = &design * &cross + DMatrix::identity(COUNT, COUNT) * noise * noise;
        let solved = total.cholesky().expect("a positive matrix").solve(&(image - s * &mean));
        // The mean image's components: minus those of darkness.
        let black = vec![0.0; light::count(DEGREE)];
        let dark = &object.projected(&[(&black, &material)])[0];
        let d = &cross * solved - (s - 1.0) * dark;
        assert_near("posterior mean", &found.d, &d, tolerances::READ_POSTERIOR);
    }
}

#[test]
fn light_and_evidence_are_the_dense_formulas() {
    for criterion in CRITERIA {
        let object = Object::new(criterion, LightRotation::None, 40);
        let (light, material) = object.pair();
        let image = object.image(&light, &material);
        let observation = object.observe(&image);
        let (transfers, prior) = object.prior();
        let transfer = transfers.of(&material);
        let estimate = LightEstimate::new(&observation, &prior, &transfer).expect("values");
        let noise = NOISE / (COUNT as f64).sqrt();
        let found = estimate.explain(0, noise);

        // Mean and covariance of the lights themselves; E T by projecting harmonics.
        let count = light::count(DEGREE);
        let lights = object.lights();
        let lights = DMatrix::from_fn(count, lights.len(), |i, j| lights[j][i]);
        let centre = lights.column_mean();
        let apart = DMatrix::from_fn(count, lights.ncols(), |i, j| lights[(i, j)] - centre[i]);
        let covariance = &apart * apart.transpose() / lights.ncols() as f64;
        let (design, mean) = object.dense();
        let unit = DMatrix::<f64>::identity(count, count);
        let mut pairs: Vec<(&[f64], &[f64])> =
            unit.as_slice().chunks(count).map(|light| (light, &material[..])).collect();
        let black = vec![0.0; count];
        pairs.push((&black, &material));
        let mut columns = object.projected(&pairs);
        let dark = columns.pop().expect("d of darkness");
        columns.iter_mut().for_each(|d| *d -= &dark);
        let images = &design * DMatrix::from_columns(&columns);
        let target = object.rooted(&image) - mean - &design * dark;
        let at = |s: f64| {
            let cross = s * s * &covariance * images.transpose();
            let total = &images * &cross + DMatrix::identity(COUNT, COUNT) * noise * noise;
            let left = &target - s * &images * &centre;
            let cholesky = total.cholesky().expect("a positive matrix");
            let solved = cholesky.solve(&left);
            let roots = cholesky.l();
            let logs: f64 = (0..COUNT).map(|k| 2.0 * (roots[(k, k)] / noise).ln()).sum();
            (s * &centre + cross * &solved, -0.5 * (left.dot(&solved) + logs))
        };
        let (expected, evidence) = at(found.exposure);
        assert_near("light", &found.light, &expected, tolerances::READ_POSTERIOR);
        assert_near("evidence", [&found.evidence], [&evidence], tolerances::READ_POSTERIOR);
        for other in [0.5, 0.9, 1.1, 2.0] {
            assert!(at(other * found.exposure).1 < evidence, "not the likeliest exposure");
        }
    }
}

/// Pixels of which the images of modes are looked at: every one of so many.
const STEP: usize = 15;

/// √W Σ c_s E_s at some of the object's normals, (16), mode by mode.
fn image_of_modes(object: &Object, c: &ModeCoefficients) -> DVector<f64> {
    let value = |pixel: usize| {
        let [x, y, z] = object.normals.normals()[pixel];
        let (alpha, beta) = (x.hypot(y).atan2(z), y.atan2(x));
        let mut sum = 0.0;
        for (row, (l, m)) in light::indices(c.degree).enumerate() {
            for (column, (o, p, q)) in material::indices(c.order).enumerate() {
                if q <= l {
                    sum += c.values[(row, column)] * irradiance::value(l, m, o, p, q, alpha, beta);
                }
            }
        }
        object.normals.weights()[pixel].sqrt() * sum
    };
    DVector::from_fn(COUNT / STEP, |k, _| value(k * STEP))
}

#[test]
fn modes_have_the_image_that_they_were_read_from() {
    for criterion in CRITERIA {
        let object = Object::new(criterion, LightRotation::None, usize::MAX);
        let (light, material) = object.pair();
        let observation = object.observe(&object.image(&light, &material));
        let (transfers, prior) = object.prior();
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let estimate = posterior.estimate(0, NOISE / (COUNT as f64).sqrt());
        let (design, mean) = object.dense();
        let d = DVector::from_column_slice(&estimate.d);

        let least_norm = image_of_modes(&object, &modes::least_norm(&object.table, &estimate.d));
        let some = |image: DVector<f64>| DVector::from_fn(COUNT / STEP, |k, _| image[k * STEP]);
        let expected = some(&design * &d);
        assert_near("least norm", &least_norm, &expected, tolerances::READ_MODES);

        // Whole images: s (m + E δ), with the mean image's own modes.
        let s = estimate.exposure;
        let d_mean = DVector::from_column_slice(&prior.mean);
        let expected = some(s * &mean + &design * (d - (s - 1.0) * d_mean));
        let likely = modes::posterior_mean(&transfers, &prior, &estimate);
        let found = image_of_modes(&object, &likely);
        assert_near("posterior", &found, &expected, tolerances::READ_MODES);
    }
}
