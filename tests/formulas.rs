//! Lights of formulas against sums of the model's spherical harmonics over their directions, and
//! the nine-term formula against the harmonics of degree 2 themselves, integrated.

use crate::invariants::integer::{self, Mantissa as _};
use crate::oracle::{ExplicitLight, irradiance};
use eigenshade::lights::{AnalyticLight, NineTerms, Window};
use eigenshade::{Argument, Error, Light, Normals, Q15, Rgb, q15};
use eigenshade_model::special::quadrature::gauss_legendre;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_table::light;
use eigenshade_testing::fixtures::{axes, normal, spiral};
use eigenshade_testing::relative_error;
use eigenshade_testing::vectors::{cross, unit};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Roundings of f32 in a recurrence of nine steps, relative to the largest coefficient.
const SINGLE: f64 = 2e-6;

const DIRECTIONS: [[f64; 3]; 5] =
    [[0.0, 0.0, 1.0], [0.0, 0.0, -2.0], [1.0, 0.0, 0.0], [0.3, -0.5, 0.2], [-4.0, 3.0, -1.0]];

/// The integral of every harmonic over a disc.
fn disc(direction: [f64; 3], radius: f64) -> Vec<f64> {
    let center @ [x, y, z] = unit(direction);
    // Two directions across.
    let across = if x.abs() < 0.5 { unit([0.0, -z, y]) } else { unit([-y, x, 0.0]) };
    let other = cross(center, across);
    let turns = 24;
    let mut sums = vec![0.0; 100];
    for (angle, weight) in gauss_legendre(40, 0.0, radius) {
        let (width, height) = angle.sin_cos();
        for turn in 0..turns {
            let (sine, cosine) = (TAU * f64::from(turn) / f64::from(turns)).sin_cos();
            let along = [0, 1, 2]
                .map(|i| center[i] * height + width * (cosine * across[i] + sine * other[i]));
            let harmonics = spherical_harmonic::all(9, along);
            sums.iter_mut().zip(harmonics).for_each(|(sum, value)| *sum += weight * width * value);
        }
    }
    sums.into_iter().map(|sum| sum * TAU / f64::from(turns)).collect()
}

fn coefficients<const N: usize>(light: &AnalyticLight<N>) -> Vec<f64> {
    let light = light.light().expect("finite numbers");
    light.coefficients().iter().map(|&value| value.into()).collect()
}

fn assert_near(found: &[f64], expected: &[f64], tolerance: f64) {
    let error = relative_error(found, expected);
    assert!(error <= tolerance, "{error:e}");
}

#[test]
fn discs_are_integrals_of_harmonics() {
    for direction in DIRECTIONS {
        for radius in [0.05, 0.5, FRAC_PI_2, 2.5, PI] {
            let expected: Vec<f64> =
                disc(direction, radius).into_iter().map(|value| 3.0 * value).collect();
            // Small radii keep their digits in f32.
            let light = AnalyticLight::<100>::dark().unwrap();
            let [direction, [radius, ..]] = [direction, [radius; 3]].map(|d| d.map(|c| c as f32));
            let light = light.disc(direction, radius, 3.0).unwrap();
            assert_near(&coefficients(&light), &expected, SINGLE);
        }
    }
}

/// A disc as small as the sun is a direction, and a disc of all directions is ambient light.
#[test]
fn limits_of_a_disc() {
    for direction in DIRECTIONS {
        let dark = AnalyticLight::<100>::dark().unwrap();
        let radius = 0.004_65_f32;
        let area = 2.0 * PI * (1.0 - f64::from(radius).cos());
        let sun = dark.disc(direction.map(|c| c as f32), radius, 1.0).unwrap();
        let expected = spherical_harmonic::all(9, unit(direction));
        let found: Vec<f64> = coefficients(&sun).iter().map(|value| value / area).collect();
        // (l radius / 2)² / 2 at l = 9.
        assert_near(&found, &expected, 5e-4);
        let direction = direction.map(|c| c as f32);
        let light = dark.directional(direction, 2.0).unwrap();
        let expected: Vec<f64> = expected.iter().map(|value| 2.0 * value).collect();
        assert_near(&coefficients(&light), &expected, SINGLE);
        let whole = dark.disc(direction, PI as f32, 0.7).unwrap();
        assert_near(&coefficients(&whole), &coefficients(&dark.ambient(0.7)), SINGLE);
    }
}

#[test]
fn lights_are_summed_scaled_and_windowed() {
    let dark = AnalyticLight::<16>::dark().unwrap();
    let [sky, ground] = [1.5, 0.25];
    let light = dark.hemisphere([0.0, 2.0, 0.0], sky, ground).unwrap();
    let halves = dark
        .disc([0.0, 1.0, 0.0], FRAC_PI_2 as f32, sky)
        .and_then(|light| light.disc([0.0, -1.0, 0.0], FRAC_PI_2 as f32, ground))
        .unwrap();
    let twice = light.plus(&light.light().unwrap()).unwrap();
    assert_near(&coefficients(&light), &coefficients(&halves), SINGLE);
    assert_eq!(coefficients(&twice), coefficients(&light.scaled(2.0)));
    let window = Window::SincFourth { width: 5.0 };
    let windowed = light.windowed(window);
    let expected = light.light().unwrap().windowed::<16>(window).unwrap();
    assert_eq!(windowed.light().unwrap().coefficients(), expected.as_slice());
}

/// Each channel of a light in color is that of a call of its own.
#[test]
fn lights_in_color_are_three_lights() {
    let [sky, ground, lamp, sun] = [[0.3, 0.5, 1.0], [0.2, 0.1, 0.0], [9.0, 8.0, 6.0], [3.0; 3]];
    let [up, aside] = [[0.0, 1.0, 0.0], [1.0, 1.0, 1.0]];
    let window = Window::SincFourth { width: 8.0 };
    let base = Rgb::<AnalyticLight<25>>::dark().unwrap().ambient(ground);
    let light = base
        .hemisphere(up, sky, ground)
        .and_then(|light| light.disc(aside, 0.3, lamp))
        .and_then(|light| light.directional(up, sun)?.plus(base.lights()?))
        .unwrap()
        .scaled(0.5)
        .windowed(window);
    for (c, found) in <[_; 3]>::from(light.lights().unwrap()).into_iter().enumerate() {
        let base = AnalyticLight::<25>::dark().unwrap().ambient(ground[c]);
        let light = base
            .hemisphere(up, sky[c], ground[c])
            .and_then(|light| light.disc(aside, 0.3, lamp[c]))
            .and_then(|light| light.directional(up, sun[c])?.plus(&base.light()?))
            .unwrap();
        assert_eq!(light.scaled(0.5).windowed(window).light(), Ok(found));
    }
}

#[test]
fn bad_lights_are_refused() {
    assert!(AnalyticLight::<10>::dark().is_err());
    let bright = AnalyticLight::<4>::dark().unwrap().ambient(f32::NAN);
    assert_eq!(
        bright.light().err(),
        Some(Error::NotFinite { argument: Argument::Light, index: 0 })
    );
    let dark = AnalyticLight::<4>::dark().unwrap();
    for direction in [[0.0; 3], [f32::NAN, 0.0, 1.0], [f32::INFINITY, 0.0, 0.0]] {
        let refused = dark.directional(direction, 1.0);
        assert_eq!(refused, Err(Error::Direction));
        let refused = dark.hemisphere(direction, 1.0, 0.0);
        assert_eq!(refused, Err(Error::Direction));
    }
    for radius in [0.0, -1.0, 3.2, f32::NAN] {
        let refused = dark.disc([0.0, 0.0, 1.0], radius, 1.0);
        assert_eq!(refused, Err(Error::Direction));
    }
    let higher = Light::new(&[1.0; 9]).unwrap();
    assert!(matches!(dark.plus(&higher), Err(Error::Capacity { needed: 9, capacity: 4, .. })));
}

/// The nine-term formula in f32 against the integral of harmonics of degree 2: rounding of a few
/// dozen sums of numbers below 1.
const NINE_TERMS_F32: f64 = 5e-7;

/// The same in integers, of the sum of its coefficients' sizes: six roundings to 14 bits of that
/// sum, 5.2e-5 found.
const NINE_TERMS_Q15: f64 = 6e-5;

/// Directions all over the visible hemisphere, with pole and rim.
fn normals() -> Vec<[f64; 3]> {
    spiral((0..=60).map(|k| f64::from(k) / 60.0))
}

fn unit_light(mode: usize) -> [f32; 9] {
    std::array::from_fn(|k| f32::from(u8::from(k == mode)))
}

/// Under each harmonic alone; f = 0.7/π is b_00^0 = 1.4.
#[test]
fn nine_terms_are_the_harmonics_of_degree_two_on_a_lambertian_material() {
    for (mode, (l, m)) in light::indices(2).enumerate() {
        let light = unit_light(mode);
        let formula = NineTerms::lambertian(&Light::new(&light).unwrap(), 0.7);
        let light = ExplicitLight::new(&light.map(f64::from));
        for at in normals() {
            let found = f64::from(formula.shade(normal(at)));
            let off = (found - irradiance(&light, &[(0, 0, 0, 1.4)], at)).abs();
            assert!(off <= NINE_TERMS_F32, "{l} {m} at {at:?}: {off:e}");
        }
    }
}

/// Coefficients stand where `new` says.
#[test]
fn each_coefficient_is_of_its_function() {
    let functions: [fn([f64; 3]) -> f64; 9] = [
        |_| 1.0,
        |[x, _, _]| x,
        |[_, y, _]| y,
        |[_, _, z]| z,
        |[x, y, _]| x * x - y * y,
        |[x, y, _]| x * y,
        |[x, _, z]| x * z,
        |[_, y, z]| y * z,
        |[_, _, z]| z * z,
    ];
    for (term, function) in functions.into_iter().enumerate() {
        let formula = NineTerms::new(unit_light(term));
        let one = unit_light(term).map(|one| one as i32);
        let in_q15 = q15::NineTerms::new(one.map(|one| one << 14), -14);
        for at in normals() {
            let ways = [
                ((formula.shade(normal(at)).into(), at), NINE_TERMS_F32),
                (shaded(&in_q15, at), 1e-4),
            ];
            for ((found, at), most) in ways {
                assert!((found - function(at)).abs() <= most, "{term} at {at:?}: {found}");
            }
        }
    }
}

/// The irradiance of a rounded normal, and that normal.
fn shaded(formula: &q15::NineTerms, normal: [f64; 3]) -> (f64, [f64; 3]) {
    let normal = integer::normal(normal.map(Q15::rounded)).expect("a unit normal");
    let found = f64::from(formula.shade(normal)) * f64::from(formula.exponent()).exp2();
    (found, normal.components().map(Q15::to_f64))
}

/// Sums of the largest coefficients fit: signs as bad as they can be, of the sum of their sizes
/// against f64.
fn worst() -> f64 {
    let largest: f64 = 32_767.0;
    let off = (0..512u32).flat_map(|signs| {
        let c = std::array::from_fn(|k| if signs >> k & 1 == 0 { largest } else { -largest });
        let formula = q15::NineTerms::new(c.map(|one| one as i32), -8);
        let off = move |normal| {
            let (found, [x, y, z]) = shaded(&formula, normal);
            let terms = [1.0, x, y, z, x * x - y * y, x * y, x * z, y * z, z * z];
            let expected: f64 = c.iter().zip(terms).map(|(c, term)| c * term).sum();
            (256.0 * found - expected) / (9.0 * largest)
        };
        normals().into_iter().map(off)
    });
    eigenshade_testing::largest(off)
}

#[test]
fn integers_do_not_wrap() {
    let found = worst();
    println!("{found:e}");
    assert!(found <= NINE_TERMS_Q15, "{found}");
}

#[test]
fn a_slice_is_shaded_as_its_normals() {
    let [x, y, z] = axes(&normals().into_iter().map(normal).collect::<Vec<_>>());
    let formula = NineTerms::new([0.9f32, 0.2, -0.1, 0.5, 0.05, 0.02, -0.03, 0.01, 0.07]);
    let normals = Normals::new(&x, &y, &z).unwrap();
    let mut irradiance = vec![0.0; x.len()];
    formula.shade_slice(normals, &mut irradiance).unwrap();
    for (normal, found) in normals.iter().zip(&irradiance) {
        assert_eq!(formula.shade(normal), *found);
    }
    assert!(formula.shade_slice(normals, &mut irradiance[1..]).is_err());
}
