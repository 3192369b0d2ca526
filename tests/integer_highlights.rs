//! Highlights in integers: against the formula in f64, at the limits of their numbers, and their
//! bits.

use crate::blobs::{ANGLES, Blob, Glossy, Vector, at, blobs, dot, normals_for};
use eigenshade::q15::{Highlights, Lobe, Normal};
use eigenshade::{Argument, Error, Q15, Rgb, Source};
use eigenshade_testing::largest;

/// In Q15, of the lobe's peak, by roughness. A normal, a direction and a form of 16 bits turn a
/// lobe by some 2^-16, of its width α; the squares of a narrow lobe's form have as few as 9 bits.
/// Roots, reciprocals and cosines leave 1e-3, and more where a source behind the object, at 175
/// degrees from the view, lights a rim at cosines of some hundred units.
const LOBE_Q15: [(f64, f64); 6] =
    [(0.065, 2e-2), (0.1, 1e-2), (0.2, 3e-3), (0.3, 4e-3), (0.5, 4e-3), (1.0, 4e-3)];

/// Where a normal's z and its cosine to the source are both smaller, the formula itself jumps: at
/// z = 0 from 0, for a source below the horizon, to that of grazing light.
const CORNER: [f64; 2] = [1.0 / 128.0, 1.0 / 1024.0];

/// A tail of the lobe, of itself, by roughness: twice the relative error of the form, near 2^-9 of a
/// wide lobe, and a unit of some hundred.
const TAIL: [(f64, f64); 3] = [(0.065, 2.5e-2), (0.1, 1e-2), (0.3, 3e-3)];

/// The normal in 15 bits, and the same in f64.
fn rounded(normal: Vector) -> (Normal, Vector) {
    let whole = normal.map(|number| (number * 32_768.0).round().clamp(-32_767.0, 32_767.0));
    let [x, y, z] = whole.map(|number| Q15(number as i16));
    let normal = Normal::from_unit(x, y, z).expect("a visible normal");
    (normal, whole.map(|number| number / 32_768.0))
}

fn in_floats<const N: usize>(
    material: &Glossy,
    sources: &[Source; N],
) -> eigenshade::Highlights<N> {
    eigenshade::Highlights::new(&material.gloss(), sources).expect("room")
}

fn gray(material: &Glossy, source: Source, exponent: i32) -> Highlights<i32, 1> {
    Highlights::quantize(&in_floats(material, &[source]), exponent).expect("room")
}

/// An exponent for which the irradiance `peak` has 17 bits, as the largest one of a scene.
fn exponent_of(peak: f64) -> i32 {
    peak.log2().ceil() as i32 - 17
}

/// Normals for a blob in 15 bits, and the formula in f64 there, for energy 1.
fn expected(material: &Glossy, blob: &Blob) -> Vec<(Normal, Vector, f64)> {
    let normals = normals_for(blob, material.alpha().hypot(0.5 * blob.spread)).into_iter();
    let pairs = normals.map(rounded);
    pairs.map(|(normal, exact)| (normal, exact, material.lobe(blob, exact))).collect()
}

fn peak_of(expected: &[(Normal, Vector, f64)]) -> f64 {
    largest(expected.iter().map(|(_, _, irradiance)| *irradiance))
}

const METAL: [f64; 2] = [0.9, 0.0];
const PLASTIC: [f64; 2] = [0.04, 0.5];

#[test]
fn highlights_are_those_of_the_formula() {
    for (roughness, tolerance) in LOBE_Q15 {
        let (mut most, mut corners) = (0.0_f64, 0);
        for [f0, albedo] in [METAL, PLASTIC] {
            let material = Glossy { roughness, f0, albedo };
            for blob in blobs(&ANGLES) {
                let expected = expected(&material, &blob);
                let peak = peak_of(&expected);
                let exponent = exponent_of(peak);
                let highlights = gray(&material, blob.source([1.0; 3]), exponent);
                for (normal, exact, irradiance) in expected {
                    let found = f64::from(highlights.shade(normal)) * f64::from(exponent).exp2();
                    let cosine = dot(blob.direction, exact);
                    if exact[2] < CORNER[0] && cosine.abs() < CORNER[1] {
                        assert!((0.0..=peak * (1.0 + tolerance)).contains(&found), "{blob:?}");
                        corners += 1;
                    } else {
                        most = most.max((found - irradiance).abs() / peak);
                    }
                }
            }
        }
        println!("roughness {roughness}, of the peak: {most:e}; {corners} in the corner");
        assert!(most <= tolerance, "{roughness}: {most:e}");
    }
}

/// Far from its middle a lobe is 1e-8 of its peak, which a bright source shows: no cut-off, and no
/// overflow of the peak.
#[test]
fn tails_of_bright_sources() {
    for (roughness, tolerance) in TAIL {
        let material = Glossy { roughness, f0: 0.9, albedo: 0.0 };
        let (mut most, mut saturated) = (0.0_f64, 0);
        for blob in blobs(&[5.0, 40.0, 110.0]) {
            let expected = expected(&material, &blob);
            let exponent = exponent_of(1e-3 * peak_of(&expected)) - 6;
            let highlights = gray(&material, blob.source([1e6; 3]), exponent + 20);
            for (normal, exact, irradiance) in expected {
                let found = highlights.shade(normal);
                let units = 1e6 * irradiance * f64::from(-exponent - 20).exp2();
                let cosine = dot(blob.direction, exact);
                if units > 1.02 * 2.0_f64.powi(31) {
                    assert_eq!(found, i32::MAX);
                    saturated += 1;
                } else if units > 500.0 && units < 1.5e9 && cosine > 0.02 && exact[2] > 0.02 {
                    most = most.max((f64::from(found) / units - 1.0).abs());
                }
            }
        }
        println!("roughness {roughness}, of itself: {most:e}; {saturated} saturated");
        assert!(saturated > 0);
        assert!(most <= tolerance, "{roughness}: {most:e}");
    }
}

/// Scenes of any exponent: the same bits where both have their powers of two, saturated where they
/// do not fit, 0 where they are too small.
#[test]
fn energies_and_exponents_of_any_size() {
    let material = Glossy { roughness: 0.3, f0: 0.04, albedo: 0.5 };
    let normal = rounded([0.1, 0.2, 0.95_f64.sqrt()]).0;
    for blob in blobs(&[0.0, 40.0]) {
        let of_energy = |power: i32, exponent: i32| {
            let energy = f64::from(power).exp2();
            gray(&material, blob.source([energy; 3]), exponent).shade(normal)
        };
        let usual = of_energy(0, -16);
        assert!(usual > 1000, "{usual}");
        for power in [-60, -20, 1, 20, 60, 100] {
            assert_eq!(of_energy(power, power - 16), usual);
        }
        assert_eq!(of_energy(20, -26), i32::MAX);
        for power in [0, 100, 127] {
            assert_eq!(of_energy(power, -65_536), i32::MAX);
            assert_eq!(of_energy(power, 65_536), 0);
        }
        assert_eq!(of_energy(-60, -16), 0);
        let dark = blob.source([0.0; 3]);
        for exponent in [-65_536, -200, -16, 0, 65_536] {
            assert_eq!(gray(&material, dark, exponent).shade(normal), 0);
            let aligned = gray(&material, blob.source([1.0; 3]), -16).aligned(exponent);
            assert_eq!(aligned, gray(&material, blob.source([1.0; 3]), exponent));
        }
        // A sum saturates at either end, and a scene may be negative.
        let bright = gray(&material, blob.source([1.0; 3]), -31 + 4);
        let found = bright.shade(normal);
        assert_eq!(bright.add(i32::MAX - 5, normal), i32::MAX);
        assert_eq!(bright.add(i32::MIN, normal), i32::MIN + found);
        assert_eq!(bright.add(-found, normal), 0);
    }
}

type Channel = fn(Rgb<f32>) -> f32;

/// Sources add up, two in one place too, and each channel is that of one channel.
#[test]
fn sources_and_channels_add_up() {
    let material = Glossy { roughness: 0.4, f0: 0.3, albedo: 0.4 };
    let sources = blobs(&[30.0, 100.0]).into_iter().map(|blob| blob.source([0.3, 1.0, 70.0]));
    let sources: Vec<_> = sources.collect();
    let normals: Vec<_> =
        expected(&material, &blobs(&[30.0])[1]).into_iter().map(|(normal, ..)| normal).collect();
    let [a, b] = [&sources[1], &sources[7]];
    let exponents = Rgb::new(-16, -14, -9);
    let color: Highlights<Rgb<i32>, 4> =
        Highlights::quantize(&in_floats(&material, &[*a, *b, *a]), exponents).expect("room");
    assert_eq!((color.lobes().len(), color.exponent()), (3, exponents));
    let stored = Highlights::stored(color.exponent(), color.alpha_square(), color.lobes());
    assert_eq!(stored.as_ref(), Ok(&color));
    let one = |source: &Source, channel: Channel, exponent| {
        let energy = [channel(source.energy()); 3];
        let gray_source = Source::new(source.direction(), energy, source.spread());
        gray(&material, gray_source.expect("it was one before"), exponent)
    };
    let channels: [(Channel, i32); 3] = [(|rgb| rgb.r, -16), (|rgb| rgb.g, -14), (|rgb| rgb.b, -9)];
    let alone = channels.map(|(channel, exponent)| [a, b].map(|of| one(of, channel, exponent)));
    let mut slice = vec![Rgb::new(5, -6, 7); normals.len()];
    color.add_slice(&normals, &mut slice).expect("as many");
    for (normal, added) in normals.iter().zip(slice) {
        let found: [i32; 3] = color.shade(*normal).into();
        for (found, [a, b]) in found.iter().zip(&alone) {
            assert_eq!(*found, 2 * a.shade(*normal) + b.shade(*normal));
        }
        let [r, g, b] = found;
        assert_eq!(added, Rgb::new(r + 5, g - 6, b + 7));
        assert_eq!(color.add(Rgb::new(5, -6, 7), *normal), added);
    }
    let refused = color.add_slice(&normals, &mut []);
    let (expected, found) = (normals.len(), 0);
    assert_eq!(refused, Err(Error::Length { argument: Argument::Normals, expected, found }));
    let refused = Highlights::<i32, 2>::quantize(&in_floats(&material, &[*a, *b, *a]), 0);
    let full = Error::Capacity { argument: Argument::Sources, needed: 3, capacity: 2 };
    assert_eq!(refused, Err(full));
}

/// A source that sets: no normal is lit by one behind the object, and only those that face it
/// before.
#[test]
fn sources_set() {
    for roughness in [0.065, 0.1, 1.0] {
        let material = Glossy { roughness, f0: 0.9, albedo: 0.3 };
        for degrees in [90.0, 150.0, 175.0, 179.0, 179.99, 180.0] {
            let direction = at(f64::to_radians(degrees), 0.7);
            let blob = Blob { direction, spread: 0.03 };
            let highlights = gray(&material, blob.source([1e6; 3]), -10);
            for (normal, exact, _) in expected(&material, &blob) {
                let (found, cosine) = (highlights.shade(normal), dot(blob.direction, exact));
                assert!(found >= 0);
                // The direction has 15 bits.
                assert!(found == 0 || cosine > -1e-4, "{degrees}: {cosine}, {found}");
            }
        }
        let behind = Source::new([0.0, 0.0, -1.0], [1e6; 3], 0.1);
        let highlights = gray(&material, behind.expect("a source"), -10);
        for (normal, ..) in expected(&material, &blobs(&[0.0])[0]) {
            assert_eq!(highlights.shade(normal), 0);
        }
    }
}

/// FNV-1a of the irradiances of two stored lobes, one of roughness 0.3 and one of 0.1, for normals
/// of the whole disc: the same bits on every machine.
const CHECKSUM: u32 = 3_997_470_640;

#[test]
fn bits_are_the_same_everywhere() {
    let lobe = |form, direction, specular_shift| Lobe {
        form,
        direction,
        specular: 9054,
        specular_shift,
        matte: 15_000,
        matte_shift: 17,
    };
    let lobes = [
        lobe([45_000, -120, -9_000, 45_511, -4_200, 4_300], [12_540, 5_000, 29_860], 25),
        lobe([50_900, 300, 14_000, 51_000, -20_000, 600], [-17_000, 20_000, 19_500], 36),
    ];
    let mut checksum = 0x811c_9dc5_u32;
    for (alpha_square, lobe) in [8_697_309, 107_374].into_iter().zip(lobes) {
        let highlights: Highlights<i32, 1> =
            Highlights::stored(-16, alpha_square, &[lobe]).expect("room");
        let mut lit = 0;
        for k in 0..64 * 64 {
            let [x, y] = [k % 64, k / 64].map(|place: i32| 1024 * place - 32_256);
            let square = (1 << 30) - x * x - y * y;
            let Ok(z) = u32::try_from(square) else { continue };
            let [x, y, z] = [x, y, z.isqrt().cast_signed()].map(|number| Q15(number as i16));
            let normal = Normal::from_unit(x, y, z).expect("a visible normal");
            let found = highlights.shade(normal);
            lit += i32::from(found > 100);
            for byte in found.to_le_bytes() {
                checksum = (checksum ^ u32::from(byte)).wrapping_mul(0x0100_0193);
            }
        }
        assert!(lit > 500, "{lit}");
    }
    assert_eq!(checksum, CHECKSUM);
}
