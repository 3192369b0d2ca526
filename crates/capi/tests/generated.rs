//! The runtime's feature `generate`: with `EIGENSHADE_SCENE` naming tests/scenes/generate.toml, and
//! without. Among the runtime's tests, each table would compile their other crates again.
#![cfg(feature = "own-table")]

#[path = "../../testing/src/oracle.rs"]
#[expect(dead_code, reason = "other tests use the rest")]
mod oracle;

#[path = "../../testing/src/tolerances.rs"]
#[expect(dead_code, reason = "other tests use the rest")]
mod tolerances;

use eigenshade::{Light, Material, Normal, generated, sphere};

/// Statics in f32 of a table that another host made, of the largest of their kind: 2^-23,
/// a rounding the other way.
const STATICS: f32 = 1.2e-7;

const SCENE: Option<&str> = option_env!("EIGENSHADE_SCENE");

/// Numbers that are all of one size, by the largest.
fn assert_near(what: &str, found: &[f32], expected: &[f32]) {
    assert_eq!(found.len(), expected.len(), "{what}");
    let largest = expected.iter().fold(0.0f32, |most, number| most.max(number.abs()));
    for (found, expected) in found.iter().zip(expected) {
        let apart = (found - expected).abs();
        assert!(apart <= STATICS * largest, "{what}: {found}, {expected}");
    }
}

/// Made anew, the shipped table is the shipped table.
#[test]
fn the_shipped_scene_gives_the_shipped_statics() {
    if SCENE.is_some() {
        return;
    }
    let (found, expected) = (*generated::BASIS.parts(), *sphere::BASIS.parts());
    assert_near("polar", found.polar, expected.polar);
    assert_near("factors", found.factors, expected.factors);
    assert_near("terms", found.terms, expected.terms);
    let without = |parts| eigenshade::wire::Parts { polar: &[], factors: &[], terms: &[], ..parts };
    assert_eq!(format!("{:?}", without(found)), format!("{:?}", without(expected)));
    let (found, expected) = (generated::q15::BASIS.parts(), sphere::q15::BASIS.parts());
    assert_eq!(found.profiles.len(), expected.profiles.len());
    for (found, expected) in found.factors.iter().zip(expected.factors) {
        assert!(found.0.abs_diff(expected.0) <= 1, "{found:?}, {expected:?}");
    }
}

/// All components of a small scene are its images, by direct quadrature.
#[test]
fn a_scene_of_ones_own_is_its_images() {
    let Some(scene) = SCENE else { return };
    assert!(scene.ends_with("tests/scenes/generate.toml"), "made for another scene: {scene}");
    assert_eq!((generated::DEGREE, generated::ORDER), (3, 2));
    assert_eq!((generated::q15::DEGREE, generated::q15::ORDER), (3, 2));
    let mut numbers = oracle::Numbers(5);
    let coefficients: Vec<f64> =
        (0..eigenshade_table::light::count(3)).map(|_| numbers.next()).collect();
    let indices: Vec<_> = eigenshade_table::material::indices(2).collect();
    let brdf: Vec<_> = indices.iter().map(|&(o, p, q)| (o, p, q, numbers.next())).collect();
    let rounded = |values: &[f64]| values.iter().map(|&value| value as f32).collect::<Vec<_>>();
    let light = rounded(&coefficients);
    let material = rounded(&brdf.iter().map(|&(.., b)| b).collect::<Vec<_>>());
    let light = Light::new(&light).expect("sixteen coefficients");
    let material = Material::new(&material).expect("five coefficients");
    let d = generated::project(&light, &material).expect("it fits");
    let image = generated::collapse(&d);
    let reference = oracle::ExplicitLight::new(&coefficients);
    let normals: Vec<_> = (0..50).map(|_| numbers.normal()).collect();
    let pairs: Vec<_> = normals
        .iter()
        .map(|&normal| {
            let [x, y, z] = normal.map(|component| component as f32);
            let found = image.shade(Normal::new(x, y, z).expect("a normal"));
            (f64::from(found), oracle::irradiance(&reference, &brdf, normal))
        })
        .collect();
    let peak = pairs.iter().fold(0.0f64, |most, (_, expected)| most.max(expected.abs()));
    for (found, expected) in pairs {
        let apart = (found - expected).abs() / peak;
        assert!(apart <= tolerances::POLYNOMIAL_F32, "{found}, {expected}");
    }
}
