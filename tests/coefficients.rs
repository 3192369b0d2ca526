//! The coefficients d: effects are sets of degrees and orders, and estimates from the pixels of a
//! quadrature are d from light and material.

use crate::tolerances;
use eigenshade::{Effect, Error, Q15, sphere};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::material;
use eigenshade_testing::fixtures::{self, normal, projected};
use eigenshade_testing::images::single;
use eigenshade_testing::relative_error;
use std::ops::RangeInclusive;

/// The degrees l and the orders o of each effect.
const MODES: [(Effect, RangeInclusive<usize>, RangeInclusive<usize>); 4] = [
    (Effect::Ambient, 0..=0, 0..=5),
    (Effect::Diffuse, 1..=12, 0..=0),
    (Effect::Broad, 1..=12, 1..=3),
    (Effect::Gloss, 1..=12, 4..=5),
];

/// Masks leave the coefficients of an effect's degrees and orders, floats and mantissas alike.
#[test]
fn effects_are_the_modes_of_their_degrees_and_orders() {
    for (effect, degrees, orders) in MODES {
        let (mut light, mut material) = ([1.5f32; 169], [Q15(3); 20]);
        effect.mask_light(&mut light);
        effect.mask_material(&mut material);
        for (k, &number) in light.iter().enumerate() {
            assert_eq!(number != 0.0, degrees.contains(&k.isqrt()), "{effect:?} {k}");
        }
        for ((o, p, q), &number) in material::indices(5).zip(&material) {
            assert_eq!(number.0 != 0, orders.contains(&o), "{effect:?} {o} {p} {q}");
        }
    }
}

/// d by the sum over 912 pixels in f32, which is compensated: roundings of pixels and of d itself, of
/// the largest d.
const ESTIMATE_F32: f64 = 2e-6;

#[test]
fn weighted_pixels_give_back_the_coefficients() {
    let mut loaded = fixtures::shipped("curet");
    loaded.scene.basis.components = Some(60);
    loaded.scene.basis.profile_tolerance = 1e-13;
    let owned = OwnedBasis::new(&fixtures::table(&loaded)).expect("a table for f32");
    let basis = owned.basis().expect("parts of a table");
    let [light, material] = [&loaded.lights.entries[3], &loaded.materials.entries[8]];
    let d = projected(&basis, &single(light.luminance()), &single(material.luminance()));
    let scene = basis.collapse_into(&d, vec![0.0; basis.scene_len()]).expect("sizes");
    let mut estimate = basis.estimate::<60>().expect("room");
    for (at, weight) in fixtures::rule(48, 19) {
        // Any factor of all weights drops out.
        estimate.add(normal(at), scene.shade(normal(at)), 7.0 * weight as f32);
    }
    let wide = |numbers: &[f32]| numbers.iter().map(|&number| number.into()).collect::<Vec<f64>>();
    let apart = relative_error(&wide(&estimate.coefficients().expect("pixels")), &wide(&d));
    assert!(apart <= ESTIMATE_F32, "{apart}");
}

#[test]
fn estimates_without_pixels_or_room_are_errors() {
    assert!(matches!(
        sphere::BASIS.estimate::<{ sphere::COMPONENTS - 1 }>(),
        Err(Error::Capacity { .. })
    ));
    let mut estimate = sphere::estimate();
    assert_eq!(estimate.coefficients(), Err(Error::Weight));
    let front = normal([0.0, 0.0, 1.0]);
    for weight in [0.0, f32::INFINITY] {
        estimate.add(front, 1.0, weight);
        assert_eq!(estimate.coefficients(), Err(Error::Weight), "{weight}");
    }
    let mut estimate = sphere::estimate();
    estimate.add(front, 1.0, 2.0);
    let d = estimate.coefficients().expect("a pixel");
    // Component 0 is the constant image.
    assert!((d[0] - 1.0).abs() <= tolerances::SAME_SUM_F32, "{}", d[0]);
}

#[test]
fn a_million_tenths_are_a_tenth_on_average() {
    let (mut estimate, front) = (sphere::estimate(), normal([0.0, 0.0, 1.0]));
    let mut plain = 0.0f32;
    for _ in 0..1_000_000 {
        estimate.add(front, 0.1, 1.0);
        plain += 0.1;
    }
    let off = (plain / 1e5 - 1.0).abs();
    println!("plain: {off:.1e}");
    assert!((0.009..0.01).contains(&off), "{off}");
    let d = estimate.coefficients().expect("pixels");
    assert!((d[0] / 0.1 - 1.0).abs() <= tolerances::SAME_SUM_F32, "{}", d[0]);
}

#[test]
fn an_irradiance_that_is_not_finite_spoils_every_coefficient() {
    for (seen, weight) in [(f32::NAN, 1.0), (f32::INFINITY, 1.0), (f32::NEG_INFINITY, 0.0)] {
        for at in [[0.0, 0.0, 1.0], [0.3, -0.2, 0.5]] {
            let mut estimate = sphere::estimate();
            let good = normal([0.1, 0.2, 0.9]);
            estimate.add(good, 1.0, 1.0);
            estimate.add(normal(at), seen, weight);
            estimate.add(good, 1.0, 1.0);
            let d = estimate.coefficients().expect("weights");
            assert!(d.iter().all(|value| !value.is_finite()), "{seen} {weight}: {d:?}");
        }
    }
}
