//! Reading an image: each estimate against dense formulas over the pixels, by
//! another library, and against the runtime.

#[path = "oracle/mod.rs"]
mod oracle;
#[path = "tolerances/mod.rs"]
mod tolerances;

use eigenshade::index::{light, material};
use eigenshade::{Light, Material, Normal};
use eigenshade_cli::owned_basis::OwnedBasis;
use eigenshade_generator::basis;
use eigenshade_generator::database::Named;
use eigenshade_generator::irradiance;
use eigenshade_generator::light_statistics::LightStatistics;
use eigenshade_generator::moments::{LightMoments, MaterialMoments, equal};
use eigenshade_generator::reading::coefficients::{LeastSquares, scalar_product};
use eigenshade_generator::reading::eigenimage_values::EigenimageValues;
use eigenshade_generator::reading::fit::fit;
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::observation::{Observation, Observer};
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_generator::reading::prior::Prior;
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_generator::reading::transfer::Transfers;
use eigenshade_generator::scene_file::{self, Loaded};
use eigenshade_generator::special::gauss_legendre;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};
use oracle::Numbers;
use std::f64::consts::PI;
use std::path::Path;

/// The shipped databases, cut to a degree and an order, and their table.
fn small(criterion: Criterion, components: usize) -> (Loaded, Table) {
    let mut loaded = scene_file::load(Path::new("tables/sphere.toml")).expect("a scene");
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
struct Pixels {
    normals: Vec<[f64; 3]>,
    image: Vec<f64>,
    weights: Vec<f64>,
}

const CRITERIA: [Criterion; 2] = [Criterion::ImageCentered, Criterion::Standard];
const COUNT: usize = 300;
const NOISE: f64 = 0.01;

fn pixels(loaded: &Loaded, seed: u64) -> Pixels {
    let mut numbers = Numbers(seed);
    let truth = eigenshade_generator::truth::Truth::new(4, 3);
    let light = loaded.lights.entries[4].luminance();
    let coefficients = loaded.materials.entries[6].luminance();
    let mut pixels = Pixels { normals: vec![], image: vec![], weights: vec![] };
    while pixels.normals.len() < COUNT {
        let normal @ [x, y, _] = numbers.normal();
        if x < -0.2 {
            continue;
        }
        let modes = truth.at(normal);
        let value = modes.irradiance(&light, &modes.scatter(&coefficients));
        pixels.normals.push(normal);
        pixels.image.push(value + NOISE * numbers.next());
        pixels.weights.push(if y > 0.0 { 2.0 } else { 0.5 });
    }
    pixels
}

fn observe(table: &Table, pixels: &Pixels) -> Observation {
    let values = EigenimageValues::new(table, table.components.len());
    let mut observer = Observer::new(values, 1);
    for ((normal, value), weight) in pixels.normals.iter().zip(&pixels.image).zip(&pixels.weights) {
        observer.see(*normal, &[*value], *weight);
    }
    observer.finish()
}

/// √W E, √W m and √W I, by the runtime.
fn dense(table: &Table, pixels: &Pixels) -> (DMatrix<f64>, DVector<f64>, DVector<f64>) {
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

fn prior(loaded: &Loaded, table: &Table) -> (Transfers, Prior) {
    let transfers = Transfers::new(table, table.components.len());
    let light = &loaded.scene.light;
    let weights = equal(loaded.lights.entries.len());
    let light = LightStatistics::new(&loaded.lights, light.normalise, light.rotation, &weights)
        .expect("statistics");
    let prior = Prior::new(table, &transfers, &light, MaterialMoments::new(&loaded.materials))
        .expect("a prior");
    (transfers, prior)
}

fn to_dense(matrix: &faer::Mat<f64>) -> DMatrix<f64> {
    DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |i, j| matrix[(i, j)])
}

/// Largest difference, of the largest number expected.
fn apart<'a>(
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
fn assert_near(what: &str, found: f64, allowed: f64) {
    println!("{what}: {found:.1e}");
    assert!(found <= allowed, "{what}: {found:e} > {allowed:e}");
}

#[test]
fn least_squares_and_fit_are_those_over_the_pixels() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, 20);
        let pixels = pixels(&loaded, 3);
        let observation = observe(&table, &pixels);
        let (design, mean, image) = dense(&table, &pixels);
        let centred = &image - &mean;
        let expected = design.clone().svd(true, true).solve(&centred, 1e-12).expect("a solution");
        let squares = LeastSquares::new(&observation, 1e-12).expect("singular values");
        assert_eq!(squares.rank(), 20);
        let d = squares.solve(observation.centred(0).as_ref());
        assert_near("least squares", apart(&d, &expected), tolerances::READ_LEAST_SQUARES);

        let product = scalar_product(&observation, 0);
        let expected = design.transpose() * &centred / pixels.weights.iter().sum::<f64>();
        assert_near("scalar product", apart(&product, &expected), tolerances::READ_LEAST_SQUARES);

        let found = fit(&observation, 0, &d, 20);
        let left = (&centred - &design * DVector::from_column_slice(&d)).norm_squared();
        let weight: f64 = pixels.weights.iter().sum();
        let weighted = pixels.weights.iter().zip(&pixels.image);
        let average = weighted.clone().map(|(w, i)| w * i).sum::<f64>() / weight;
        let spread: f64 = weighted.map(|(w, i)| w * (i - average).powi(2)).sum();
        let expected = [(left / weight).sqrt(), left / spread, (left / 280.0).sqrt()];
        let found = [found.residual_rms, found.relative_residual, found.noise];
        for (found, expected) in found.iter().zip(&expected) {
            assert_near("fit", apart([found], [expected]), tolerances::READ_LEAST_SQUARES);
        }
    }
}

#[test]
fn posterior_is_the_dense_formula() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, 20);
        let pixels = pixels(&loaded, 5);
        let observation = observe(&table, &pixels);
        let (_, prior) = prior(&loaded, &table);
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let found = posterior.estimate(0, NOISE);

        let (design, mean, image) = dense(&table, &pixels);
        let moment = to_dense(&prior.second_moment());
        let expected_energy =
            (&design * &moment * design.transpose()).trace() + mean.norm_squared();
        let energy = image.norm_squared() - COUNT as f64 * NOISE * NOISE;
        let s = (energy / expected_energy).sqrt();
        assert_near("exposure", (found.exposure / s - 1.0).abs(), tolerances::READ_POSTERIOR);

        // s² V Eᵀ (s² E V Eᵀ + noise²)⁻¹ (I - s m), over the pixels.
        let cross = s * s * &moment * design.transpose();
        let total = &design * &cross + DMatrix::identity(COUNT, COUNT) * NOISE * NOISE;
        let inverse = total.cholesky().expect("a positive matrix").inverse();
        let d_mean = DVector::from_column_slice(&prior.mean);
        let d = &cross * &inverse * (image - s * mean) + (s - 1.0) * d_mean;
        assert_near("posterior mean", apart(&found.d, &d), tolerances::READ_POSTERIOR);
        let covariance = s * s * &moment - &cross * &inverse * cross.transpose();
        let deviations: Vec<f64> = covariance.diagonal().iter().map(|x| x.sqrt()).collect();
        let far = apart(&found.deviations, &deviations);
        assert_near("posterior deviations", far, tolerances::READ_POSTERIOR);
    }
}

/// d of every material under every harmonic alone, by the runtime, and its power.
fn second_moment(loaded: &Loaded, table: &Table) -> DMatrix<f64> {
    let owned = OwnedBasis::<f64>::new(table);
    let basis = owned.basis().expect("a basis");
    let components = table.components.len();
    let mut power = vec![0.0; loaded.lights.degree + 1];
    for entry in &loaded.lights.entries {
        let values = entry.luminance();
        for (l, power) in power.iter_mut().enumerate() {
            let square: f64 = values[l * l..(l + 1) * (l + 1)].iter().map(|x| x * x).sum();
            let count = (loaded.lights.entries.len() * (2 * l + 1)) as f64;
            *power += square / (values[0] * values[0] * count);
        }
    }
    let (mut workspace, mut dark) = (vec![0.0; basis.workspace_len()], vec![0.0; components]);
    let mut project = |light: &[f64], of: &[f64], d: &mut [f64]| {
        let light = Light::new(loaded.lights.degree, light).expect("a light");
        let of = Material::new(loaded.materials.order, of).expect("a material");
        basis.project_into(&light, &of, &mut workspace, d).expect("a projection");
    };
    let mut unit = vec![0.0; light::count(loaded.lights.degree)];
    let black = vec![0.0; material::count(loaded.materials.order)];
    project(&unit, &black, &mut dark);
    let mut moment = DMatrix::zeros(components, components);
    for entry in &loaded.materials.entries {
        let entry = entry.luminance();
        for (l, m) in light::indices(loaded.lights.degree) {
            let mut d = vec![0.0; components];
            unit.fill(0.0);
            unit[light::position(l, m)] = 1.0;
            project(&unit, &entry, &mut d);
            let d = DVector::from_fn(components, |i, _| d[i] - dark[i]);
            moment += power[l] / loaded.materials.entries.len() as f64 * &d * d.transpose();
        }
    }
    // Less that of the mean image, which is the runtime's -d of darkness.
    let mean = DVector::from_column_slice(&dark);
    moment - &mean * mean.transpose()
}

#[test]
fn prior_is_the_databases_second_moment() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, 20);
        let (_, prior) = prior(&loaded, &table);
        let found = to_dense(&prior.second_moment());
        let expected = second_moment(&loaded, &table);
        assert_near("V_d", apart(&found, &expected), tolerances::READ_PRIOR);
        // (28) and (33): uncorrelated, the eigenvalues on the diagonal.
        let largest = table.components.iter().filter_map(|one| one.eigenvalue).fold(0.0, f64::max);
        for i in 0..20 {
            for j in 0..20 {
                let constant = table.components[i].eigenvalue.is_none()
                    || table.components[j].eigenvalue.is_none();
                if !constant {
                    let eigenvalue = table.components[i].eigenvalue.unwrap_or(0.0);
                    let expected = if i == j { eigenvalue } else { 0.0 };
                    let far = (found[(i, j)] - expected).abs() / largest;
                    assert!(far <= tolerances::READ_PRIOR, "{i} {j}: {far:e}");
                }
            }
        }
    }
    // The constant goes with the others of m = 0, so V_d is not diagonal.
    let (loaded, table) = small(Criterion::ImageCentered, 20);
    let moment = prior(&loaded, &table).1.second_moment();
    let correlation = |j: usize| moment[(0, j)] / (moment[(0, 0)] * moment[(j, j)]).sqrt();
    assert!((1..20).any(|j| correlation(j).abs() > 0.05));
}

/// Σ c_s E_s at a normal, (16), mode by mode.
fn image_of_modes(c: &ModeCoefficients, [x, y, z]: [f64; 3]) -> f64 {
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

#[test]
fn modes_have_the_image_that_they_were_read_from() {
    let (loaded, table) = small(Criterion::ImageCentered, usize::MAX);
    let pixels = pixels(&loaded, 7);
    let observation = observe(&table, &pixels);
    let (transfers, prior) = prior(&loaded, &table);
    let posterior = Posterior::new(&observation, &prior).expect("singular values");
    let estimate = posterior.estimate(0, NOISE);
    let least_norm = modes::least_norm(&table, &estimate.d);
    let likely = modes::posterior_mean(&transfers, &prior, &estimate);
    let values = EigenimageValues::new(&table, table.components.len());
    let mut row = vec![0.0; table.components.len() + 1];
    let (mut numbers, mut far, mut peak) = (Numbers(9), [0.0f64; 2], 0.0f64);
    for _ in 0..20 {
        let normal = numbers.normal();
        values.at(normal, &mut row);
        let expected: f64 = row.iter().zip(&estimate.d).map(|(u, d)| u * d).sum();
        peak = peak.max(expected.abs());
        for (far, c) in far.iter_mut().zip([&least_norm, &likely]) {
            *far = far.max((image_of_modes(c, normal) - expected).abs());
        }
    }
    assert_near("image of the least-norm modes", far[0] / peak, tolerances::READ_MODES);
    assert_near("image of the posterior modes", far[1] / peak, tolerances::READ_MODES);
    // Of the same image, the one is of least norm.
    let length = |c: &ModeCoefficients| c.values.norm_l2();
    println!("norms {} and {}", length(&least_norm), length(&likely));
    assert!(length(&least_norm) < length(&likely));
}

#[test]
fn products_come_back_from_the_modes_that_exist() {
    let (loaded, _) = small(Criterion::ImageCentered, 1);
    let of = |entry: &Named| entry.luminance();
    let (light, material) = (of(&loaded.lights.entries[2]), of(&loaded.materials.entries[14]));
    let mut c = ModeCoefficients::zeros(4, 3);
    let exists = c.exists();
    for (row, l) in light.iter().enumerate() {
        for (column, b) in material.iter().enumerate() {
            if exists(row, column) {
                c.values[(row, column)] = l * b;
            }
        }
    }
    let known: Vec<Vec<f64>> = loaded.materials.entries.iter().map(of).collect();
    let mut product = RankOne::of(&c).expect("singular values");
    assert_near("left", product.left, tolerances::READ_RANK_ONE);
    assert!((product.material.iter().map(|b| b * b).sum::<f64>() - 1.0).abs() < 1e-12);
    assert_eq!(product.scaled_to(&known), Some(14));
    assert_near("light", apart(&product.light, &light), tolerances::READ_RANK_ONE);
    assert_near("material", apart(&product.material, &material), tolerances::READ_RANK_ONE);
    // Zeros for the missing modes would be a part of the matrix: no product at all.
    let svd = to_dense(&c.values).svd(false, false);
    let rest: f64 = svd.singular_values.iter().skip(1).map(|x| x * x).sum();
    assert!(rest > 1e-3 * svd.singular_values[0].powi(2), "{rest}");
}

#[test]
fn light_and_evidence_are_the_dense_formulas() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, usize::MAX);
        let pixels = pixels(&loaded, 11);
        let observation = observe(&table, &pixels);
        let (transfers, prior) = prior(&loaded, &table);
        let material = loaded.materials.entries[6].luminance();
        let transfer = transfers.of(&material);
        let estimate = LightEstimate::new(&observation, &prior, &transfer).expect("values");
        let found = estimate.explain(0, NOISE);

        let (design, mean, image) = dense(&table, &pixels);
        let d_mean = DVector::from_column_slice(&prior.mean);
        let target = image - mean + &design * d_mean;
        let images = &design * to_dense(&transfer);
        let normalise = loaded.scene.light.normalise;
        let moments = LightMoments::new(&loaded.lights, normalise).expect("moments");
        let spread = DVector::from_iterator(
            light::count(4),
            light::indices(4).map(|(l, _)| match l {
                0 => moments.ambient_variance,
                _ => moments.power[l],
            }),
        );
        let mut centre = DVector::zeros(light::count(4));
        centre[0] = moments.ambient_mean;
        // log N(I; s E T L, s² E T P (E T)ᵀ + noise²), without that of white noise.
        let at = |s: f64| {
            let cross = s * s * DMatrix::from_diagonal(&spread) * images.transpose();
            let noise = NOISE * NOISE;
            let total = &images * &cross + DMatrix::identity(COUNT, COUNT) * noise;
            let left = &target - s * &images * &centre;
            let cholesky = total.cholesky().expect("a positive matrix");
            let solved = cholesky.solve(&left);
            let roots = cholesky.l();
            let logs: f64 = (0..COUNT).map(|k| 2.0 * roots[(k, k)].ln() - noise.ln()).sum();
            let evidence = -0.5 * (left.dot(&solved) + logs);
            (s * &centre + cross * solved, evidence)
        };
        let (expected, evidence) = at(found.exposure);
        assert_near("light", apart(&found.light, &expected), tolerances::READ_POSTERIOR);
        let far = (found.evidence - evidence).abs() / evidence.abs();
        assert_near("evidence", far, tolerances::READ_POSTERIOR);
        for other in [0.5, 0.9, 1.1, 2.0] {
            assert!(at(other * found.exposure).1 < evidence, "not the likeliest exposure");
        }
    }
}

/// A whole sphere by quadrature: the scalar product is then least squares, and d.
#[test]
fn the_scalar_product_is_the_integral() {
    let (loaded, table) = small(Criterion::ImageCentered, 20);
    let d: Vec<f64> = (0..20).map(|k| f64::from(k + 1).recip()).collect();
    let values = EigenimageValues::new(&table, 20);
    let mut row = vec![0.0; 21];
    let mut observer = Observer::new(values, 1);
    for (z, weight) in gauss_legendre::rule(40, 0.0, 1.0) {
        for tilt in 0..16 {
            let (y, x) = (2.0 * PI * f64::from(tilt) / 16.0).sin_cos();
            let sine = (1.0 - z * z).sqrt();
            let normal = [sine * x, sine * y, z];
            values.at(normal, &mut row);
            let value: f64 = row.iter().zip(&d).map(|(u, d)| u * d).sum();
            observer.see(normal, &[value], 2.0 * z * weight / 16.0);
        }
    }
    let observation = observer.finish();
    let found = scalar_product(&observation, 0);
    assert_near("scalar product", apart(&found, &d), tolerances::READ_LEAST_SQUARES);
    assert_eq!(loaded.lights.degree, 4);
}
