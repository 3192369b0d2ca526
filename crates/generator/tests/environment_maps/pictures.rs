//! Pictures as maps: PNG and JPEG.

use super::files::{exr_channels, map_of, message};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::map_file::is_picture;
use eigenshade_generator::light::projection::project;
use eigenshade_model::srgb::linear;
use exr::prelude::FlatSamples;
use jpeg_encoder::{ColorType as JpegColor, Encoder as JpegEncoder, SamplingFactor};
use png::{BitDepth, ColorType, Encoder, ScaledFloat};
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// A smooth JPEG of quality 100 against its samples: steps of 1/255, and rounding of its
/// transforms.
const JPEG_STEPS: i32 = 3;

/// An sRGB picture of 8 bits against the map that it was made from, of its largest coefficient:
/// half a step of 1/255 is 0.8 % of a radiance of 0.2.
const PICTURE: f64 = 1e-2;

/// A PNG of these samples, with all chunks that the closure adds.
pub fn png_with(
    (width, height): (usize, usize),
    color: ColorType,
    depth: BitDepth,
    samples: &[u8],
    more: impl FnOnce(&mut Encoder<&mut Vec<u8>>),
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_color(color);
    encoder.set_depth(depth);
    more(&mut encoder);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(samples).unwrap();
    writer.finish().unwrap();
    file
}

pub fn png(size: (usize, usize), color: ColorType, depth: BitDepth, samples: &[u8]) -> Vec<u8> {
    png_with(size, color, depth, samples, |_| {})
}

pub fn jpeg((width, height): (usize, usize), rgb: &[u8], progressive: bool) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = JpegEncoder::new(&mut file, 100);
    encoder.set_progressive(progressive);
    encoder.set_sampling_factor(SamplingFactor::F_1_1);
    encoder.encode(rgb, width as u16, height as u16, JpegColor::Rgb).unwrap();
    file
}

/// One small file of each kind with its name.
pub fn small() -> Vec<(String, Vec<u8>)> {
    let eight: Vec<u8> = (0..16 * 8 * 3).map(|k| (k * 7 % 256) as u8).collect();
    let sixteen: Vec<u8> = [&eight[..], &eight].concat();
    let size = (16, 8);
    vec![
        ("map.png".into(), png(size, ColorType::Rgb, BitDepth::Eight, &eight)),
        ("map.png".into(), png(size, ColorType::Rgb, BitDepth::Sixteen, &sixteen)),
        ("map.jpg".into(), jpeg(size, &eight, false)),
        ("map.JPEG".into(), jpeg(size, &eight, true)),
    ]
}

fn read(name: &str, bytes: &[u8]) -> EnvironmentMap {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    EnvironmentMap::from_path(&path).unwrap()
}

/// The sRGB sample of 0 to 255 that is nearest to a radiance.
fn sample(radiance: f32) -> u8 {
    let distance = |code: &u8| (linear(f64::from(*code) / 255.0) - f64::from(radiance)).abs();
    (0..=255).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap()
}

#[test]
fn samples_of_a_png_are_decoded_by_the_curve_of_srgb() {
    let codes: Vec<u8> = (0..=255).collect();
    let gray = read("map.png", &png((32, 8), ColorType::Grayscale, BitDepth::Eight, &codes));
    assert_eq!((gray.width, gray.height), (32, 8));
    for (code, texel) in codes.iter().zip(&gray.texels) {
        assert_eq!(*texel, [linear(f64::from(*code) / 255.0) as f32; 3]);
    }
    assert_eq!((gray.texels[0], gray.texels[255]), ([0.0; 3], [1.0; 3]));
    let words: Vec<u8> =
        [0u16, 1, 2621, 2700, 32768, 65535].into_iter().flat_map(u16::to_be_bytes).collect();
    let sixteen = read("map.png", &png((2, 1), ColorType::Rgb, BitDepth::Sixteen, &words));
    let expected = [[0, 1, 2621], [2700, 32768, 65535]]
        .map(|texel| texel.map(|word| linear(f64::from(word) / 65535.0) as f32));
    assert_eq!(sixteen.texels, expected);
}

#[test]
fn palettes_are_read_and_opacity_is_ignored() {
    let palette =
        |encoder: &mut Encoder<&mut Vec<u8>>| encoder.set_palette(&[255, 0, 0, 0, 255, 0]);
    let file = png_with((2, 1), ColorType::Indexed, BitDepth::Eight, &[1, 0], palette);
    assert_eq!(read("map.png", &file).texels, [[0.0, 1.0, 0.0], [1.0, 0.0, 0.0]]);
    let rgba = png((2, 1), ColorType::Rgba, BitDepth::Eight, &[255, 0, 0, 0, 0, 0, 255, 255]);
    assert_eq!(read("map.png", &rgba).texels, [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]);
}

#[test]
fn declared_curves_are_heeded() {
    let gamma = |value: f32| {
        move |encoder: &mut Encoder<&mut Vec<u8>>| {
            encoder.set_source_gamma(ScaledFloat::new(value));
        }
    };
    let gray = |value| png_with((1, 1), ColorType::Grayscale, BitDepth::Eight, &[51], gamma(value));
    assert_eq!(read("map.png", &gray(1.0)).texels, [[0.2; 3]]);
    assert_eq!(read("map.png", &gray(0.45455)).texels, [[linear(0.2) as f32; 3]]);
    let text = message("map.png", &gray(0.7));
    assert!(
        text.starts_with("map.png: its gAMA chunk is 0.7, which is not a supported "),
        "{text}"
    );
}

#[test]
fn jpegs_are_decoded_to_their_samples() {
    let (width, height) = (37, 19);
    let rgb: Vec<u8> = (0..height)
        .flat_map(|row| {
            (0..width).flat_map(move |column| {
                [40 + 5 * column as u8, 30 + 10 * row as u8, 200 - 3 * column as u8]
            })
        })
        .collect();
    for progressive in [false, true] {
        let map = read("map.jpg", &jpeg((width, height), &rgb, progressive));
        assert_eq!((map.width, map.height), (width, height));
        for (found, expected) in map.texels.iter().flatten().zip(&rgb) {
            let steps = i32::from(sample(*found)) - i32::from(*expected);
            assert!(steps.abs() <= JPEG_STEPS, "{found} for {expected}");
        }
    }
    let mut gray = Vec::new();
    JpegEncoder::new(&mut gray, 100).encode(&[188; 64], 8, 8, JpegColor::Luma).unwrap();
    for [r, g, b] in read("map.jpeg", &gray).texels {
        assert!(r == g && g == b && sample(r).abs_diff(188) <= 1);
    }
}

#[test]
fn a_picture_has_the_light_of_its_map() {
    let degree = 6;
    let map = map_of(32, |[x, y, z]| [0.5 + 0.4 * x, 0.5 + 0.3 * y * z, 0.2].map(|v| v as f32));
    let rgb: Vec<u8> = map.texels.iter().flatten().map(|value| sample(*value)).collect();
    let size = (map.width, map.height);
    let expected = project(&map, degree);
    for (name, bytes) in [
        ("map.png", png(size, ColorType::Rgb, BitDepth::Eight, &rgb)),
        ("map.jpg", jpeg(size, &rgb, false)),
    ] {
        let found = project(&read(name, &bytes), degree);
        super::assert_near(&found, &expected, PICTURE);
    }
}

#[test]
fn pictures_are_known_by_their_endings() {
    assert!(["a.png", "a.JPG", "b/a.jpeg"].iter().all(|path| is_picture(Path::new(path))));
    assert!(["a.exr", "a.hdr", "a.pfm", "png"].iter().all(|path| !is_picture(Path::new(path))));
}

#[test]
fn a_picture_that_claims_too_much_takes_no_memory() {
    let (_, mut jpeg) = small().remove(2);
    let frame = jpeg.windows(2).position(|two| two == [0xff, 0xc0]).unwrap();
    // The marker, its length and the bits a sample are followed by height and width.
    jpeg[frame + 5..frame + 9].copy_from_slice(&[0xff; 4]);
    let text = message("map.jpg", &jpeg);
    assert!(text.starts_with("map.jpg: its header claims 65535 x 65535 pixels, "), "{text}");
    jpeg[frame + 5..frame + 9].copy_from_slice(&[0x1f, 0xff, 0x0f, 0xff]);
    let text = message("map.jpg", &jpeg);
    assert!(text.contains(" bytes cannot hold its 4095 x 8191 pixels"), "{text}");
    let (_, mut png) = small().remove(0);
    png[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
    // The checksum of the header is wrong then: either is an error.
    assert!(message("map.png", &png).contains("; "));
}

/// The opacity belongs to the layer of the colors, and lights ignore it.
#[test]
fn opacities_of_pictures() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("a.exr");
    let samples = |value: f32| FlatSamples::F32(vec![value, 2.0 * value]);
    for (names, opacity) in [
        (&["R", "G", "B"][..], None),
        (&["A", "B", "G", "R"], Some("A")),
        (&["A", "L.A", "L.B", "L.G", "L.R"], Some("L.A")),
        (&["A", "Y"], Some("A")),
    ] {
        let value = |name: &str| if Some(name) == opacity { 0.25 } else { 0.125 };
        let channels = names.iter().map(|&name| (name, samples(value(name)))).collect();
        exr_channels(&path, (2, 1), channels);
        let (map, opacities) = EnvironmentMap::with_opacities(&path).unwrap();
        assert_eq!(opacities, if opacity.is_some() { vec![0.25, 0.5] } else { vec![] });
        assert_eq!(map.texels, [[0.125; 3], [0.25; 3]]);
        assert_eq!(map, EnvironmentMap::from_path(&path).unwrap());
    }
}
