//! Components of an image of a sphere: each estimate against dense formulas over the
//! pixels, by another library, and against the runtime.

use crate::reading;
use eigenshade::index::{light, material};
use eigenshade::{Light, Material};
use eigenshade_generator::reading::coefficients::{LeastSquares, fit, scalar_product};
use eigenshade_generator::reading::observation::{EigenimageValues, Observer};
use eigenshade_generator::reading::posterior::Posterior;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::Table;
use eigenshade_table::scene::Criterion;
use nalgebra::{DMatrix, DVector};
use reading::{COUNT, CRITERIA, NOISE, apart, assert_near, to_dense, tolerances};
use reading::{dense, observe, pixels, prior, small};
use std::f64::consts::PI;

/// Posterior deviations over those of least squares, less one, at noises of 1e-3, 1e-6 and 1e-9:
/// half the noise's variance over the prior's, 6e-3 at the first, falls with its square, to
/// rounding.
const READ_DEVIATIONS: [f64; 3] = [1e-2, 1e-8, 1e-11];

#[test]
fn least_squares_and_fit_are_those_over_the_pixels() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, 20);
        let pixels = pixels(&loaded, 3);
        let observation = observe(&table, &pixels);
        let (design, mean, image) = dense(&table, &pixels);
        let centered = &image - &mean;
        let expected = design
            .clone()
            .svd(true, true)
            .solve(&centered, tolerances::READ_CUT_OFF)
            .expect("a solution");
        let squares =
            LeastSquares::new(&observation, tolerances::READ_CUT_OFF).expect("singular values");
        assert_eq!(squares.rank(), 20);
        let d = squares.solve(observation.centered(0).as_ref());
        assert_near("least squares", apart(&d, &expected), tolerances::READ_LEAST_SQUARES);

        let product = scalar_product(&observation, 0);
        let expected = design.transpose() * &centered / pixels.weights.iter().sum::<f64>();
        assert_near("scalar product", apart(&product, &expected), tolerances::READ_LEAST_SQUARES);

        let found = fit(&observation, 0, &d, 20);
        let left = (&centered - &design * DVector::from_column_slice(&d)).norm_squared();
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

/// With all pixels, and with fewer than components, which do not see the rest.
#[test]
fn posterior_is_the_dense_formula() {
    for (criterion, count) in CRITERIA.into_iter().flat_map(|one| [(one, COUNT), (one, 8)]) {
        let (loaded, table) = small(criterion, 20);
        let mut pixels = pixels(&loaded, 5);
        pixels.weights[count..].fill(0.0);
        let observation = observe(&table, &pixels);
        assert_eq!(observation.pixels, count);
        let (_, prior) = prior(&loaded, &table);
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let found = posterior.estimate(0, NOISE);

        let (design, mean, image) = dense(&table, &pixels);
        let moment = to_dense(&prior.second_moment());
        let expected_energy =
            (&design * &moment * design.transpose()).trace() + mean.norm_squared();
        let energy = image.norm_squared() - count as f64 * NOISE * NOISE;
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

/// Where pixels determine d, its deviations are those of least squares, noise times the
/// roots of the diagonal of (EᵀWE)⁻¹, however small the noise: the prior adds nothing.
#[test]
fn posterior_deviations_are_in_proportion_to_a_small_noise() {
    for criterion in CRITERIA {
        let (loaded, table) = small(criterion, 20);
        let pixels = pixels(&loaded, 5);
        let observation = observe(&table, &pixels);
        let (_, prior) = prior(&loaded, &table);
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        let (design, ..) = dense(&table, &pixels);
        let normal = (design.transpose() * &design).cholesky().expect("a positive matrix");
        let expected = normal.inverse().diagonal().map(f64::sqrt);
        // The prior's share is the square of noise over its own spread.
        for (noise, allowed) in [1e-3, 1e-6, 1e-9].into_iter().zip(READ_DEVIATIONS) {
            let found = posterior.estimate(0, noise).deviations;
            let far = found
                .iter()
                .zip(&expected)
                .fold(0.0f64, |most, (found, one)| most.max((found / (noise * one) - 1.0).abs()));
            assert_near("deviations over the noise's", far, allowed);
        }
        // All components: some are not determined, but none is known without error.
        let (loaded, table) = small(criterion, usize::MAX);
        let observation = observe(&table, &pixels);
        let (_, prior) = self::prior(&loaded, &table);
        let posterior = Posterior::new(&observation, &prior).expect("singular values");
        for noise in [1e-3, 1e-6, 1e-9] {
            let found = posterior.estimate(0, noise).deviations;
            assert!(found.iter().all(|deviation| *deviation > 0.0), "{noise:e}: {found:?}");
        }
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
        let light = Light::new(light).expect("a light");
        let of = Material::new(of).expect("a material");
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

/// A whole sphere by quadrature: the scalar product is then least squares, and d.
#[test]
fn the_scalar_product_is_the_integral() {
    let (_, table) = small(Criterion::ImageCentered, 20);
    let d: Vec<f64> = (0..20).map(|k| f64::from(k + 1).recip()).collect();
    let values = EigenimageValues::new(&table, 20);
    let mut row = vec![0.0; 21];
    let mut observer = Observer::new(values, 1);
    for (z, weight) in gauss_legendre(40, 0.0, 1.0) {
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
}
