//! Objects in their own materials against an oracle: its own rays, its own formula of glTF and its own
//! samples of a pixel.

use super::cases::{pit, triangles};
use super::oracle::{Triangle, hit, is_hit, percent};
use super::{DEGREE, lights, surface};
use eigenshade::object::TexturedObject;
use eigenshade::screen::{Display, Exposure, Target, Tone};
use eigenshade::{Light, Rgb};
use eigenshade_asset::asset::Asset;
use eigenshade_generator::material::brdf::Ggx;
use eigenshade_generator::object::surface::View;
use eigenshade_model::database::Named;
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::parallel;
use eigenshade_model::special::spherical_harmonic;
use eigenshade_model::vector::dot;
use eigenshade_shadows::light_root::Turns;
use eigenshade_shadows::material::Material;
use eigenshade_shadows::object::Object;
use eigenshade_shadows::packed::Compression;
use eigenshade_shadows::textured::{Textured, TexturedTransports};
use eigenshade_testing::glb::Glb;
use eigenshade_testing::oracle::{ExplicitLight, ggx};
use png::{BitDepth, ColorType, Encoder};
use std::f64::consts::{PI, TAU};

const SIZE: usize = 24;

/// The plate is SIZE - 1 pixels wide. Its bands and its hole end between pixels.
const ENDS: [f64; 2] = [7.5 / 23.0, 15.5 / 23.0];
const HALF: f64 = 12.0 / 23.0;

/// Texels along each side of a picture, ten in each pixel.
const TEXELS: u32 = 230;

/// Directions of the oracle, and samples along each side of a pixel.
const DIRECTIONS: usize = 3000;
const SAMPLES: usize = 3;

/// Red, blue and black in levels of sRGB, from left to right, and the same, linear by the standard.
const BASES: [[u8; 3]; 3] = [[230, 90, 30], [30, 60, 200], [0, 0, 0]];

/// Metallic from top to bottom, in levels.
const METALLIC: [u8; 3] = [0, 255, 128];

/// 128 of 255.
const ROUGHNESS: f64 = 128.0 / 255.0;

fn band(along: f64) -> usize {
    ENDS.iter().filter(|end| along > **end).count()
}

fn picture(of: impl Fn(usize, usize) -> [u8; 3]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, TEXELS, TEXELS);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().unwrap();
    let share = |k: u32| (f64::from(k) + 0.5) / f64::from(TEXELS);
    let places = (0..TEXELS).flat_map(|row| (0..TEXELS).map(move |column| (column, row)));
    let pixels = places.flat_map(|(column, row)| of(band(share(column)), band(share(row))));
    writer.write_image_data(&pixels.collect::<Vec<u8>>()).unwrap();
    writer.finish().unwrap();
    bytes
}

/// A square hole in a plate.
fn relief(material: &str, images: Vec<Vec<u8>>) -> Glb {
    let mesh = pit(HALF, 0.5);
    Glb {
        positions: mesh.corners.iter().map(|corner| corner.map(|one| one as f32)).collect(),
        normals: vec![],
        coordinates: mesh
            .corners
            .iter()
            .map(|[x, y, _]| [0.5 + 0.5 * x, 0.5 - 0.5 * y].map(|one| one as f32))
            .collect(),
        indices: mesh.triangles.concat(),
        material: material.to_owned(),
        images,
        ..Glb::square()
    }
}

fn bands() -> Glb {
    let material = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}}"#;
    let colors = picture(|across, _| BASES[across]);
    let numbers = picture(|_, down| [0, 128, METALLIC[down]]);
    relief(material, vec![colors, numbers])
}

fn read(glb: &Glb, size: usize) -> Textured {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.glb");
    std::fs::write(&path, glb.bytes()).unwrap();
    let file = InputFile::from(path);
    let asset = Asset::read(&file).unwrap().unwrap();
    let view = View { is_flat: true, ..View::default() };
    Textured::new(&file, asset, size, &view).unwrap()
}

fn light(name: &str) -> Named {
    lights().entries.into_iter().find(|light| light.name == name).unwrap()
}

fn radiance(light: &Named) -> impl Fn([f64; 3]) -> [f64; 3] {
    |direction| {
        let harmonics = spherical_harmonic::all(DEGREE, direction);
        let sum = |light: &Vec<f64>| harmonics.iter().zip(light).map(|(y, l)| y * l).sum();
        light.rgb.each_ref().map(sum)
    }
}

fn linear(level: u8) -> f64 {
    let share = f64::from(level) / 255.0;
    if share <= 0.04045 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
}

/// The irradiance of each pixel in three channels, without light between walls, and the band from top to
/// bottom that it is within, if it is within one.
fn oracle(pixels: &[([usize; 2], u8)], light: &Named) -> Vec<([f64; 3], Option<usize>)> {
    let mesh = surface(&pit(HALF, 0.5), true);
    let all: Vec<Triangle> = triangles(&mesh);
    let lights = light.rgb.each_ref().map(|one| ExplicitLight::new(one));
    let each = 4.0 * PI / DIRECTIONS as f64;
    let sky: Vec<([f64; 3], [f64; 3])> = (0..DIRECTIONS)
        .map(|k| {
            let z = 1.0 - (2 * k + 1) as f64 / DIRECTIONS as f64;
            let (sine, cosine) = (TAU * 0.618_033_988_75 * k as f64).sin_cos();
            let across = (1.0 - z * z).sqrt();
            let direction = [across * cosine, across * sine, z];
            (direction, lights.each_ref().map(|light| each * light.radiance(direction)))
        })
        .collect();
    parallel::map(pixels.len(), &(), |k| {
        let ([column, row], _) = pixels[k];
        let mut sum = [0.0; 3];
        let mut seen = 0;
        for sample in 0..SAMPLES * SAMPLES {
            let within = |k: usize| (k as f64 + 0.5) / SAMPLES as f64;
            let place =
                |k: usize, sample: usize| (k as f64 + within(sample) - 0.5) / (SIZE - 1) as f64;
            let [u, v] = [place(column, sample % SAMPLES), place(row, sample / SAMPLES)];
            let from = [2.0 * u - 1.0, 1.0 - 2.0 * v, 10.0];
            let Some((point, normal)) = hit(&all, from, [0.0, 0.0, -1.0]) else { continue };
            assert!(normal[2] > 0.99, "walls are not seen");
            let (across, down) = (band(u), band(v));
            seen += 1;
            let metallic = f64::from(METALLIC[down]) / 255.0;
            let start = [point[0], point[1], point[2] + 1e-5];
            for (direction, radiance) in sky.iter().filter(|(direction, _)| direction[2] > 0.0) {
                if is_hit(&all, start, *direction) {
                    continue;
                }
                for (channel, sum) in sum.iter_mut().enumerate() {
                    let base = linear(BASES[across][channel]);
                    let f0 = 0.04 + (base - 0.04) * metallic;
                    let albedo = base * (1.0 - metallic);
                    let view = [0.0, 0.0, 1.0];
                    let value = ggx(ROUGHNESS, f0, albedo, *direction, view);
                    *sum += value * dot(normal, *direction) * radiance[channel];
                }
            }
        }
        // Where a band ends, textures are filtered, and they repeat.
        let is_within = |k: usize| ![0, 7, 8, 15, 16, 23].contains(&k);
        let band = band(row as f64 / (SIZE - 1) as f64);
        let within = (is_within(column) && is_within(row)).then_some(band);
        (sum.map(|one| one / f64::from(seen)), within)
    })
}

/// The rms of the differences in percent of the largest expected value, over a band or all.
fn apart(expected: &[([f64; 3], Option<usize>)], found: &[[f64; 3]], of: Option<usize>) -> f64 {
    let white = expected.iter().flat_map(|one| one.0).fold(0.0, f64::max);
    let is_compared = |band: Option<usize>| band.is_some() && (of.is_none() || band == of);
    let of_band = expected.iter().zip(found).filter(|(one, _)| is_compared(one.1));
    let squares: Vec<f64> =
        of_band.flat_map(|(a, b)| [0, 1, 2].map(|c: usize| (a.0[c] - b[c]).powi(2))).collect();
    assert!(squares.len() > 300);
    100.0 * (squares.iter().sum::<f64>() / squares.len() as f64).sqrt() / white
}

/// The picture of transports, in three channels.
fn of_transports(transports: &TexturedTransports, light: &Named) -> Vec<[f64; 3]> {
    let channels = [0, 1, 2].map(|c: usize| transports.irradiance(&light.rgb[c], c));
    (0..transports.pixels.len()).map(|k| [0, 1, 2].map(|c: usize| channels[c][k])).collect()
}

/// The picture of the runtime, from pixels of 8 bits and a linear tone curve, whose white is this
/// irradiance.
fn drawn(file: &[u8], light: &Named, pixels: &[([usize; 2], u8)], white: f64) -> Vec<[f64; 3]> {
    let display = Display::new(Tone::Linear);
    let object = TexturedObject::new(file).unwrap();
    let light = light.rgb.each_ref().map(|all| all.iter().map(|&one| one as f32).collect());
    let light: Rgb<Vec<f32>> = light.into();
    let light = light.each_ref().try_map(|channel| Light::new(channel)).unwrap();
    let d = object.coefficients(light).unwrap();
    let mut colors = vec![[0; 3]; object.codes()];
    object.colors(&d, Exposure::new((1.0 / white) as f32).unwrap(), &mut colors).unwrap();
    let (width, height) = (object.width(), object.height());
    let mut screen = vec![[0_u8; 4]; width * height];
    object.draw(&colors, &display, &mut Target::new(&mut screen, width).unwrap());
    let color = |([column, row], coverage): &([usize; 2], u8)| {
        let [r, g, b, opacity] = screen[row * width + column];
        assert!(opacity.abs_diff(*coverage) <= 1);
        [r, g, b].map(|level| white * linear(level))
    };
    pixels.iter().map(color).collect()
}

/// Enamel, metal and a mixture in three base colors, one of which is black.
#[test]
fn bands_of_materials_are_those_of_the_oracle() {
    let mut object = read(&bands(), SIZE);
    object.bounces = 0;
    assert!((f64::from(object.roughness) - ROUGHNESS).abs() < 1e-3);
    assert!(object.is_of_one_roughness(0.01));
    let transports = object.transports(DEGREE, &()).unwrap();
    for name in ["lobby", "park"] {
        let light = light(name);
        let expected = oracle(&object.pixels, &light);
        let on_host = object.irradiances(radiance(&light), &()).unwrap();
        let on_host: Vec<[f64; 3]> = on_host.into_iter().map(|one| one.map(f64::from)).collect();
        let of_transports = of_transports(&transports, &light);
        for (band, of) in
            [(None, "all"), (Some(0), "enamel"), (Some(1), "metal"), (Some(2), "mixed")]
        {
            let [host, transports] =
                [&on_host, &of_transports].map(|one| apart(&expected, one, band));
            println!("{name}, {of}: host {host:.3} %, T and P {transports:.3} %");
            assert!(host < 0.3, "{name}, {of}");
            // The matte share of a mixture is the mean of three channels.
            let bound = if of == "enamel" || of == "metal" { 0.3 } else { 0.4 };
            assert!(transports < bound, "{name}, {of}");
        }
    }
}

/// A file of a code for each T and P, and of 300, against its transports.
#[test]
fn the_runtime_draws_the_transports() {
    let object = read(&bands(), SIZE);
    let transports = object.transports(DEGREE, &()).unwrap();
    for codes in [4096, 300] {
        let compression = Compression { codes, ..Compression::default() };
        let file = transports.packed(&lights(), Turns::All, compression).unwrap();
        for name in ["lobby", "park"] {
            let light = light(name);
            let smooth = smoothed(&light);
            let expected = of_transports(&transports, &smooth);
            let white = expected.iter().flatten().copied().fold(0.0, f64::max);
            let found = drawn(&file, &light, &transports.pixels, white);
            let flat = |all: &[[f64; 3]]| all.as_flattened().to_vec();
            let rms = percent(&flat(&expected), &flat(&found));
            println!("{codes} codes, {name}: {rms:.3} %");
            // Levels of 8 bits, and rows of 8 bits.
            assert!(rms < 0.7, "{codes} {name}");
        }
    }
}

/// A light in the heat kernel of packed objects.
fn smoothed(light: &Named) -> Named {
    let factor = |k: usize| {
        let l = k.isqrt() as f64;
        (-0.5 * 0.06 * 0.06 * l * (l + 1.0)).exp()
    };
    let of = |channel: &Vec<f64>| -> Vec<f64> {
        channel.iter().enumerate().map(|(k, one)| factor(k) * one).collect()
    };
    Named { name: light.name.clone(), rgb: light.rgb.each_ref().map(of) }
}

/// Plastic, a mixture and metal of one gray are the same by base color and as one material, with light
/// between walls.
#[test]
fn a_uniform_material_is_the_plain_one() {
    let light = light("lobby");
    for (base, metallic) in [(0.6, 0.0), (0.6, 0.5), (0.9, 1.0), (0.0, 0.0)] {
        let material = format!(
            r#""pbrMetallicRoughness":{{"baseColorFactor":[{base},{base},{base},1],"metallicFactor":{metallic},"roughnessFactor":0.5}}"#
        );
        let glb = relief(&material, vec![]);
        let textured = read(&glb, SIZE);
        let transports = textured.transports(DEGREE, &()).unwrap();
        let f0 = 0.04 + (base - 0.04) * metallic;
        let ggx = Ggx::new(0.5, f0, base * (1.0 - metallic)).unwrap();
        let mesh = surface(&pit(HALF, 0.5), true);
        let plain = Object::new(&mesh, SIZE, DEGREE, &[Material::Formula(&ggx)], &()).unwrap();
        let expected: Vec<f64> =
            plain.irradiance(&light.rgb[1], &[1.0]).iter().map(|&one| f64::from(one)).collect();
        let places = |all: &[([usize; 2], u8)]| all.iter().map(|one| one.0).collect::<Vec<_>>();
        assert_eq!(places(&plain.pixels), places(&transports.pixels));
        let found = transports.irradiance(&light.rgb[1], 1);
        let host = textured.irradiances(radiance(&light), &()).unwrap();
        let host: Vec<f64> = host.iter().map(|one| f64::from(one[1])).collect();
        let [found, host] = [found, host].map(|one| percent(&expected, &one));
        println!("base {base}, metallic {metallic}: T and P {found:.3} %, host {host:.3} %");
        // Its points of a pixel are others.
        assert!(found < 0.5 && host < 0.5, "{base} {metallic}");
    }
}

/// Two pixels across, and all in one code.
#[test]
fn the_smallest_objects_are_packed() {
    let object = read(&bands(), 2);
    let transports = object.transports(DEGREE, &()).unwrap();
    for codes in [1, 4096] {
        let compression = Compression { codes, ..Compression::default() };
        let file = transports.packed(&lights(), Turns::All, compression).unwrap();
        let runtime = TexturedObject::new(&file).unwrap();
        assert!(runtime.codes() <= codes && runtime.width() == 2);
    }
}
