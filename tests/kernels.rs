//! The generated functions of known sizes against the general ones.
#![cfg(feature = "baked")]

use crate::tolerances;
use eigenshade::sphere::{self, BASIS};
use eigenshade::{Light, Material, Normal};
use eigenshade_testing::fixtures::{disc, normal};
use eigenshade_testing::oracle::Numbers;
use eigenshade_testing::relative_error;

/// Numbers of both signs between -1 and 1.
fn numbers(count: usize, seed: u64) -> Vec<f32> {
    let mut numbers = Numbers(seed);
    (0..count).map(|_| numbers.next() as f32).collect()
}

fn coefficients(seed: u64) -> sphere::Coefficients {
    sphere::Coefficients::from_slice(&numbers(sphere::COMPONENTS, seed)).expect("as many")
}

#[test]
fn collapsing_azimuth_by_azimuth() {
    for seed in 1..20 {
        let d = coefficients(seed);
        let expected = BASIS.collapse::<{ sphere::SCENE }>(&d).unwrap();
        let mut found = sphere::collapse(&coefficients(seed + 1));
        sphere::collapse_into(&d, &mut found);
        let normals: Vec<Normal> = disc(11).into_iter().map(normal).collect();
        let found: Vec<f64> = normals.iter().map(|&at| found.shade(at).into()).collect();
        let expected: Vec<f64> = normals.iter().map(|&at| expected.shade(at).into()).collect();
        let error = relative_error(&found, &expected);
        assert!(error <= f64::from(tolerances::SAME_SUM_F32), "{error:e}");
    }
}

/// Fewer coefficients, lights of a lower degree and materials of a lower order count as zero.
#[test]
fn what_is_missing_is_zero() {
    let short = sphere::Coefficients::from_slice(&numbers(7, 3)).expect("room");
    let expected = BASIS.collapse_into(&short, [0.0; sphere::SCENE]).unwrap();
    assert_eq!(*sphere::collapse(&short), expected);
    let (light, material) = (numbers(9, 1), numbers(40, 2));
    let transfer = sphere::transfer(&Material::new(&material).unwrap()).unwrap();
    let light = Light::new(&light).unwrap();
    let mut found = coefficients(1);
    sphere::relight_into(&transfer, &light, &mut found).unwrap();
    assert_eq!(found, BASIS.relight(&transfer, &light).unwrap());
    let matte = Material::new(&[2.0]).unwrap();
    let expected = BASIS.project::<{ sphere::WORKSPACE }, { sphere::COMPONENTS }>(&light, &matte);
    assert_eq!(sphere::project(&light, &matte), expected);
    let beyond = numbers(121, 1);
    let beyond = Light::new(&beyond).unwrap();
    assert!(sphere::relight_into(&transfer, &beyond, &mut found).is_err());
    let none = sphere::Coefficients::default();
    let mut scene = sphere::collapse(&none);
    sphere::collapse_into(&coefficients(5), &mut scene);
    assert_eq!(scene, sphere::collapse(&coefficients(5)));
}
