//! Scenes within a tolerance: what an image does not need costs nothing, and the bound holds of
//! long series too. `truncation_sets` compares bounds with errors.

use eigenshade::lights::NineTerms;
use eigenshade::truncation::{Tolerance, Truncation};
use eigenshade::{Error, Light, Material, Normal, Normals, Scene, sphere};
use eigenshade_generator::basis::build;
use eigenshade_model::inputs::coefficient_csv::{read_lights, read_materials};
use eigenshade_model::reference::DirectSum;
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_table::decode;
use eigenshade_testing::{fixtures, images};
use images::{Image, coefficients, products, rule, single, vectors};

/// A scene's error beyond its bound, of the peak: roundings to f32 add to the smallest bound, 1e-6 of
/// the peak, as squares do. 6e-10 found.
const BOUND_ROUNDING: f64 = 5e-9;

/// A scene of a matte under light of degree 2 within 1e-3 of the peak against the nine-term
/// formula, of the peak: what is left out has no part in nine terms, so what remains is the
/// table's own error, 1.4e-6 found.
const NINE_TERMS: f64 = 3e-6;

type Numbers = [f32; sphere::SCENE];

fn truncated<'l>(
    d: &[f32],
    tolerance: Tolerance,
    lengths: &'l mut [u16],
) -> (Scene<'l, Numbers>, Truncation) {
    sphere::BASIS.collapse_within(d, tolerance, lengths, [0.0; sphere::SCENE]).expect("it fits")
}

/// Σ |b| = 2 f, f = 1/π.
const MATTE: [f32; 1] = [2.0];

/// A white matte by the nine-term formula.
fn nine_terms(light: &[f32]) -> impl Fn([f64; 3]) -> f64 {
    let formula = NineTerms::lambertian(&Light::new(light).expect("a light"), 1.0);
    move |at| formula.shade(fixtures::normal(at)).into()
}

#[test]
fn a_matte_is_shaded_as_by_the_nine_term_formula() {
    let light: Vec<f32> = (0..9).map(|k| 3.5 / (1.0 + k as f32)).collect();
    let (d, formula) = (coefficients(&light, &MATTE), nine_terms(&light));
    let mut lengths = [0; 16];
    let (scene, report) = truncated(&d, Tolerance::OfPeak(1e-3), &mut lengths);
    let mut worst: f64 = 0.0;
    for (normal, _) in rule() {
        let expected = formula(normal.components().map(f64::from));
        worst = worst.max((f64::from(scene.shade(normal)) - expected).abs());
    }
    println!("{report:?}, {:e}", worst / f64::from(report.peak));
    assert!(report.terms <= 9 && report.azimuths <= 3, "{report:?}");
    assert!(worst <= NINE_TERMS * f64::from(report.peak), "{worst}");
}

/// Where the formula is near enough, a pixel costs no more than by the formula, but for one product
/// under one light.
#[test]
fn a_matte_costs_no_more_than_nine_terms_where_they_are_enough() {
    let lights = read_lights("tables/inputs/lights.csv", Some(9)).expect("the shipped lights");
    let (vectors, rule) = (vectors(), rule());
    let reference = DirectSum::new(9, 0);
    let mut dearer = Vec::new();
    for entry in &lights.entries {
        let light = single(entry.luminance());
        let (d, formula) = (coefficients(&light, &MATTE), nine_terms(&light));
        let image = Image::new(&d, &rule);
        let squares = vectors.iter().map(|&(at, weight)| {
            let modes = reference.at(at);
            let direct = modes.irradiance(&entry.luminance(), &modes.scatter(&[2.0]));
            weight * (formula(at) - direct).powi(2)
        });
        let share = (squares.sum::<f64>().sqrt() / image.peak).max(1e-2);
        let mut lengths = [0; 16];
        let (_, report) = truncated(&d, Tolerance::OfPeak(share as f32), &mut lengths);
        let cost = products(&lengths[..report.azimuths]);
        println!("{}: {share:.4}, {cost}: {:?}", entry.name, &lengths[..report.azimuths]);
        if cost > products(&[3, 2, 1]) {
            dearer.push((&entry.name, share, cost));
        }
    }
    let few = |&(_, _, cost): &_| cost <= products(&[3, 2, 1]) + 1;
    assert!(dearer.len() <= 1 && dearer.iter().all(few), "{dearer:?}");
}

/// Constants, nine terms, tiles and blocks: a slice is shaded as its normals are.
#[test]
fn slices_of_short_scenes_are_shaded_as_their_normals() {
    let light: Vec<f32> = (0..100).map(|k| (1.3 * k as f32).cos() / (1.0 + k as f32)).collect();
    let material: Vec<f32> = (0..40).map(|k| 1.0 / (k as f32 + 1.0)).collect();
    let mut terms = Vec::new();
    for (light, material) in [
        (&light[..1], &MATTE[..]),
        (&light[..4], &MATTE),
        (&light[..9], &MATTE),
        (&light, &MATTE),
        (&light, &material),
    ] {
        let d = coefficients(light, material);
        for share in [0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-6] {
            let mut lengths = [0; 16];
            let (scene, report) = truncated(&d, Tolerance::OfPeak(share), &mut lengths);
            terms.push(report.terms);
            for count in [0, 1, 23, 24, 63, 64, 65, 200] {
                let normals: Vec<_> = (0..count)
                    .map(|k| {
                        let (tilt, z) = (0.7 * k as f32, 0.01 * k as f32);
                        Normal::new(tilt.cos(), tilt.sin(), z).expect("visible")
                    })
                    .collect();
                let axis = |axis: usize| -> Vec<f32> {
                    normals.iter().map(|normal| normal.components()[axis]).collect()
                };
                let (x, y, z) = (axis(0), axis(1), axis(2));
                let slices = Normals::new(&x, &y, &z).expect("one length");
                let mut shaded = vec![f32::NAN; count];
                scene.shade_slice(slices, &mut shaded).expect("one length");
                for (normal, shaded) in normals.iter().zip(shaded) {
                    assert_eq!(scene.shade(*normal), shaded, "{report:?}");
                }
            }
        }
    }
    terms.sort_unstable();
    println!("{terms:?}");
    assert!(terms[0] == 1 && terms.iter().any(|terms| (10..40).contains(terms)), "{terms:?}");
}

#[test]
fn ambient_light_on_a_matte_is_a_constant() {
    let d = coefficients(&[3.5], &MATTE);
    let mut lengths = [0; 16];
    let (_, report) = truncated(&d, Tolerance::OfPeak(1e-3), &mut lengths);
    assert_eq!((report.azimuths, report.terms), (1, 1), "{report:?}");
}

#[test]
fn shares_of_white_and_of_the_peak_are_irradiances() {
    let d = coefficients(&[3.5, 0.5, 1.0, 0.2], &MATTE);
    let (mut one, mut other) = ([0; 16], [0; 16]);
    let (_, of_peak) = truncated(&d, Tolerance::OfPeak(0.01), &mut one);
    let (_, irradiance) = truncated(&d, Tolerance::Irradiance(0.01 * of_peak.peak), &mut other);
    assert_eq!(irradiance, of_peak);
    // White is an irradiance of 1 / 4.
    let share = 0.04 * of_peak.peak;
    let (_, of_white) = truncated(&d, Tolerance::OfWhite { share, exposure: 4.0 }, &mut other);
    assert_eq!(of_white, of_peak);
}

#[test]
fn faults_are_named() {
    let d = coefficients(&[3.5], &MATTE);
    let within = |tolerance, lengths: &mut [u16]| {
        let done = sphere::BASIS.collapse_within(&d, tolerance, lengths, [0.0f32; sphere::SCENE]);
        done.map(|_| ())
    };
    for wrong in [0.0, -1.0, f32::NAN, f32::INFINITY] {
        let error = within(Tolerance::OfPeak(wrong), &mut [0; 16]);
        assert_eq!(error, Err(Error::Tolerance), "{wrong}");
        for (share, exposure) in [(wrong, 1.0), (0.1, wrong)] {
            let error = within(Tolerance::OfWhite { share, exposure }, &mut [0; 16]);
            assert_eq!(error, Err(Error::Tolerance), "{share} {exposure}");
        }
    }
    let short = within(Tolerance::OfPeak(0.1), &mut [0; 2]);
    assert!(matches!(short, Err(Error::Length { .. })), "{short:?}");
}

/// No light: nothing is left, and nothing is wrong.
#[test]
fn a_black_image_costs_nothing() {
    let mut lengths = [0; 16];
    let black = [0.0; sphere::COMPONENTS];
    let (scene, report) = truncated(&black, Tolerance::OfPeak(0.1), &mut lengths);
    assert_eq!((report.terms, report.azimuths, report.components), (0, 0, 0));
    assert_eq!(scene.shade(Normal::new(0.0, 0.6, 0.8).expect("visible")), 0.0);
}

/// Polynomials of up to 28 terms, which powers make from the orthogonal ones and back.
#[test]
fn bounds_hold_of_long_polynomials() {
    let lights = read_lights("tables/inputs/lights.csv", None).expect("the shipped lights");
    let materials = read_materials("tables/inputs/materials.csv", Some(7)).expect("materials");
    let mut scene = decode(include_bytes!("../tables/curet.bin")).expect("a table").scene;
    (scene.light.degree, scene.basis.components) = (12, Some(200));
    scene.basis.profile_tolerance = 1e-14;
    let table = build(&scene, &lights, &materials).expect("a table");
    let owned = OwnedBasis::new(&table).expect("a table for f32");
    let basis = owned.basis().expect("parts of a table");
    let lengths = basis.parts().lengths;
    assert!(lengths.iter().any(|&length| length > 26), "{lengths:?}");
    let light = lights.entries[3].luminance();
    let light = single(light[..169].to_vec());
    let light = Light::new(&light).expect("coefficients");
    let material = single(materials.entries[5].luminance());
    let material = Material::new(&material).expect("coefficients");
    let mut d = vec![0.0; basis.components()];
    let mut workspace = vec![0.0; basis.workspace_len()];
    basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
    let room = || vec![0.0; basis.scene_len()];
    let whole = basis.collapse_into(&d, room()).expect("sizes");
    let mut fewer = usize::MAX;
    for share in [1e-1, 1e-2, 1e-3, 1e-4, 1e-6] {
        let mut lengths = [0; 32];
        let within = basis.collapse_within(&d, Tolerance::OfPeak(share), &mut lengths, room());
        let (scene, report) = within.expect("sizes");
        let squares = fixtures::rule(40, 50).into_iter().map(|(at, weight)| {
            let normal = fixtures::normal(at);
            weight * f64::from(scene.shade(normal) - whole.shade(normal)).powi(2)
        });
        let error = squares.sum::<f64>().sqrt();
        println!(
            "{share}: {error:e} of {:e}, {} of {}",
            report.bound,
            report.terms,
            basis.scene_len()
        );
        assert!(error <= f64::from(report.bound) + BOUND_ROUNDING * f64::from(report.peak));
        assert!(report.bound <= 1.000_01 * share * report.peak);
        assert!(report.terms < basis.scene_len());
        fewer = fewer.min(report.terms);
    }
    // A tenth of the peak takes few terms.
    assert!(fewer <= 16, "{fewer}");
}

/// The error of the table is estimated by the last fifth of the coefficients.
#[test]
fn the_floor_is_the_last_fifth() {
    let d: Vec<f32> = (0..sphere::COMPONENTS).map(|k| 1.0 / (1.0 + k as f32)).collect();
    let last = d.len() - d.len().div_ceil(5);
    let expected = d[last..].iter().map(|d| d * d).sum::<f32>().sqrt();
    let (_, report) = truncated(&d, Tolerance::OfPeak(1e-2), &mut [0; 16]);
    assert!((report.floor / expected - 1.0).abs() <= 1e-6, "{} {expected}", report.floor);
}
