//! Components, light, material and modes of an image of a sphere: against dense formulas over the
//! pixels, by another library, against the images of modes, and the runtime.

use crate::oracle::Numbers;
use crate::reading::{
    COUNT, CRITERIA, LitImage, Subject, apart, assert_near, image_of_modes, scene, strongest,
    to_dense,
};
use crate::tolerances;
use eigenshade_generator::reading::coefficients::{LeastSquares, fit, scalar_product};
use eigenshade_generator::reading::light_estimate::LightEstimate;
use eigenshade_generator::reading::modes::{self, ModeCoefficients};
use eigenshade_generator::reading::observation::{EigenimageValues, Observer};
use eigenshade_generator::reading::rank_one::RankOne;
use eigenshade_model::database::Named;
use eigenshade_table::scene::Criterion;
use eigenshade_testing::{fixtures, largest};
use nalgebra::{DMatrix, DVector};

/// A product in exact modes comes back: some hundred roundings.
const READ_RANK_ONE: f64 = 2e-15;

/// Energy beside the largest singular value, of its square, by which a matrix is no product.
const READ_NO_PRODUCT: f64 = 1e-3;

/// Derivatives of the error by L and b where the turns settle, of the largest L: roots of the 1e-14
/// by which the error still falls.
const READ_RANK_ONE_SLOPE: f64 = 3e-7;

/// Posterior deviations over those of least squares, less one, at noises of 1e-3, 1e-6 and 1e-9:
/// half the noise's variance over the prior's, 6e-3 at the first, falls with its square, to
/// rounding.
const READ_DEVIATIONS: [f64; 3] = [1e-2, 1e-8, 1e-11];

#[test]
fn least_squares_and_fit_are_those_over_the_pixels() {
    for criterion in CRITERIA {
        let subject = Subject::new(criterion, 20);
        let image = subject.noisy();
        let observation = subject.observe(&image);
        let (design, mean) = subject.dense();
        let centered = subject.rooted(&image) - &mean;
        let svd = design.clone().svd(true, true);
        let expected = svd.solve(&centered, tolerances::READ_CUT_OFF).expect("a solution");
        let squares = LeastSquares::new(&observation, tolerances::READ_CUT_OFF);
        let squares = squares.expect("singular values");
        assert_eq!(squares.rank(), 20);
        let d = squares.solve(observation.centered(0).as_ref());
        assert_near("least squares", apart(&d, &expected), tolerances::READ_LEAST_SQUARES);

        let weight: f64 = subject.weights.iter().sum();
        let product = scalar_product(&observation, 0);
        let expected = design.transpose() * &centered / weight;
        let far = apart(&product, &expected);
        assert_near("scalar product", far, tolerances::READ_LEAST_SQUARES);

        let found = fit(&observation, 0, &d, 20);
        let left = (&centered - &design * DVector::from_column_slice(&d)).norm_squared();
        let weighted = subject.weights.iter().zip(&image);
        let average = weighted.clone().map(|(w, i)| w * i).sum::<f64>() / weight;
        let spread: f64 = weighted.map(|(w, i)| w * (i - average).powi(2)).sum();
        let expected = [(left / weight).sqrt(), left / spread, (left / 280.0).sqrt()];
        let found = [found.residual_rms, found.relative_residual, found.noise];
        for (found, expected) in found.iter().zip(&expected) {
            assert_near("fit", apart([found], [expected]), tolerances::READ_LEAST_SQUARES);
        }
    }
}

/// A whole sphere by quadrature: the scalar product is then least squares, and d.
#[test]
fn the_scalar_product_is_the_integral() {
    let table = Subject::new(Criterion::ImageCentered, 20).table;
    let d: Vec<f64> = (0..20).map(|k| f64::from(k + 1).recip()).collect();
    let values = EigenimageValues::new(&table, 20);
    let mut row = vec![0.0; 21];
    let mut observer = Observer::new(values, 1);
    for (normal, weight) in fixtures::rule(40, 16) {
        values.at(normal, &mut row);
        let value: f64 = row.iter().zip(&d).map(|(u, d)| u * d).sum();
        observer.see(normal, &[value], weight);
    }
    let found = scalar_product(&observer.finish(), 0);
    assert_near("scalar product", apart(&found, &d), tolerances::READ_LEAST_SQUARES);
}

#[test]
fn prior_is_the_databases_second_moment() {
    for criterion in CRITERIA {
        let subject = Subject::new(criterion, 20);
        let found = to_dense(&subject.prior().1.second_moment());
        let expected = subject.second_moment();
        assert_near("V_d", apart(&found, &expected), tolerances::READ_PRIOR);
        // (28) and (33): uncorrelated, the eigenvalues on the diagonal.
        let values = subject.eigenvalues();
        for (i, a) in values.iter().enumerate() {
            for (j, _) in values.iter().enumerate().filter(|(_, b)| a.is_some() && b.is_some()) {
                let expected = a.filter(|_| i == j).unwrap_or(0.0);
                let far = (found[(i, j)] - expected).abs() / strongest(&values);
                assert!(far <= tolerances::READ_PRIOR, "{i} {j}: {far:e}");
            }
        }
    }
    // The constant goes with the others of m = 0, so V_d is not diagonal.
    let moment = Subject::new(Criterion::ImageCentered, 20).prior().1.second_moment();
    let correlation = |j: usize| moment[(0, j)] / (moment[(0, 0)] * moment[(j, j)]).sqrt();
    assert!((1..20).any(|j| correlation(j).abs() > 0.05));
}

/// With all pixels, and with fewer than components, which do not see the rest.
#[test]
fn posterior_is_the_dense_formula() {
    for (criterion, count) in CRITERIA.into_iter().flat_map(|one| [(one, COUNT), (one, 8)]) {
        let mut subject = Subject::new(criterion, 20);
        subject.weights[count..].fill(0.0);
        let (image, noise) = (subject.noisy(), subject.noise());
        assert_eq!(subject.observe(&image).pixels, count);
        let found = subject.estimate(&image, noise);

        let ((design, mean), image) = (subject.dense(), subject.rooted(&image));
        let moment = subject.second_moment();
        let energy = (&design * &moment * design.transpose()).trace() + mean.norm_squared();
        let s = ((image.norm_squared() - count as f64 * noise * noise) / energy).sqrt();
        assert_near("exposure", apart([&found.exposure], [&s]), tolerances::READ_POSTERIOR);
        // s² V Eᵀ (s² E V Eᵀ + noise²)⁻¹ (I - s m), over the pixels.
        let cross = s * s * &moment * design.transpose();
        let total = &design * &cross + DMatrix::identity(COUNT, COUNT) * noise * noise;
        let inverse = total.cholesky().expect("a positive matrix").inverse();
        let d = &cross * &inverse * (image - s * mean) - (s - 1.0) * subject.dark();
        assert_near("posterior mean", apart(&found.d, &d), tolerances::READ_POSTERIOR);
        let covariance = s * s * &moment - &cross * &inverse * cross.transpose();
        let deviations = covariance.diagonal().map(f64::sqrt);
        let far = apart(&found.deviations, &deviations);
        assert_near("posterior deviations", far, tolerances::READ_POSTERIOR);
    }
}

/// Where pixels determine d, its deviations are those of least squares, noise times the
/// roots of the diagonal of (EᵀWE)⁻¹, however small the noise: the prior adds nothing.
#[test]
fn posterior_deviations_are_in_proportion_to_a_small_noise() {
    for criterion in CRITERIA {
        let sphere = Subject::new(criterion, 20);
        // The light as captured.
        let ambient = sphere.loaded.lights.entries[4].luminance()[0];
        let image: Vec<f64> = sphere.noisy().iter().map(|value| ambient * value).collect();
        let (design, _) = sphere.dense();
        let normal = (design.transpose() * &design).cholesky().expect("a positive matrix");
        let expected = normal.inverse().diagonal().map(f64::sqrt);
        // The prior's share is the square of noise over its own spread.
        for (noise, allowed) in [1e-3, 1e-6, 1e-9].into_iter().zip(READ_DEVIATIONS) {
            let found = sphere.estimate(&image, noise).deviations;
            let over = found.iter().zip(&expected).map(|(found, one)| found / (noise * one) - 1.0);
            assert_near("deviations over the noise's", largest(over), allowed);
        }
        // All components: some are not determined, but none is known without error.
        let sphere = Subject::new(criterion, usize::MAX);
        for noise in [1e-3, 1e-6, 1e-9] {
            let found = sphere.estimate(&image, noise).deviations;
            assert!(found.iter().all(|deviation| *deviation > 0.0), "{noise:e}: {found:?}");
        }
    }
}

#[test]
fn light_and_evidence_are_the_dense_formulas() {
    for criterion in CRITERIA {
        let subject = Subject::new(criterion, 40);
        let (image, noise) = (subject.noisy(), subject.noise());
        let (transfers, prior) = subject.prior();
        let transfer = transfers.of(&subject.pair().1);
        let observation = subject.observe(&image);
        let estimate = LightEstimate::new(&observation, &prior, &transfer).expect("values");
        let found = estimate.explain(0, noise);

        let (design, mean) = subject.dense();
        let images = subject.lit(&design);
        let target = subject.rooted(&image) - mean - &design * subject.dark();
        let statistics = subject.statistics();
        LitImage { images, target, statistics, noise }.assert_likeliest(&found);
    }
}

/// The images of modes are compared at one pixel in this many.
const STEP: usize = 15;

#[test]
fn modes_have_the_image_that_they_were_read_from() {
    for criterion in CRITERIA {
        let subject = Subject::new(criterion, usize::MAX);
        let (transfers, prior) = subject.prior();
        let estimate = subject.estimate(&subject.noisy(), subject.noise());
        let (design, mean) = subject.dense();
        let d = DVector::from_column_slice(&estimate.d);
        let some = |image: DVector<f64>| image.iter().copied().step_by(STEP).collect::<Vec<_>>();
        let near = |what: &str, c: &ModeCoefficients, expected: DVector<f64>| {
            let places = (0..COUNT).step_by(STEP);
            let value =
                |k: usize| subject.weights[k].sqrt() * image_of_modes(c, subject.normals[k]);
            let found: Vec<f64> = places.map(value).collect();
            assert_near(what, apart(&found, &some(expected)), tolerances::READ_MODES);
        };
        let least_norm = modes::least_norm(&subject.table, &estimate.d);
        near("least norm", &least_norm, &design * &d);
        // Whole images: s (m + E δ), with the mean image's own modes.
        let s = estimate.exposure;
        let likely = modes::posterior_mean(&transfers, &prior, &estimate);
        near("posterior", &likely, s * &mean + &design * (d + (s - 1.0) * subject.dark()));
        // Of the same image, the one is of least norm.
        let [least, other] = [&least_norm, &likely].map(|c| c.values.norm_l2());
        assert!(criterion == Criterion::Standard || least < other, "{least} {other}");
    }
}

#[test]
fn products_come_back_from_the_modes_that_exist() {
    let loaded = scene(Criterion::ImageCentered, 1);
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
        let steepest = largest(by_light.into_iter().chain(by_material));
        let scale = largest(product.light.iter().copied());
        assert_near("slope", steepest / scale, READ_RANK_ONE_SLOPE);
        // A limit that cuts it short is said, and the product is no better for it.
        let short = RankOne::within(&c, 2).expect("singular values");
        assert!(!short.has_converged && short.left > product.left, "seed {seed}");
    }
}
