//! Light, material and modes of an image of a sphere: against dense formulas over the
//! pixels, by another library, and against the images of modes.

use crate::reading;
use eigenshade::index::light;
use eigenshade_generator::basis::moments::LightMoments;
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::observation::EigenimageValues;
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_model::database::Named;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};
use reading::oracle::Numbers;
use reading::sphere::{dense, observe, pixels, prior, small};
use reading::{
    CRITERIA, LitImage, NOISE, apart, assert_likeliest, assert_near, image_of_modes, to_dense,
    tolerances,
};

/// A product in exact modes comes back: some hundred roundings.
const READ_RANK_ONE: f64 = 2e-15;

/// Energy beside the largest singular value, of its square, by which a matrix is no product.
const READ_NO_PRODUCT: f64 = 1e-3;

/// Derivatives of the error by L and b where the turns settle, of the largest L: roots of the 1e-14 by which
/// the error still falls.
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
