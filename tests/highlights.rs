//! Small sources shaded by the microfacet formula: against the formula in slopes, and against the
//! exact BRDF integrated over the blob that defines a source.

use crate::blobs::{ANGLES, Blob, Glossy, Vector, around, at, blobs, disc, dot, normals_for};
use eigenshade::{Argument, Error, Gloss, Highlights, Normals, Rgb, Rotation, Source};
use eigenshade_model::highlights::Highlights as OfHost;
use eigenshade_testing::fixtures::{axes, normal};
use eigenshade_testing::{largest, relative_error};
use std::f64::consts::PI;

/// The host's against the formula in slopes, of the lobe's peak: slopes of up to a hundred.
const LOBE_F64: f64 = 2e-12;

/// In f32, of the lobe's peak, by roughness. A lobe of α moves by its width where a normal turns by
/// α: rounding a normal and a direction to 24 bits, and forms of numbers to 1/α, leave some ε/α.
/// All lobes have the root's 7e-7.
const LOBE_F32: [(f64, f64); 6] =
    [(0.065, 3e-5), (0.1, 1e-5), (0.2, 5e-6), (0.3, 3e-6), (0.5, 2e-6), (1.0, 1.5e-6)];

fn of_host(material: &Glossy, blob: &Blob, energy: [f64; 3]) -> OfHost {
    OfHost::new(&material.of_host(), &[blob.of_host(energy)])
}

fn of_one(material: &Glossy, source: Source) -> Highlights<1> {
    Highlights::new(&material.gloss(), &[source]).expect("room for one")
}

#[test]
fn lobes_are_those_of_the_formula_in_slopes() {
    let mut most = 0.0_f64;
    for blob in blobs(&ANGLES) {
        for roughness in [0.065, 0.1, 0.3, 0.6, 1.0] {
            let material = Glossy { roughness, f0: 0.3, albedo: 0.5 };
            let highlights = of_host(&material, &blob, [1.0, 0.5, 0.0]);
            let normals = normals_for(&blob, material.alpha().hypot(0.5 * blob.spread));
            let expected: Vec<_> =
                normals.iter().map(|&normal| material.lobe(&blob, normal)).collect();
            let peak = largest(expected.iter().copied());
            for (&at, expected) in normals.iter().zip(expected) {
                let [r, g, b] = highlights.irradiance(at);
                most = most.max((r - expected).abs() / peak);
                assert!((g - 0.5 * r).abs() <= 1e-15 * r && b == 0.0, "{blob:?}");
            }
        }
    }
    println!("of the peak: {most:e}");
    assert!(most <= LOBE_F64, "{most:e}");
}

#[test]
fn single_precision() {
    for (roughness, tolerance) in LOBE_F32 {
        let material = Glossy { roughness, f0: 0.3, albedo: 0.5 };
        let mut most = 0.0_f64;
        for blob in blobs(&ANGLES) {
            let double = of_host(&material, &blob, [1.0; 3]);
            let single = of_one(&material, blob.source([1.0; 3]));
            let normals = normals_for(&blob, material.alpha().hypot(0.5 * blob.spread));
            let exact: Vec<_> = normals.iter().map(|&at| double.irradiance(at)[0]).collect();
            let found = normals.iter().map(|&at| f64::from(single.shade(normal(at)).r));
            most = most.max(relative_error(&found.collect::<Vec<_>>(), &exact));
        }
        println!("roughness {roughness}, of the peak: {most:e}");
        assert!(most <= tolerance, "{roughness}: {most:e}");
    }
}

/// Errors of the lobe against the exact BRDF over the blob, by spread in radians: of the peak's
/// height, rms over the disc and of the worst pixel, as fractions of the exact peak. Sources to 110
/// degrees from the view, roughness 0.2 to 0.6; and to 140 degrees.
const LOBE_ERRORS: [(f64, [f64; 3], [f64; 3]); 5] = [
    (0.01, [0.025, 0.0005, 0.025], [0.04, 0.0006, 0.04]),
    (0.02, [0.05, 0.0014, 0.05], [0.06, 0.002, 0.07]),
    (0.05, [0.065, 0.005, 0.11], [0.065, 0.006, 0.13]),
    (0.1, [0.075, 0.011, 0.16], [0.075, 0.012, 0.185]),
    (0.2, [0.065, 0.025, 0.205], [0.065, 0.03, 0.255]),
];

/// The error of the peak's height, the rms error and that of the worst pixel, of the exact peak.
fn lobe_errors(material: &Glossy, blob: &Blob) -> [f64; 3] {
    let alpha = material.alpha();
    let nodes = blob.nodes((0.8 * alpha).min(0.8 * blob.spread));
    let exact = |normal: Vector| -> f64 {
        nodes.iter().map(|&(light, weight)| weight * material.reflected(light, normal)).sum()
    };
    // Enough for the narrowest lobe.
    let all = disc(if blob.spread < 0.02 { 80 } else { 48 });
    let near = around(blob, 0.25 * alpha.hypot(0.5 * blob.spread), 6);
    let normals = || all.iter().chain(&near).copied();
    let expected: Vec<f64> = normals().map(exact).collect();
    let found: Vec<f64> = normals().map(|normal| material.lobe(blob, normal)).collect();
    let [peak, of_lobe] = [&expected, &found].map(|values| largest(values.iter().copied()));
    let off = || found.iter().zip(&expected).map(|(f, e)| f - e);
    // Only the disc's normals are evenly spaced.
    let squares: f64 = off().take(all.len()).map(|error| error * error).sum();
    [of_lobe / peak - 1.0, (squares / all.len() as f64).sqrt() / peak, largest(off()) / peak]
}

#[test]
fn lobes_are_near_the_exact_brdf_over_the_blob() {
    for (spread, near, far) in LOBE_ERRORS {
        for (degrees, bounds) in [(5.0_f64, near), (60.0, near), (110.0, near), (140.0, far)] {
            let mut worst = [0.0_f64; 3];
            for roughness in [0.2, 0.3, 0.4, 0.6] {
                let material = Glossy { roughness, f0: 0.9, albedo: 0.0 };
                let direction = at(degrees.to_radians(), 0.4);
                let blob = Blob { direction, spread };
                let errors = lobe_errors(&material, &blob);
                worst = [0, 1, 2].map(|k| worst[k].max(errors[k].abs()));
            }
            println!("{spread} rad, {degrees} degrees: {worst:?}");
            let is_within = worst.iter().zip(bounds).all(|(error, bound)| *error <= bound);
            assert!(is_within, "{spread} {degrees}: {worst:?}");
        }
    }
}

/// The same on a dielectric: of the peak, and rms.
const DIELECTRIC: [f64; 2] = [0.06, 0.0095];

#[test]
fn lobes_of_a_dielectric() {
    let material = Glossy { roughness: 0.3, f0: 0.04, albedo: 0.5 };
    let mut worst = [0.0_f64; 2];
    for (degrees, spread) in [(30.0_f64, 0.02), (30.0, 0.1), (80.0, 0.05)] {
        let blob = Blob { direction: at(degrees.to_radians(), 2.0), spread };
        let errors = lobe_errors(&material, &blob);
        println!("{blob:?}: {errors:?}");
        worst = [0, 1].map(|k| worst[k].max(errors[k].abs()));
    }
    assert!(worst[0] <= DIELECTRIC[0] && worst[1] <= DIELECTRIC[1], "{worst:?}");
}

/// Many normals at once, in whole blocks and not, give the bits of one by one, and are added.
#[test]
fn slices_are_the_sums_of_single_normals() {
    let material = Glossy { roughness: 0.3, f0: 0.5, albedo: 0.2 };
    let gloss: Gloss = material.gloss();
    let sources: Vec<_> =
        blobs(&[10.0, 120.0]).iter().map(|blob| blob.source([1.0, 2.0, 0.5])).collect();
    let normals: Vec<_> = disc(24).into_iter().map(normal).collect();
    for count in [0, 1, 4, 10] {
        let highlights = Highlights::<10>::new(&gloss, &sources[..count]);
        let highlights = highlights.expect("room for ten");
        assert_eq!((highlights.len(), highlights.is_empty()), (count, count == 0));
        for length in [0, 1, 63, 64, 65, 300] {
            let [x, y, z] = axes(&normals[..normals.len().min(length)]);
            let list = Normals::new(&x, &y, &z).expect("one length");
            let before = Rgb::new(0.25, 0.5, 1.0);
            let mut irradiance = vec![before; length];
            highlights.add_slice(list, &mut irradiance).expect("one length");
            for (found, normal) in irradiance.iter().zip(list.iter()) {
                let Rgb { r, g, b } = highlights.shade(normal);
                assert_eq!(*found, Rgb::new(before.r + r, before.g + g, before.b + b));
            }
        }
        let none = Normals::new(&[], &[], &[]).expect("one length");
        let refused = highlights.add_slice(none, &mut [Rgb::gray(0.0)]);
        let expected = Error::Length { argument: Argument::Normals, expected: 0, found: 1 };
        assert_eq!(refused, Err(expected));
    }
    let refused = Highlights::<4>::new(&gloss, &sources[..5]);
    let expected = Error::Capacity { argument: Argument::Sources, needed: 5, capacity: 4 };
    assert_eq!(refused.map(|_| ()), Err(expected));
}

/// Sources at the rim, behind, at the pole and below; two that coincide; none and a million times
/// the energy: finite, not negative, and where a half-way direction exists, the formula's.
#[test]
fn hard_cases() {
    let degrees = [0.0, 1e-5, 89.99, 90.0, 90.01, 175.0, 177.0, 179.9, 180.0];
    for (roughness, tolerance) in [(0.065, 5e-5), (0.1, 5e-5), (1.0, 4e-6)] {
        let material = Glossy { roughness, f0: 0.5, albedo: 0.5 };
        let gloss: Gloss = material.gloss();
        // D <= 1.35 / π α², as a lobe is at most √1.16 wide, V n·s <= 1 / 2 α, F <= 1.
        let alpha = material.alpha();
        let most = 0.5 * 1.35 / (PI * alpha.powi(3)) + 1.0 / PI;
        let new = |sources: &[Source]| Highlights::<2>::new(&gloss, sources).expect("room for two");
        for blob in blobs(&degrees) {
            let source = blob.source([1.0; 3]);
            let [dark, bright] = [0.0, 1e6].map(|energy| new(&[blob.source([energy; 3])]));
            let (one, two) = (new(&[source]), new(&[source; 2]));
            let normals = normals_for(&blob, alpha);
            let expected: Vec<_> =
                normals.iter().map(|&normal| material.lobe(&blob, normal)).collect();
            let peak = largest(expected.iter().copied());
            let has_half_way = blob.direction[2] > -0.997;
            for (&at, expected) in normals.iter().zip(expected) {
                let [single, double, none, million] =
                    [&one, &two, &dark, &bright].map(|highlights| highlights.shade(normal(at)).g);
                assert!(single.is_finite() && single >= 0.0, "{blob:?} {at:?}: {single}");
                assert!((double - 2.0 * single).abs() <= 1e-6 * double, "{double}");
                assert!((million - 1e6 * single).abs() <= 2e-6 * million, "{million}");
                assert_eq!(none, 0.0);
                let found = f64::from(single);
                if has_half_way {
                    let off = (found - expected).abs();
                    assert!(off <= tolerance * peak, "{blob:?} {at:?}: {found} {expected}");
                } else {
                    assert!(found <= most, "{blob:?} {at:?}: {found}");
                }
            }
        }
    }
}

/// A light that turns: each source sets behind the rim and rises again, and the picture has no
/// sources that are not there.
#[test]
fn sources_set_and_rise() {
    let material = Glossy { roughness: 0.3, f0: 0.5, albedo: 0.5 };
    let source = Source::new([0.0, 0.0, 1.0], [1.0; 3], 0.02).expect("a source");
    for step in 0..=72 {
        let angle = step as f32 * 5.0_f32.to_radians();
        let rotation = Rotation::from_euler(0.3, angle, 0.0).expect("angles");
        let turned = source.turned(rotation);
        let highlights = of_one(&material, turned);
        let lit = highlights.shade(normal([0.0, 0.0, 1.0])).g;
        assert_eq!(lit > 0.0, turned.direction()[2] > 0.0, "{step}");
        for at in disc(32) {
            let irradiance = highlights.shade(normal(at)).g;
            let cosine = dot(turned.direction().map(f64::from), at);
            assert!(irradiance.is_finite() && irradiance >= 0.0);
            assert!(cosine > -1e-6 || irradiance == 0.0, "{step} {at:?}");
        }
    }
}
