//! Symmetries of the irradiance itself: reciprocity, and light and view that turn
//! together.

use crate::config;
use crate::tolerances;
use eigenshade_index::material;
use eigenshade_model::polar_integral::PolarIntegrals;
use eigenshade_model::reference::DirectSum;
use eigenshade_model::scattering;
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::rotations::{euler, irradiance, product, rotation};
use eigenshade_testing::{fixtures, largest};
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

proptest! {
    #![proptest_config(config())]

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
