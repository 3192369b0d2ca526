//! What holds for every scene of a sphere.

use crate::config;
use crate::over_modes::{assert_orthonormal, energy};
use crate::samples::{samples, strangers};
use crate::tolerances;
use eigenshade_generator::basis::profile::evaluate;
use eigenshade_generator::scene_file::Loaded;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::rotation::Rotation;
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_table::scene::Criterion;
use eigenshade_table::{Table, decode, encode};
use eigenshade_testing::fixtures::Projector;
use eigenshade_testing::{fixtures, largest};
use proptest::prelude::*;
use std::f64::consts::{PI, TAU};

/// |d|² + residual against the energy, relative: the orthonormality of W, twice, and polynomials
/// that end at 1e-13.
const PARSEVAL: f64 = 2e-14;

/// Normals of the sphere and their weights, which sum to 1: exact for products of two
/// images to rounding.
fn quadrature(degree: usize, order: usize) -> Vec<([f64; 3], f64)> {
    let tilts = 2 * degree + 1;
    let mut normals = Vec::new();
    for (z, weight) in gauss_legendre(2 * degree + order + 20, 0.0, 1.0) {
        let sine = ((1.0 - z) * (1.0 + z)).sqrt();
        for k in 0..tilts {
            let (y, x) = (TAU * k as f64 / tilts as f64).sin_cos();
            normals.push(([sine * x, sine * y, z], 2.0 * z * weight / tilts as f64));
        }
    }
    normals
}

/// |d|² + |residual|² = cᵀMc, the residual by quadrature of the direct sum.
fn assert_parseval(loaded: &Loaded, table: &Table, light: &[f64], material: &[f64]) {
    let (degree, order) = (table.gram.degree, table.gram.order);
    let projector = Projector::new(table);
    let d = projector.project(light, material);
    let reference = DirectSum::new(degree, order);
    let (mut residual, mut about_mean) = (0.0, 0.0);
    let (normals, weights): (Vec<_>, Vec<_>) = quadrature(degree, order).into_iter().unzip();
    let (image, mean) = (projector.shade(&d, &normals), projector.shade(&[], &normals));
    for (k, weight) in weights.iter().enumerate() {
        let modes = reference.at(normals[k]);
        let seen = modes.irradiance(light, &modes.scatter(material));
        residual += weight * (seen - image[k]).powi(2);
        about_mean += weight * (seen - mean[k]).powi(2);
    }
    let kept: f64 = d.iter().map(|d| d * d).sum();
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
        let loaded = sample.whole();
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
        let ([light, other], [material, on]) = strangers(&sample);
        let mix = |a: &[f64], b: &[f64]| -> Vec<f64> {
            a.iter().zip(b).map(|(a, b)| weight * a + (1.0 - weight) * b).collect()
        };
        for (mixed, first, second) in [
            (projector.project(&mix(&light, &other), &material), (&light, &material), (&other, &material)),
            (projector.project(&light, &mix(&material, &on)), (&light, &material), (&light, &on)),
        ] {
            let first = projector.project(first.0, first.1);
            let second = projector.project(second.0, second.1);
            let scale = largest(first.iter().chain(&second).copied()) * (1.0 + weight.abs());
            let apart = mixed.iter().zip(mix(&first, &second)).map(|(a, b)| a - b);
            prop_assert!(largest(apart) <= tolerances::DENSE_PROJECTION * scale);
        }
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
        let (mut worst, mut peak) = (0.0f64, 0.0f64);
        let normals = fixtures::normals(&fixtures::SLANTS, 7);
        let with = |&[x, y, z]: &[f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
        let with: Vec<[f64; 3]> = normals.iter().map(with).collect();
        let (expected, found) = (projector.shade(&before, &normals), projector.shade(&after, &with));
        for (found, expected) in found.iter().zip(&expected) {
            worst = worst.max((found - expected).abs());
            peak = peak.max(expected.abs());
        }
        // What the sum over components may cancel.
        let scale = peak.max(largest(before.iter().copied()));
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
            let apart = largest(of_fewer.iter().zip(&d).map(|(a, b)| a - b));
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
}
