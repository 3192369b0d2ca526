//! Light, material and modes of an image of a sphere, and of tables of an object, under light as
//! captured, about the vertical and turned freely: against dense formulas over the pixels, by
//! another library, against the images of modes, the direct sum, and the runtime.

use crate::reading;
use eigenshade::index::light;
use eigenshade_generator::basis::moments::LightMoments;
use eigenshade_generator::reading::coefficients::{LeastSquares, scalar_product};
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::observation::EigenimageValues;
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_model::database::Named;
use eigenshade_model::rotation::Rotation;
use eigenshade_table::scene::{Criterion, LightRotation};
use nalgebra::{DMatrix, DVector};
use reading::oracle::Numbers;
use reading::{
    COUNT, CRITERIA, DEGREE, LitImage, NOISE, Object, apart, assert_likeliest, assert_near, dense,
    image_of_modes, observe, pixels, prior, small, to_dense, tolerances,
};
use std::f64::consts::TAU;

/// A product in exact modes comes back: some hundred roundings.
const READ_RANK_ONE: f64 = 2e-15;

/// Energy beside the largest singular value, of its square, by which a matrix is no product.
const READ_NO_PRODUCT: f64 = 1e-3;

/// Derivatives of the error by L and b where the turns settle, of the largest L: roots of the 1e-14
/// by which the error still falls.
const READ_RANK_ONE_SLOPE: f64 = 3e-7;

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
    assert_near("left", product.left, READ_RANK_ONE);
    let square: f64 = product.material.iter().map(|b| b * b).sum();
    assert_near("scale", (square - 1.0).abs(), READ_RANK_ONE);
    assert_eq!(product.scaled_to(&known), Some(14));
    assert_near("light", apart(&product.light, &light), READ_RANK_ONE);
    assert_near("material", apart(&product.material, &material), READ_RANK_ONE);
    // Zeros for the missing modes would be a part of the matrix: no product at all.
    let svd = to_dense(&c.values).svd(false, false);
    let rest: f64 = svd.singular_values.iter().skip(1).map(|x| x * x).sum();
    assert!(rest > READ_NO_PRODUCT * svd.singular_values[0].powi(2), "{rest}");
}

/// Modes that are no product: what was found is the best light for its material, and the
/// best material for its light.
#[test]
fn the_best_product_of_any_modes_is_where_no_turn_makes_it_better() {
    for seed in 0..30 {
        let mut numbers = Numbers(seed);
        let mut c = ModeCoefficients::zeros(4, 3);
        let exists = c.exists();
        let (rows, columns) = (c.values.nrows(), c.values.ncols());
        let pairs: Vec<(usize, usize)> = (0..rows)
            .flat_map(|row| (0..columns).map(move |column| (row, column)))
            .filter(|&(row, column)| exists(row, column))
            .collect();
        for pair in &pairs {
            c.values[*pair] = numbers.next();
        }
        let product = RankOne::of(&c).expect("singular values");
        assert!(product.has_converged, "seed {seed}");
        // The derivatives of the error by every L and every b.
        let (mut by_light, mut by_material) = (vec![0.0; rows], vec![0.0; columns]);
        for &(row, column) in &pairs {
            let left = c.values[(row, column)] - product.light[row] * product.material[column];
            by_light[row] += left * product.material[column];
            by_material[column] += left * product.light[row];
        }
        let steepest =
            by_light.iter().chain(&by_material).fold(0.0f64, |most, x| most.max(x.abs()));
        let scale = product.light.iter().fold(0.0f64, |most, l| most.max(l.abs()));
        assert_near("slope", steepest / scale, READ_RANK_ONE_SLOPE);
        // A limit that cuts it short is said, and the product is no better for it.
        let short = RankOne::within(&c, 2).expect("singular values");
        assert!(!short.has_converged && short.left > product.left, "seed {seed}");
    }
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
        let normalize = loaded.scene.light.normalize;
        let moments = LightMoments::new(&loaded.lights, normalize).expect("moments");
        let spread = DVector::from_iterator(
            light::count(4),
            light::indices(4).map(|(l, _)| match l {
                0 => moments.ambient_variance,
                _ => moments.power[l],
            }),
        );
        let mut center = DVector::zeros(light::count(4));
        center[0] = moments.ambient_mean;
        let covariance = DMatrix::from_diagonal(&spread);
        let image = LitImage { images, target, mean: center, covariance, noise: NOISE };
        assert_likeliest(&image, &found);
    }
}

const ROTATIONS: [LightRotation; 3] =
    [LightRotation::Any, LightRotation::Vertical, LightRotation::None];

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
        assert_near("scalar product", apart(&product, &direct), tolerances::READ_LEAST_SQUARES);
        let projected = &object.projected(&[(&light, &material)])[0];
        assert_near("projection", apart(&product, projected), tolerances::READ_MODES);
        let squares =
            LeastSquares::new(&observation, tolerances::READ_CUT_OFF).expect("singular values");
        assert_eq!(squares.rank(), object.table.count());
        let d = squares.solve(observation.centered(0).as_ref());
        assert_near("least squares", apart(&d, projected), tolerances::READ_MODES);
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
            assert_near("V_d", apart(&found, &expected), tolerances::READ_PRIOR);
            let general = object.table.general.as_ref().expect("a general table");
            let first = usize::from(general.eigenvalues[0].is_none());
            let values = || general.eigenvalues.iter().skip(first).flatten();
            let diagonal = found.diagonal();
            let found = diagonal.iter().skip(first);
            assert_near("eigenvalues", apart(found, values()), tolerances::READ_PRIOR);
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
        assert_near("exposure", apart([&found.exposure], [&s]), tolerances::READ_POSTERIOR);
        let cross = s * s * &moment * design.transpose();
        let total = &design * &cross + DMatrix::identity(COUNT, COUNT) * noise * noise;
        let solved = total.cholesky().expect("a positive matrix").solve(&(image - s * &mean));
        // The mean image's components: minus those of darkness.
        let black = vec![0.0; light::count(DEGREE)];
        let dark = &object.projected(&[(&black, &material)])[0];
        let d = &cross * solved - (s - 1.0) * dark;
        assert_near("posterior mean", apart(&found.d, &d), tolerances::READ_POSTERIOR);
    }
}

#[test]
fn light_and_evidence_are_the_dense_formulas_for_objects() {
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
        let center = lights.column_mean();
        let spread = DMatrix::from_fn(count, lights.ncols(), |i, j| lights[(i, j)] - center[i]);
        let covariance = &spread * spread.transpose() / lights.ncols() as f64;
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
        let image = LitImage { images, target, mean: center, covariance, noise };
        assert_likeliest(&image, &found);
    }
}

/// The images of modes are compared at one pixel in this many.
const STEP: usize = 15;

/// √W Σ c_s E_s at some of the object's normals.
fn images_of_modes(object: &Object, c: &ModeCoefficients) -> DVector<f64> {
    let (normals, weights) = (object.normals.normals(), object.normals.weights());
    let value = |k: usize| weights[k].sqrt() * image_of_modes(c, normals[k]);
    DVector::from_fn(COUNT / STEP, |k, _| value(k * STEP))
}

#[test]
fn modes_have_the_image_that_they_were_read_from_for_objects() {
    for criterion in CRITERIA {
        let object = Object::new(criterion, LightRotation::None, usize::MAX);
        let (light, material) = object.pair();
        let observation = object.observe(&object.image(&light, &material));
        let (transfers, prior) = object.prior();
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let estimate = posterior.estimate(0, NOISE / (COUNT as f64).sqrt());
        let (design, mean) = object.dense();
        let d = DVector::from_column_slice(&estimate.d);

        let least_norm = images_of_modes(&object, &modes::least_norm(&object.table, &estimate.d));
        let some = |image: DVector<f64>| DVector::from_fn(COUNT / STEP, |k, _| image[k * STEP]);
        let expected = some(&design * &d);
        assert_near("least norm", apart(&least_norm, &expected), tolerances::READ_MODES);

        // Whole images: s (m + E δ), with the mean image's own modes.
        let s = estimate.exposure;
        let d_mean = DVector::from_column_slice(&prior.mean);
        let expected = some(s * &mean + &design * (d - (s - 1.0) * d_mean));
        let likely = modes::posterior_mean(&transfers, &prior, &estimate);
        let found = images_of_modes(&object, &likely);
        assert_near("posterior", apart(&found, &expected), tolerances::READ_MODES);
    }
}
