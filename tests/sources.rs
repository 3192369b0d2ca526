//! Small sources taken out of a light, against quadrature of the blob that defines a source; and
//! the gloss that reflects them.

use crate::blobs::{ANGLES, Blob, VIEW, at, blobs, dot};
use crate::oracle::{ExplicitLight, Numbers};
use eigenshade::{Argument, Buffer, Error, Gloss, Light, Rgb, Rotation, Source};
use eigenshade_model::highlights::harmonics;
use eigenshade_model::source::Source as SourceOfHost;
use std::f64::consts::PI;

/// Coefficients of a blob of energy 1, whose harmonics are at most 1.41: sums of this spacing leave
/// 1e-8, and the kernel of the widest blob is cut at 3 rad.
const BLOB: f64 = 1e-7;

#[test]
fn blobs_have_the_harmonics_of_their_definition() {
    let explicit: Vec<_> = (0..169)
        .map(|k| {
            let mut alone = [0.0; 169];
            alone[k] = 1.0;
            ExplicitLight::new(&alone)
        })
        .collect();
    let directions =
        [VIEW, [0.0, 0.0, -1.0], at(1e-6, 2.0), at(0.7, 0.4), at(PI / 2.0, 2.5), at(2.5, -1.0)];
    let mut most = 0.0_f64;
    for direction in directions {
        for spread in [0.0, 0.05, 0.2, 0.4, 0.5] {
            let blob = Blob { direction, spread };
            let found = harmonics(&blob.of_host([1.0, 0.0, 0.0]), 12);
            let nodes = blob.nodes(0.5 * spread);
            for (found, explicit) in found.iter().zip(&explicit) {
                let expected: f64 =
                    nodes.iter().map(|&(at, weight)| weight * explicit.radiance(at)).sum();
                most = most.max((found - expected).abs());
            }
        }
    }
    println!("of energy 1: {most:e}");
    assert!(most <= BLOB, "{most:e}");
}

/// Degree 9 in f32: the direction rounded by 6e-8, times a slope of up to 13, and nine steps of a
/// recurrence with factors of up to 2.
const BLOB_F32: f64 = 4e-6;

#[test]
fn blobs_in_single_precision() {
    let mut most = 0.0_f64;
    for blob in blobs(&ANGLES) {
        let exact = harmonics(&blob.of_host([1.0; 3]), 9);
        let found = blob.source([1.0; 3]).harmonics::<100>(9).expect("room");
        for (&found, exact) in found.iter().zip(&exact) {
            most = most.max((f64::from(found) - exact).abs());
        }
    }
    println!("of energy 1: {most:e}");
    assert!(most <= BLOB_F32, "{most:e}");
}

/// A light less four sources, against the host's: energies of up to 37 times `BLOB_F32`.
const RESIDUAL: f64 = 37.0 * BLOB_F32;

/// Coefficients of up to 40 turned in f32, by two ways.
const TURNED: f32 = 2e-4;

fn noise<const N: usize>(numbers: &mut Numbers) -> Rgb<[f32; N]> {
    Rgb::gray(()).map(|()| [(); N].map(|()| numbers.next() as f32))
}

const ENERGIES: [[f64; 3]; 4] =
    [[1.0, 0.5, 30.0], [2.0, 0.5, 30.0], [3.0, 0.5, 30.0], [4.0, 0.5, 30.0]];

/// Four of the sources, for both.
fn chosen() -> [(Blob, [f64; 3]); 4] {
    let blobs = blobs(&[20.0, 100.0]);
    [(0, 0), (1, 1), (7, 2), (8, 3)].map(|(place, k)| (blobs[place], ENERGIES[k]))
}

fn sources() -> [Source; 4] {
    chosen().map(|(blob, energy)| blob.source(energy))
}

fn of_host() -> [SourceOfHost; 4] {
    chosen().map(|(blob, energy)| blob.of_host(energy))
}

fn lights<const N: usize>(residual: &Rgb<Buffer<f32, N>>) -> Rgb<Light<'_>> {
    residual.lights().expect("all degrees")
}

/// L = L' + Σ E Y, each channel with its own energy, and L' turns as the light and the sources do.
#[test]
fn residuals_lose_what_sources_take_and_turn_with_them() {
    let mut numbers = Numbers(3);
    let of_light = noise::<100>(&mut numbers);
    let light = of_light.each_ref().try_map(|channel| Light::new(channel)).expect("degree 9");
    let sources = sources();
    let residual = light.residual::<100>(&sources).expect("room");
    let mut most = 0.0_f64;
    for (channel, k) in [(&residual.r, 0), (&residual.g, 1), (&residual.b, 2)] {
        let of_light: [&[f32]; 3] = light.map(|light| light.coefficients()).into();
        let blobs = of_host().map(|source| (source.energy[k], harmonics(&source, 9)));
        for (place, &rest) in channel.iter().enumerate() {
            let sum: f64 = blobs.iter().map(|(energy, blob)| energy * blob[place]).sum();
            most = most.max((f64::from(rest) + sum - f64::from(of_light[k][place])).abs());
        }
    }
    println!("residual: {most:e}");
    assert!(most <= RESIDUAL, "{most:e}");

    let rotation = Rotation::from_euler(0.4, 2.0, -1.1).expect("a rotation");
    let turned = light.turned::<100>(&rotation).expect("room");
    let turned_sources = sources.map(|source| source.turned(rotation));
    let before = lights(&turned).residual::<100>(&turned_sources).expect("room");
    let after = lights(&residual).turned::<100>(&rotation).expect("room");
    for (before, after) in [(before.r, after.r), (before.g, after.g), (before.b, after.b)] {
        for (before, after) in before.iter().zip(&after) {
            assert!((before - after).abs() <= TURNED, "{before} {after}");
        }
    }
    // The same blob, seen from elsewhere.
    let back = turned_sources.map(|source| source.turned(rotation.inverse()));
    for (back, source) in back.iter().zip(&sources) {
        let [a, b] = [back, source].map(Source::direction);
        assert!(a.iter().zip(b).all(|(a, b)| (a - b).abs() <= 5e-7));
        assert_eq!((back.spread(), back.energy()), (source.spread(), source.energy()));
    }
}

/// The channels of a light may have degrees of their own.
#[test]
fn residuals_of_channels_of_several_degrees() {
    let (low, high) = ([1.0; 4], [1.0; 16]);
    let light = Rgb::new(&low[..], &high[..], &low[..1]);
    let light = light.try_map(Light::new).expect("all degrees");
    let source = Source::new([0.0, 0.6, 0.8], [1.0; 3], 0.1).expect("a source");
    let residual = light.residual::<16>(&[source]).expect("room");
    let blob = source.harmonics::<16>(3).expect("room");
    assert_eq!([residual.r.len(), residual.g.len(), residual.b.len()], [4, 16, 1]);
    for channel in [&residual.r, &residual.g, &residual.b] {
        assert!(channel.iter().zip(&blob).all(|(rest, blob)| (rest + blob - 1.0).abs() <= 2e-7));
    }
    let refused = light.residual::<9>(&[source]);
    let expected = Error::Capacity { argument: Argument::Light, needed: 16, capacity: 9 };
    assert_eq!(refused, Err(expected));
}

#[test]
fn sources_that_are_none_are_refused() {
    let (front, gray) = ([0.0, 0.0, 1.0], [1.0; 3]);
    assert!(Source::new(front, gray, 0.5).is_ok());
    assert!(Source::new(front, [0.0; 3], 0.0).is_ok());
    for (direction, energy, spread) in [
        (front, gray, 0.51),
        (front, gray, -0.1),
        (front, gray, f32::NAN),
        (front, [1.0, -1e-6, 1.0], 0.1),
        (front, [1.0, f32::NAN, 1.0], 0.1),
        (front, [1.0, f32::INFINITY, 1.0], 0.1),
        ([0.0; 3], gray, 0.1),
        ([0.0, 0.0, 1.01], gray, 0.1),
        ([f32::NAN, 0.0, 1.0], gray, 0.1),
    ] {
        let found = Source::new(direction, energy, spread);
        assert_eq!(found, Err(Error::Source), "{direction:?} {energy:?} {spread}");
    }

    // What is nearly right is made right.
    let source = Source::new([0.6, 0.0, 0.8004], gray, 0.05).expect("a source");
    let direction = source.direction().map(f64::from);
    assert!((dot(direction, direction) - 1.0).abs() < 6e-7);
}

#[test]
fn gloss_is_that_of_gltf() {
    let gloss = Gloss::metallic_roughness([0.5, 1.0, 0.0], 0.25, 0.6).expect("a material");
    assert!((gloss.alpha() - 0.36).abs() <= 1e-7);
    for (found, expected) in
        [(gloss.reflectance(), [0.155, 0.28, 0.03]), (gloss.albedo(), [0.375, 0.75, 0.0])]
    {
        let found: [f32; 3] = found.into();
        assert!(found.iter().zip(expected).all(|(f, e)| (f - e).abs() <= 1e-7), "{found:?}");
    }
    assert_eq!(
        Gloss::new(0.0_f32, [0.0; 3], [0.0; 3]).map(|gloss| gloss.alpha()),
        Ok(0.065 * 0.065)
    );
    let refused = |gloss: Result<Gloss, Error>, argument| {
        assert_eq!(gloss, Err(Error::Outside { argument }));
    };
    refused(Gloss::new(1.1, [0.0; 3], [0.0; 3]), Argument::Roughness);
    refused(Gloss::new(f32::NAN, [0.0; 3], [0.0; 3]), Argument::Roughness);
    refused(Gloss::new(0.5, [0.0, -0.1, 0.0], [0.0; 3]), Argument::Reflectance);
    refused(Gloss::new(0.5, [0.0; 3], [0.0, 0.0, 1.1]), Argument::Color);
    refused(Gloss::metallic_roughness([0.0, 1.1, 0.0], 0.5, 0.5), Argument::Color);
    refused(Gloss::metallic_roughness([0.0; 3], -0.5, 0.5), Argument::Metallic);
    refused(Gloss::metallic_roughness([0.0; 3], 0.5, 1.5), Argument::Roughness);
    for (color, metallic) in [(1.0_f32, 0.0), (1.0, 0.3), (1.0, 0.7), (1.0, 1.0), (0.0, 0.6)] {
        assert!(Gloss::metallic_roughness([color; 3], metallic, 0.5).is_ok(), "{color} {metallic}");
    }
}

/// Of f0 and of the matte base, what the coefficients of a glTF material are made of.
#[cfg(feature = "presets")]
#[test]
fn gloss_agrees_with_coefficients() {
    let color = [0.9, 0.4, 0.1];
    for metallic in [0.0, 0.3, 1.0] {
        let gloss = Gloss::metallic_roughness(color, metallic, 0.5).expect("a material");
        let shares = eigenshade::Material::metallic_roughness_shares(color, metallic);
        let shares = shares.expect("a material");
        let parts: [_; 3] = shares.zip(gloss.reflectance()).zip(gloss.albedo()).into();
        for (([matte, _, metal], f0), albedo) in parts {
            assert!((f0 - metal).abs() <= 1e-7 && (albedo * (1.0 - f0) - matte).abs() <= 1e-7);
        }
    }
}
