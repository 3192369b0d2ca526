//! Objects with textures against direct integration of their materials under whole maps, without
//! harmonics and without shadows.

use crate::shipped_map;
use eigenshade::Rgb;
use eigenshade::screen::Meter;
use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::Texels;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::object::surface::View;
use eigenshade_model::database::Lights;
use eigenshade_model::{highlights, shipped};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::Shader;
use eigenshade_shading::textured::{Texel, irradiance};
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType, Encoder};
use std::f64::consts::PI;

/// The rms difference of a picture, of white; roughness is at least 0.3. The largest found is 0.87 %.
const OF_WHITE: f64 = 0.01;

/// The rms difference of sums over a map of half the size each way, of white: four times that of
/// sums over the map.
const OF_SAMPLING: f64 = 0.002;

/// Pixels across.
const SIZE: usize = 14;

/// Sources of the lights.
const SOURCES: usize = 8;

fn png(of: impl Fn(f64, f64) -> [f64; 3]) -> Vec<u8> {
    let size = 64;
    let at = |k: usize| ((k % size) as f64 + 0.5, (k / size) as f64 + 0.5);
    let pixels = (0..size * size).map(at).map(|(u, v)| of(u / size as f64, v / size as f64));
    let bytes: Vec<u8> = pixels.flatten().map(|share| (255.0 * share).round() as u8).collect();
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size as u32, size as u32);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&bytes).expect("pixels");
    writer.finish().expect("an end");
    file
}

const COLOR: &str = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}}"#;

/// A sphere of checkers, a bumpy one, a dial, a shell with holes of light, and a colored scan.
pub fn objects() -> Vec<(&'static str, Glb)> {
    let checkers = |u: f64, v: f64| ((8.0 * u).floor() + (4.0 * v).floor()) % 2.0;
    let colors = png(|u, v| if checkers(u, v) > 0.0 { [0.9, 0.7, 0.4] } else { [0.2, 0.3, 0.7] });
    let numbers = png(|u, v| [0.0, 0.3 + 0.7 * v, checkers(u, v)]);
    let rings = |u: f64, v: f64| (20.0 * (u - 0.5).hypot(v - 0.5)).sin();
    let dial = png(|u, v| if rings(u, v) > 0.7 { [0.95, 0.9, 0.8] } else { [0.1, 0.1, 0.15] });
    let polished = png(|u, v| [0.0, if rings(u, v) > 0.7 { 0.4 } else { 0.7 }, 1.0]);
    let bumps = png(|u, v| {
        let [x, y] = [u, v].map(|c| 0.3 * (2.0 * PI * 6.0 * c).cos());
        let length = (1.0 + x * x + y * y).sqrt();
        [x, y, 1.0].map(|c| 0.5 + 0.5 * c / length)
    });
    let occlusion = png(|u, _| [0.4 + 0.6 * u; 3]);
    let sphere = Glb::sphere(24);
    let mut scan = Glb::sphere(24);
    scan.positions.iter_mut().for_each(|[x, y, _]| (*x, *y) = (0.8 * *x, 1.2 * *y));
    scan.normals.clear();
    scan.colors = scan
        .positions
        .iter()
        .map(|at| {
            let [r, g, b] = at.map(|c| 0.5 + 0.4 * c);
            [r, g.min(1.0), b, 1.0]
        })
        .collect();
    let square = Glb { node: r#","rotation":[-0.2588,0.15,0,0.9542]"#.to_owned(), ..Glb::square() };
    let bumpy = format!(r#"{COLOR},"normalTexture":{{"index":2}}"#);
    let shell = format!(r#"{COLOR},"occlusionTexture":{{"index":2}},"doubleSided":true"#);
    vec![
        (
            "sphere",
            Glb {
                material: COLOR.to_owned(),
                images: vec![colors.clone(), numbers.clone()],
                ..sphere.clone()
            },
        ),
        (
            "bumps",
            Glb {
                material: bumpy.clone(),
                images: vec![colors.clone(), numbers.clone(), bumps.clone()],
                ..sphere.clone()
            },
        ),
        ("dial", Glb { material: bumpy, images: vec![dial, polished, bumps], ..square }),
        (
            "shell",
            Glb {
                material: shell,
                images: vec![colors, numbers, occlusion],
                node: r#","rotation":[0.3,0,0,0.954]"#.to_owned(),
                indices: sphere.indices[..sphere.indices.len() / 2].to_vec(),
                ..sphere
            },
        ),
        (
            "scan",
            Glb {
                material: r#""pbrMetallicRoughness":{"metallicFactor":0.2,"roughnessFactor":0.45}"#
                    .to_owned(),
                ..scan
            },
        ),
    ]
}

/// The irradiance of a texel by every texel of a map.
fn reference(map: &EnvironmentMap, texel: &Texel) -> [f64; 3] {
    let square = f64::from(texel.roughness).powi(4);
    let view = texel.normal[2].max(1e-4);
    let root = |cosine: f64| (square + (1.0 - square) * cosine * cosine).sqrt();
    let mut sum = [0.0; 3];
    for row in 0..map.height {
        let solid_angle = map.solid_angle(row);
        for column in 0..map.width {
            let light = map.direction(column, row);
            let cosine: f64 = light.iter().zip(texel.normal).map(|(a, b)| a * b).sum();
            if cosine <= 0.0 {
                continue;
            }
            let twice = (2.0 * (1.0 + light[2])).sqrt().max(1e-9);
            let half = (cosine + texel.normal[2]) / twice;
            let fresnel = (1.0 - (1.0 + light[2]) / twice).max(0.0).powi(5);
            let distribution = square / (PI * (half * half * (square - 1.0) + 1.0).powi(2));
            let visibility = 0.5 / (cosine * root(view) + view * root(cosine));
            let weight = cosine * solid_angle;
            let radiance = map.texels[row * map.width + column];
            for (c, sum) in sum.iter_mut().enumerate() {
                let f0 = f64::from(texel.reflectance[c]);
                let reflected = (f0 + (1.0 - f0) * fresnel) * distribution * visibility;
                let matte = f64::from(texel.matte[c]) * (1.0 - fresnel) / PI;
                *sum += weight * f64::from(radiance[c]) * (reflected + matte);
            }
        }
    }
    sum
}

/// The rms difference of two pictures under an exposure, clipped at white.
fn apart(found: &[[f64; 3]], expected: &[[f64; 3]], exposure: f64) -> f64 {
    let shown = |value: f64| (exposure * value).clamp(0.0, 1.0);
    let squares = found.as_flattened().iter().zip(expected.as_flattened());
    let sum: f64 = squares.map(|(a, b)| (shown(*a) - shown(*b)).powi(2)).sum();
    (sum / found.as_flattened().len() as f64).sqrt()
}

#[test]
fn pictures_are_near_direct_integration() {
    let table = eigenshade_table::decode(shipped::PBR).expect("a table");
    let owned = OwnedBasis::new(&table).expect("a basis");
    let mut shader = Shader::new(owned.any().expect("a basis"), table.count());
    let folder = tempfile::tempdir().expect("a folder");
    let (mut errors, mut sampling) = (Vec::new(), 0.0_f64);
    for name in ["lobby", "park"] {
        let map = shipped_map(name);
        let Lights { degree, entries } = shipped::lights().expect("lights").truncated(12);
        let mut light = entries.into_iter().find(|one| one.name == name).expect("a light");
        let sources = shipped::sources().expect("sources");
        let sources = sources.iter().find(|one| one.name == name).expect("sources").first(SOURCES);
        highlights::take_out(&mut light.rgb, degree, sources);
        let half = halved(&map);
        for (number, (object, glb)) in objects().into_iter().enumerate() {
            let path = folder.path().join("object.glb");
            std::fs::write(&path, glb.bytes()).expect("a file");
            let file = path.into();
            let asset = Asset::read(&file).expect("an object").expect("materials");
            let texels = Texels::of(&file, &asset, SIZE, &View::default()).expect("texels").texels;
            assert!(texels.iter().all(|texel| texel.roughness > 0.299), "{object}");
            let found = irradiance(&mut shader, &light, 12, &texels, sources).expect("colors");
            let found: Vec<[f64; 3]> =
                found.into_iter().map(|rgb| <[f32; 3]>::from(rgb).map(f64::from)).collect();
            let expected: Vec<[f64; 3]> = texels.iter().map(|one| reference(&map, one)).collect();
            let mut meter = Meter::default();
            for [r, g, b] in &expected {
                meter.add(Rgb::new(*r as f32, *g as f32, *b as f32));
            }
            let exposure = f64::from(meter.exposure().expect("light").factor());
            let error = apart(&found, &expected, exposure);
            println!("{name}, {object}: {:.2} % of white, {} texels", 100.0 * error, texels.len());
            errors.push(error);
            if number == 0 {
                let coarse: Vec<[f64; 3]> =
                    texels.iter().map(|one| reference(&half, one)).collect();
                sampling = sampling.max(apart(&coarse, &expected, exposure));
            }
        }
    }
    println!("sums over half the map: {:.3} % of white", 100.0 * sampling);
    assert!(errors.iter().all(|&error| error < OF_WHITE), "{errors:?}");
    // Sums over the whole map are off by a quarter of it.
    assert!(sampling < OF_SAMPLING, "{sampling}");
}

/// The map in half its size each way: means over four texels of nearly the same solid angle.
fn halved(map: &EnvironmentMap) -> EnvironmentMap {
    let (width, height) = (map.width / 2, map.height / 2);
    let texel = |k: usize| {
        let (row, column) = (2 * (k / width), 2 * (k % width));
        let places = [0, 1, map.width, map.width + 1].map(|step| row * map.width + column + step);
        [0, 1, 2].map(|c: usize| places.iter().map(|at| 0.25 * map.texels[*at][c]).sum())
    };
    EnvironmentMap::new(width, height, (0..width * height).map(texel).collect()).expect("a map")
}
