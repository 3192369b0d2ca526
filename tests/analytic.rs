//! Lights of formulas against sums of the model's spherical harmonics over their directions.

use eigenshade::mathematics::{Libm, SinglePrecision};
use eigenshade::{AnalyticLight, Error, Light, Window};
use eigenshade_model::special::spherical_harmonic;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Midpoints in the angle from the middle of a disc, relative to its coefficients.
const MIDPOINTS: f64 = 1e-6;

/// f32 against f64, relative to the largest coefficient.
const SINGLE: f64 = 2e-6;

const DIRECTIONS: [[f64; 3]; 5] =
    [[0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [1.0, 0.0, 0.0], [0.3, -0.5, 0.2], [-4.0, 3.0, -1.0]];

fn unit(direction: [f64; 3]) -> [f64; 3] {
    let length = direction.iter().map(|c| c * c).sum::<f64>().sqrt();
    direction.map(|c| c / length)
}

/// The integral of every harmonic over a disc.
fn disc(direction: [f64; 3], radius: f64) -> Vec<f64> {
    let [x, y, z] = unit(direction);
    // Two directions across.
    let across = if x.abs() < 0.5 { unit([0.0, -z, y]) } else { unit([-y, x, 0.0]) };
    let [a, b, c] = across;
    let other = [y * c - z * b, z * a - x * c, x * b - y * a];
    let (rings, turns) = (2000, 24);
    let mut sums = vec![0.0; 100];
    for ring in 0..rings {
        let (width, height) = (radius * (f64::from(ring) + 0.5) / f64::from(rings)).sin_cos();
        for turn in 0..turns {
            let (sine, cosine) = (TAU * f64::from(turn) / f64::from(turns)).sin_cos();
            let along = [0, 1, 2]
                .map(|i| [x, y, z][i] * height + width * (cosine * across[i] + sine * other[i]));
            let harmonics = spherical_harmonic::all(9, along);
            sums.iter_mut().zip(harmonics).for_each(|(sum, value)| *sum += width * value);
        }
    }
    sums.into_iter().map(|sum| sum * TAU * radius / f64::from(rings * turns)).collect()
}

fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    let largest = expected.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (found, expected) in found.iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance * largest, "{found} {expected}");
    }
}

#[test]
fn discs_are_integrals_of_harmonics() {
    for direction in DIRECTIONS {
        for radius in [0.05, 0.5, FRAC_PI_2, 2.5, PI] {
            let light = AnalyticLight::<f64, 100>::dark().unwrap();
            let light = light.disc::<Libm>(direction, radius, 3.0).unwrap();
            let expected: Vec<f64> =
                disc(direction, radius).into_iter().map(|value| 3.0 * value).collect();
            assert_near(light.light().unwrap().coefficients(), &expected, MIDPOINTS);
            // Small radii keep their digits in f32.
            let light = AnalyticLight::<f32, 100>::dark().unwrap();
            let [direction, [radius, ..]] = [direction, [radius; 3]].map(|d| d.map(|c| c as f32));
            let light = light.disc::<SinglePrecision>(direction, radius, 3.0).unwrap();
            let found = light.light().unwrap().coefficients().iter();
            let found: Vec<f64> = found.map(|&value| value.into()).collect();
            assert_near(&found, &expected, MIDPOINTS + SINGLE);
        }
    }
}

/// A disc as small as the sun is a direction, and a disc of all directions is ambient light.
#[test]
fn limits_of_a_disc() {
    for direction in DIRECTIONS {
        let dark = AnalyticLight::<f32, 100>::dark().unwrap();
        let radius = 0.004_65_f32;
        let area = 2.0 * PI * (1.0 - f64::from(radius).cos());
        let sun = dark.disc::<SinglePrecision>(direction.map(|c| c as f32), radius, 1.0).unwrap();
        let expected = spherical_harmonic::all(9, unit(direction));
        let found = sun.light().unwrap().coefficients().iter();
        let found: Vec<f64> = found.map(|&value| f64::from(value) / area).collect();
        // (l radius / 2)² / 2 at l = 9.
        assert_near(&found, &expected, 5e-4);
        let dark = AnalyticLight::<f64, 100>::dark().unwrap();
        let light = dark.directional::<Libm>(direction, 2.0).unwrap();
        let expected: Vec<f64> = expected.iter().map(|value| 2.0 * value).collect();
        assert_near(light.light().unwrap().coefficients(), &expected, 1e-13);
        let whole = dark.disc::<Libm>(direction, PI, 0.7).unwrap();
        let ambient = dark.ambient(0.7);
        let expected = ambient.light().unwrap();
        assert_near(whole.light().unwrap().coefficients(), expected.coefficients(), 1e-13);
    }
}

#[test]
fn lights_are_summed_scaled_and_windowed() {
    let dark = AnalyticLight::<f64, 16>::dark().unwrap();
    let [sky, ground] = [1.5, 0.25];
    let light = dark.hemisphere::<Libm>([0.0, 2.0, 0.0], sky, ground).unwrap();
    let halves = dark
        .disc::<Libm>([0.0, 1.0, 0.0], FRAC_PI_2, sky)
        .and_then(|light| light.disc::<Libm>([0.0, -1.0, 0.0], FRAC_PI_2, ground))
        .unwrap();
    let halves = halves.light().unwrap();
    assert_near(light.light().unwrap().coefficients(), halves.coefficients(), 1e-14);
    let twice = light.plus(&light.light().unwrap()).unwrap();
    assert_near(
        twice.light().unwrap().coefficients(),
        light.scaled(2.0).light().unwrap().coefficients(),
        1e-15,
    );
    let window = Window::SincFourth { width: 5.0 };
    let windowed = light.windowed::<Libm>(window);
    let expected = light.light().unwrap().windowed::<Libm, 16>(window).unwrap();
    assert_eq!(windowed.light().unwrap().coefficients(), expected.as_slice());
}

#[test]
fn bad_lights_are_refused() {
    assert!(AnalyticLight::<f32, 10>::dark().is_err());
    let dark = AnalyticLight::<f32, 4>::dark().unwrap();
    for direction in [[0.0; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
        let refused = dark.directional::<SinglePrecision>(direction, 1.0);
        assert_eq!(refused, Err(Error::Direction));
        let refused = dark.hemisphere::<SinglePrecision>(direction, 1.0, 0.0);
        assert_eq!(refused, Err(Error::Direction));
    }
    for radius in [0.0, -1.0, 3.2, f32::NAN] {
        let refused = dark.disc::<SinglePrecision>([0.0, 0.0, 1.0], radius, 1.0);
        assert_eq!(refused, Err(Error::Direction));
    }
    let higher = Light::new(&[1.0; 9]).unwrap();
    assert!(matches!(dark.plus(&higher), Err(Error::Capacity { needed: 9, capacity: 4, .. })));
}
