//! What holds for every scene of a sphere.

use crate::samples::{samples, strangers};
use crate::{config, tolerances};
use eigenshade_generator::basis::moments;
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::scattering;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, decode, encode, light, material, mode};
use eigenshade_testing::fixtures::Projector;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::rotations::{euler, irradiance, product, rotation};
use eigenshade_testing::{fixtures, largest, largest_difference};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// |d|² + residual against the energy, relative: the orthonormality of W, twice, and polynomials
/// that end at 1e-13.
const PARSEVAL: f64 = 2e-14;

/// |d|², Σ w (I - Σ d_i U_i)² and Σ w (I - mean)² over some normals, I by the direct sum.
pub fn squares(
    table: &Table,
    [light, material]: [&[f64]; 2],
    normals: &[[f64; 3]],
    weights: &[f64],
) -> [f64; 3] {
    let projector = Projector::new(table);
    let d = projector.project(light, material);
    let reference = DirectSum::new(table.gram.degree, table.gram.order);
    let (image, mean) = (projector.shade(&d, normals), projector.shade(&[], normals));
    let (mut residual, mut about_mean) = (0.0, 0.0);
    for (k, weight) in weights.iter().enumerate() {
        let modes = reference.at(normals[k]);
        let seen = modes.irradiance(light, &modes.scatter(material));
        residual += weight * (seen - image[k]).powi(2);
        about_mean += weight * (seen - mean[k]).powi(2);
    }
    [d.iter().map(|d| d * d).sum(), residual, about_mean]
}

/// |d|² + |residual|² = cᵀMc, the residual by quadrature of the direct sum.
fn assert_parseval(loaded: &Loaded, table: &Table, light: &[f64], material: &[f64]) {
    let (degree, order) = (table.gram.degree, table.gram.order);
    // Exact for products of two images to rounding.
    let (normals, weights): (Vec<_>, Vec<_>) =
        fixtures::rule(2 * degree + order + 20, 2 * degree + 1).into_iter().unzip();
    let [kept, residual, about_mean] = squares(table, [light, material], &normals, &weights);
    let apart = (kept + residual - about_mean).abs() / about_mean;
    assert!(apart <= PARSEVAL, "{apart} of {about_mean}");
    if loaded.scene.basis.criterion == Criterion::ImageCentered {
        // No mean image: the whole energy is cᵀMc, through A.
        let energy = energy(table, light, material);
        assert!((energy / about_mean - 1.0).abs() <= PARSEVAL, "{energy} {about_mean}");
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn components_are_orthonormal(sample in samples()) {
        let loaded = sample.scene();
        assert_orthonormal(&loaded, &fixtures::table(&loaded));
    }

    #[test]
    fn energy_is_kept_or_left(sample in samples()) {
        let loaded = sample.whole().scene();
        let table = fixtures::table(&loaded);
        let ([light, _], [material, _]) = strangers(&sample);
        assert_parseval(&loaded, &table, &light, &material);
        let of_database = (&loaded.lights.entries[0], &loaded.materials.entries[0]);
        assert_parseval(&loaded, &table, &of_database.0.luminance(), &of_database.1.luminance());
    }

    /// Affine, for the mean image is subtracted: weights sum to 1.
    #[test]
    fn projection_is_linear(sample in samples(), weight in -3.0f64..3.0) {
        let loaded = sample.scene();
        let projector = Projector::new(&fixtures::table(&loaded));
        let apart = off_affine(&projector, strangers(&sample), weight, 0.0);
        prop_assert!(apart <= tolerances::DENSE_PROJECTION, "{apart:e}");
    }

    /// Light and normals turned about the view: nothing changes.
    #[test]
    fn turning_about_the_view_changes_nothing(sample in samples(), angle in -PI..PI) {
        let loaded = sample.scene();
        let table = fixtures::table(&loaded);
        let projector = Projector::new(&table);
        let ([light, _], [material, _]) = strangers(&sample);
        let rotation = Rotation { alpha: 0.0, beta: angle, gamma: 0.0 };
        let turned = rotation.turn(sample.degree, &light);
        let (before, after) =
            (projector.project(&light, &material), projector.project(&turned, &material));
        let (sine, cosine) = angle.sin_cos();
        let normals = fixtures::normals(&fixtures::SLANTS, 7);
        let with = |&[x, y, z]: &[f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
        let with: Vec<[f64; 3]> = normals.iter().map(with).collect();
        let (expected, found) = (projector.shade(&before, &normals), projector.shade(&after, &with));
        let worst = largest_difference(&found, &expected);
        // What the sum over components may cancel.
        let scale = largest(expected.into_iter().chain(before));
        prop_assert!(worst <= tolerances::TURNED * scale, "{worst} of {scale}");
    }

    /// A table of fewer components is the beginning of one of more, and a coarser
    /// cut-off keeps the beginning too.
    #[test]
    fn truncation_takes_a_prefix(sample in samples(), share in 0.0f64..1.0, coarser in 0.0f64..4.0) {
        let mut loaded = sample.scene();
        let all = fixtures::table(&loaded);
        let ([light, _], [material, _]) = strangers(&sample);
        let d = Projector::new(&all).project(&light, &material);
        let scale = largest(d.iter().copied());
        let count = 1 + (share * all.components.len() as f64) as usize;
        loaded.scene.basis.components = Some(count);
        let few = fixtures::table(&loaded);
        loaded.scene.basis.components = Some(usize::MAX);
        loaded.scene.basis.rank_cutoff = sample.cutoff * 10f64.powf(coarser);
        let coarse = fixtures::table(&loaded);
        prop_assert!(few.components.len() == count.min(all.components.len()));
        prop_assert!(coarse.components.len() <= all.components.len());
        prop_assert!(coarse.summary.ranks.iter().zip(&all.summary.ranks).all(|(a, b)| a <= b));
        for fewer in [&few, &coarse] {
            for (a, b) in fewer.components.iter().zip(&all.components) {
                prop_assert_eq!((a.order, a.eigenvalue), (b.order, b.eigenvalue));
                let (a, b) = (&fewer.profiles[a.profile], &all.profiles[b.profile]);
                prop_assert_eq!((&a.node_values, &a.chebyshev), (&b.node_values, &b.chebyshev));
            }
            let of_fewer = Projector::new(fewer).project(&light, &material);
            let apart = largest_difference(&of_fewer, &d[..of_fewer.len()]);
            prop_assert!(apart <= tolerances::ORTHONORMAL_NODES * scale, "{apart} of {scale}");
        }
    }

    /// Eigenvalues fall, +m stands before -m with the same one, profiles are positive
    /// at the pole; a file holds it all.
    #[test]
    fn components_are_in_order(sample in samples()) {
        let table = fixtures::table(&sample.scene());
        let values: Vec<f64> = table.components.iter().filter_map(|one| one.eigenvalue).collect();
        prop_assert!(values.is_sorted_by(|a, b| a >= b));
        for (place, one) in table.components.iter().enumerate().filter(|(_, one)| one.order < 0) {
            let before = &table.components[place - 1];
            prop_assert_eq!((before.order, before.profile), (-one.order, one.profile));
        }
        prop_assert!(values.iter().all(|value| value.is_finite() && *value > 0.0));
        let at_pole = table.profiles.iter().map(|profile| evaluate(&profile.chebyshev, 1.0));
        prop_assert!(at_pole.min_by(f64::total_cmp).is_none_or(|least| least > 0.0));
        prop_assert_eq!(decode(&encode(&table)), Ok(table));
    }

    /// Light, view and normal turned by any rotation Q, and the normal's frame by any third
    /// angle γ: the irradiance is what it was. All of D, for the frame QR is of any angles.
    #[test]
    fn light_and_view_turned_together_change_nothing(
        degree in 0usize..20,
        order in 0usize..10,
        seed in any::<u64>(),
        alpha in prop_oneof![0.0..PI, Just(0.0), Just(PI), 0.0f64..1e-6],
        beta in -PI..PI,
        last in -PI..PI,
        gamma in -PI..PI,
    ) {
        let mut numbers = Numbers(seed);
        let light = fixtures::lights(degree, 1, &mut numbers).entries[0].luminance();
        let coefficients = fixtures::materials(order, 1, &mut numbers).entries[0].luminance();
        let (reference, integrals) = (DirectSum::new(degree, order), PolarIntegrals::new(degree, order));
        let turn = rotation([alpha, beta, last]);
        let turned = turn.turn(degree, &light);
        let view = turn.matrix().map(|row| row[2]);
        let (mut worst, mut peak) = (0.0f64, 0.0f64);
        for _ in 0..6 {
            let normal = numbers.normal();
            let modes = reference.at(normal);
            let expected = modes.irradiance(&light, &modes.scatter(&coefficients));
            let [x, y, z] = normal;
            let frame = rotation([x.hypot(y).atan2(z), y.atan2(x), gamma]);
            let frame = euler(product(turn.matrix(), frame.matrix()));
            let local = frame.turn_back(degree, &turned);
            // The view in the frame.
            let columns = frame.matrix();
            let [u, v, w] =
                [0, 1, 2].map(|k| (0..3).map(|i| columns[i][k] * view[i]).sum::<f64>());
            let (theta, phi) = (u.hypot(v).atan2(w), v.atan2(u));
            let found = irradiance(&integrals, &local, (order, &coefficients), theta, phi);
            worst = largest([worst, found - expected]);
            peak = peak.max(expected.abs());
        }
        // What the sum over modes may cancel.
        let scale = peak.max(largest(light) * largest(coefficients));
        prop_assert!(worst <= tolerances::TURNED * scale, "{worst} of {scale}");
    }

    /// f(i, r) = f(r, i), to high order and at every angle.
    #[test]
    fn scattering_is_reciprocal(
        order in 0usize..17,
        seed in any::<u64>(),
        incident in 0.0..FRAC_PI_2,
        reflected in 0.0..FRAC_PI_2,
        azimuth in -PI..PI,
    ) {
        let mut numbers = Numbers(seed);
        let coefficients: Vec<f64> = (0..material::count(order)).map(|_| numbers.next()).collect();
        let one = scattering::brdf(order, &coefficients, incident, reflected, azimuth);
        let other = scattering::brdf(order, &coefficients, reflected, incident, -azimuth);
        let modes = scattering::modes(order, incident, reflected, azimuth);
        let scale: f64 = modes.iter().map(|mode| mode.abs()).sum();
        prop_assert!((one - other).abs() <= tolerances::ORTHONORMAL_NODES * scale);
    }
}

/// Each of `table`'s components against the others, in node space and over modes.
fn assert_orthonormal(loaded: &Loaded, table: &Table) {
    let gram = &table.gram;
    let moments = moments::LightMoments::new(&loaded.lights, table.scene.light.normalize);
    let moments = moments.expect("positive lights");
    let of_materials = moments::MaterialMoments::new(&loaded.materials);
    let (criterion, cut) = (table.scene.basis.criterion, table.scene.basis.rank_cutoff);
    for azimuth in 0..=gram.degree {
        let profiles: Vec<_> =
            table.profiles.iter().enumerate().filter(|(_, one)| one.azimuth == azimuth).collect();
        if profiles.is_empty() {
            continue;
        }
        let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
        let columns = gram.columns(azimuth);
        let image = |modes: &[f64]| {
            let mut image = vec![0.0; gram.nodes.len()];
            for (column, value) in columns.iter().zip(modes) {
                image.iter_mut().zip(column).for_each(|(pixel, a)| *pixel += value * a);
            }
            image
        };
        let images: Vec<_> = profiles.iter().map(|(_, one)| image(&one.modes)).collect();
        // What of a component lies where the cut-off counts A as zero: A F v / σ_k, so
        // at most cut-off |A| |F| / σ_k.
        let deviations = moments::deviations(&moments, &of_materials, criterion, azimuth);
        let squares = deviations.iter().flat_map(|one| &one.material).map(|b| b * b);
        let factor = squares.sum::<f64>().sqrt();
        let lost = |k: usize| {
            let component = table.components.iter().find(|one| one.profile == k);
            let value = component.and_then(|one| one.eigenvalue).map_or(1.0, f64::sqrt);
            // The constant is the image of one mode, of variance 1/16.
            let over = if value == 1.0 { factor.max(4.0) } else { factor };
            cut * table.summary.largest_singular_value * over / value
        };
        for (i, (k, a)) in profiles.iter().enumerate() {
            for (j, (n, b)) in profiles.iter().enumerate().take(i + 1) {
                let one = f64::from(u8::from(i == j));
                let nodes = (product(&a.node_values, &b.node_values) - one).abs();
                assert!(nodes <= tolerances::ORTHONORMAL_NODES, "WᵀW {nodes} of {azimuth}");
                let allowed = lost(*k) + lost(*n) + tolerances::ORTHONORMAL_ROUNDING / cut;
                let modes = (product(&images[i], &images[j]) - one).abs();
                assert!(modes <= allowed, "UᵀMU {modes} of {allowed}, |m| = {azimuth}: {i}, {j}");
            }
        }
    }
}

/// cᵀMc = Σ_m |A c|².
fn energy(table: &Table, light: &[f64], material: &[f64]) -> f64 {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let mut energy = 0.0;
    for azimuth in 0..=degree {
        let columns = table.gram.columns(azimuth);
        let m = azimuth.cast_signed();
        for order_m in if m == 0 { vec![0] } else { vec![m, -m] } {
            let mut image = vec![0.0; table.gram.nodes.len()];
            for ((l, o, p, q), column) in mode::indices(degree, order, azimuth).zip(&columns) {
                let c = light[light::position(l, order_m)] * material[material::position(o, p, q)];
                image.iter_mut().zip(column).for_each(|(pixel, a)| *pixel += c * a);
            }
            energy += image.iter().map(|pixel| pixel * pixel).sum::<f64>();
        }
    }
    energy
}

/// How far the projection of a weighted sum of two lights, or of two materials, is from the sum of
/// theirs, of the larger and of `least`.
pub fn off_affine(
    projector: &Projector,
    ([light, other], [material, on]): ([Vec<f64>; 2], [Vec<f64>; 2]),
    weight: f64,
    least: f64,
) -> f64 {
    let mix = |a: &[f64], b: &[f64]| -> Vec<f64> {
        a.iter().zip(b).map(|(a, b)| weight * a + (1.0 - weight) * b).collect()
    };
    let first = projector.project(&light, &material);
    let of_lights =
        (projector.project(&mix(&light, &other), &material), projector.project(&other, &material));
    let of_materials =
        (projector.project(&light, &mix(&material, &on)), projector.project(&light, &on));
    largest([of_lights, of_materials].map(|(mixed, second)| {
        let scale = largest(first.iter().chain(&second).copied()) * (1.0 + weight.abs()) + least;
        largest(mixed.iter().zip(mix(&first, &second)).map(|(a, b)| a - b)) / scale
    }))
}
