//! Highlights in integers: against the formula in f64, at the limits of their numbers, and their bits.

use crate::highlights::{ANGLES, BLUR, Blob, Glossy, Vector, at, blobs, normals_for};
use eigenshade::mathematics::SinglePrecision;
use eigenshade::quantized::{Highlights, Lobe, Normal};
use eigenshade::{Argument, Error, Gloss, Q15, Q31, Rgb, Rotation, Source, quantized};

/// The normal in 15 bits, and the same in f64.
fn rounded(normal: Vector) -> (Normal<Q15>, Vector) {
    let [x, y, z] = normal.map(|number| (number * 32_768.0).round().clamp(-32_767.0, 32_767.0));
    let of = |number: f64| Q15(number as i16);
    let exact = [x, y, z].map(|number| number / 32_768.0);
    (Normal::<Q15>::new(of(x), of(y), of(z)).expect("a visible normal"), exact)
}

fn in_floats<const N: usize>(
    material: &Glossy,
    sources: &[Source<f32>; N],
) -> eigenshade::Highlights<f32, N> {
    eigenshade::Highlights::new::<SinglePrecision>(&material.gloss(), sources).expect("room")
}

/// An exponent for which the irradiance `peak` has 17 bits, as the largest one of a scene.
fn exponent(peak: f64) -> i32 {
    peak.log2().ceil() as i32 - 17
}

#[test]
fn highlights_are_those_of_the_formula() {
    for roughness in [0.1, 0.2, 0.3, 0.5, 1.0] {
        for (f0, albedo) in [(0.9, 0.0), (0.04, 0.5)] {
            let material = Glossy { roughness, f0, albedo };
            let mut most = 0.0_f64;
            for degrees in ANGLES {
                let mut of_angle = 0.0_f64;
                for blob in blobs(&[degrees]) {
                    let floats = in_floats(&material, &[blob.single([1.0; 3])]);
                    let normals = normals_for(&blob, material.alpha().hypot(0.5 * blob.major));
                    let normals: Vec<_> = normals.into_iter().map(rounded).collect();
                    let expected: Vec<_> = normals
                        .iter()
                        .map(|(_, normal)| material.lobe(&blob, BLUR, *normal))
                        .collect();
                    let peak = expected.iter().copied().fold(0.0, f64::max);
                    let exponent = exponent(peak);
                    let highlights = Highlights::<i32, 1>::quantize(&floats, exponent).expect("room");
                    for ((normal, _), expected) in normals.iter().zip(expected) {
                        let found = f64::from(highlights.shade(*normal)) * f64::from(exponent).exp2();
                        let error = (found - expected).abs() / peak;
                        if error > 0.02 { println!("{blob:?} {normal:?} {found} {expected} {highlights:?}"); }
                        of_angle = of_angle.max(error);
                    }
                }
                println!("{roughness} {f0} {degrees}: {of_angle:.5}");
                most = most.max(of_angle);
            }
            println!("roughness {roughness}, {f0}, of the peak: {most:e}");
        }
    }
}
