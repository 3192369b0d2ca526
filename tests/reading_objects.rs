//! Reading with tables of an object, under light as captured, about the vertical and
//! turned freely: against dense formulas over the pixels, by another library, the
//! direct sum, and the runtime.

use crate::reading;
use eigenshade::index::light;
use eigenshade_generator::reading::coefficients::{LeastSquares, scalar_product};
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_model::database::Named;
use eigenshade_model::rotation::Rotation;
use eigenshade_table::scene::LightRotation;
use nalgebra::{DMatrix, DVector};
use reading::object::{DEGREE, Object};
use reading::{
    COUNT, CRITERIA, LitImage, NOISE, apart, assert_likeliest, assert_near, image_of_modes,
    to_dense, tolerances,
};
use std::f64::consts::TAU;

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

/// Pixels of which the images of modes are looked at: every one of so many.
const STEP: usize = 15;

/// √W Σ c_s E_s at some of the object's normals.
fn images_of_modes(object: &Object, c: &ModeCoefficients) -> DVector<f64> {
    let (normals, weights) = (object.normals.normals(), object.normals.weights());
    let value = |k: usize| weights[k].sqrt() * image_of_modes(c, normals[k]);
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
