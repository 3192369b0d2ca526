//! Metadata of map files that changes pixels: primaries, layers, projections, orientations; and the
//! warnings about metadata that is ignored.

use super::files::{exr_channels, hdr_bytes, map_of, pfm};
use super::pictures::{jpeg, png, png_with};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::frame::Frame;
use eigenshade_generator::light::map::Map;
use eigenshade_generator::light::projection::coefficients;
use eigenshade_model::inputs::input_file::InputFile;
use exr::meta::attribute::{Chromaticities, EnvironmentMap as Stated};
use exr::prelude::{FlatSamples, *};
use png::{BitDepth, ColorType, SourceChromaticities};
use std::cell::RefCell;
use std::fs;
use std::path::Path;
use tempfile::TempDir;

/// Colors of matrices whose primaries have four digits, of 1.
const COLOR: f32 = 2e-3;

thread_local! {
    static WARNINGS: RefCell<Vec<String>> = const { RefCell::new(Vec::new()) };
}

/// A map, and the warnings about it.
fn read(path: &Path) -> (Map, String) {
    let file = InputFile::from(path)
        .with_warnings(|_, what| WARNINGS.with_borrow_mut(|all| all.push(what.to_owned())));
    let map = Map::read(file, None).unwrap_or_else(|error| panic!("{error}"));
    (map, WARNINGS.take().join("\n"))
}

pub fn read_bytes(name: &str, bytes: &[u8]) -> (EnvironmentMap, String) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    let (map, warnings) = read(&path);
    let Map::Equirectangular(map) = map else { panic!("{name} is a cube") };
    (map, warnings)
}

#[track_caller]
pub fn assert_color(found: [f32; 3], expected: [f32; 3]) {
    let error = found.iter().zip(expected).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
    assert!(error < COLOR, "{found:?} for {expected:?}");
}

fn chromaticities(list: [[f32; 2]; 4]) -> Chromaticities {
    let [red, green, blue, white] = list.map(|[x, y]| Vec2(x, y));
    Chromaticities { red, green, blue, white }
}

/// One part of 4 x 2 pixels, each of one color.
fn part(name: Option<&str>, channels: &[(&str, f32)]) -> Layer<AnyChannels<FlatSamples>> {
    let channel =
        |(name, value): &(&str, f32)| AnyChannel::new(*name, FlatSamples::F32(vec![*value; 8]));
    let attributes = name.map_or_else(LayerAttributes::default, LayerAttributes::named);
    let channels = AnyChannels::sort(channels.iter().map(channel).collect());
    Layer::new((4, 2), attributes, Encoding::UNCOMPRESSED, channels)
}

#[test]
fn primaries_of_openexr_are_converted() {
    let xyz = [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0], [1.0 / 3.0; 2]];
    let srgb = [[0.64, 0.33], [0.3, 0.6], [0.15, 0.06], [0.3127, 0.329]];
    let prophoto = [[0.7347, 0.2653], [0.1596, 0.8404], [0.0366, 0.0001], [0.3457, 0.3585]];
    let p3 = [[0.68, 0.32], [0.265, 0.69], [0.15, 0.06], [0.3127, 0.329]];
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.exr");
    for (list, color, expected, warning) in [
        // D65's white is white, and the red of sRGB is red.
        (xyz, [0.95046, 1.0, 1.08906], [1.0; 3], "are not those of sRGB: its colors are converted"),
        (xyz, [0.41239, 0.21264, 0.01933], [1.0, 0.0, 0.0], "(1.0000, 0.0000) (0.0000, 1.0000)"),
        (srgb, [0.5, 0.25, 2.0], [0.5, 0.25, 2.0], ""),
        // Equal values stay equal; the primaries as published (ColorSync, colour-science).
        (prophoto, [0.7; 3], [0.7; 3], "converted"),
        (p3, [1.0, 0.0, 0.0], [1.2249, -0.0420, -0.0196], "converted"),
        (p3, [0.0, 1.0, 0.0], [-0.2249, 1.0420, -0.0786], "converted"),
        ([[0.3, 0.3]; 4], [1.0, 2.0, 3.0], [1.0, 2.0, 3.0], "are no primaries"),
    ] {
        let [r, g, b] = color;
        let mut image = Image::from_layer(part(None, &[("R", r), ("G", g), ("B", b)]));
        image.attributes.chromaticities = Some(chromaticities(list));
        image.write().to_file(&path).unwrap();
        let (map, warnings) = read(&path);
        let Map::Equirectangular(map) = map else { panic!("a cube") };
        assert_color(map.texels[5], expected);
        assert!(warnings.contains(warning) && warnings.is_empty() == warning.is_empty());
    }
}

#[test]
fn one_layer_is_chosen_and_named() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.exr");
    let layer =
        |name: &str, value: f32| ["R", "G", "B"].map(|channel| (format!("{name}{channel}"), value));
    for (names, chosen, warning) in [
        (&["ViewLayer.AO.", "ViewLayer.Combined."][..], 1, "ViewLayer.Combined is read"),
        (&["a.", "z.Beauty."], 1, "it has the layers a, z.Beauty: z.Beauty is read"),
        (&["diffuse.", ""], 1, "R, G, B is read"),
        (&["diffuse.", "glossy."], 0, "diffuse is read; save another one alone to use it"),
        (&["only."], 0, ""),
    ] {
        let channels: Vec<_> =
            (0..).zip(names).flat_map(|(k, name)| layer(name, k as f32)).collect();
        let channels: Vec<_> =
            channels.iter().map(|(name, value)| (name.as_str(), *value)).collect();
        Image::from_layer(part(None, &channels)).write().to_file(&path).unwrap();
        let (map, warnings) = read(&path);
        let Map::Equirectangular(map) = map else { panic!("a cube") };
        assert_eq!(map.texels, vec![[chosen as f32; 3]; 8], "{names:?}");
        assert!(warnings.contains(warning) && warnings.is_empty() == warning.is_empty());

        // The same as parts of their own names.
        if names.len() > 1 && !names.contains(&"") {
            let parts = (0..).zip(names).map(|(k, name)| {
                let value = k as f32;
                let name = name.strip_suffix('.').unwrap();
                part(Some(name), &[("R", value), ("G", value), ("B", value)])
            });
            let size = IntegerBounds::from_dimensions((4, 2));
            let parts: Vec<_> = parts.collect();
            Image::from_layers(ImageAttributes::new(size), parts).write().to_file(&path).unwrap();
            let (map, warnings) = read(&path);
            let Map::Equirectangular(map) = map else { panic!("a cube") };
            assert_eq!(map.texels, vec![[chosen as f32; 3]; 8], "{names:?} in parts");
            assert!(warnings.contains(warning), "{warnings}");
        }
    }
    // Gray is read if no layer has color, and opacity is ignored.
    let gray = [("Y", 0.5), ("L.R", 1.0), ("L.G", 1.0), ("L.B", 1.0), ("L.A", 0.5)];
    Image::from_layer(part(None, &gray)).write().to_file(&path).unwrap();
    let (map, warnings) = read(&path);
    let Map::Equirectangular(map) = map else { panic!("a cube") };
    assert_eq!(map.texels, vec![[1.0; 3]; 8]);
    assert!(warnings.contains("its opacity (channel A) is ignored"), "{warnings}");
}

/// The direction of a texel's center by ImfEnvmap.cpp, with edges instead of centers at the ends.
fn openexr(face: usize, size: usize, column: usize, row: usize) -> [f64; 3] {
    let place = |k: usize| (2 * k + 1) as f64 / size as f64 - 1.0;
    let (s, t) = (place(column), place(row));
    // pixelPosition, solved for positionInFace, and direction.
    let [x, y, z] = match face {
        0 => [1.0, -t, s],
        1 => [-1.0, -t, -s],
        2 => [s, 1.0, -t],
        3 => [s, -1.0, t],
        4 => [-s, -t, 1.0],
        _ => [s, -t, -1.0],
    };
    let length = f64::sqrt(x * x + y * y + z * z);
    [x / length, y / length, z / length]
}

/// A cube of six faces and a map, of the same light in OpenEXR's frame, have the same coefficients.
#[test]
fn cubes_of_openexr_are_its_maps() {
    let radiance = |[x, y, z]: [f64; 3]| {
        [1.0 + 0.5 * x - 0.2 * z, 0.8 + 0.4 * y * z + 0.3 * x, 0.5 + 0.4 * y].map(|v| v as f32)
    };
    let size = 32;
    let places = (0..6 * size).flat_map(|row| (0..size).map(move |column| (column, row)));
    let texels =
        places.map(|(column, row)| radiance(openexr(row / size, size, column, row % size)));
    let texels: Vec<_> = texels.collect();
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("cube.exr");
    let write = |size: (usize, usize), texels: &[[f32; 3]], stated| {
        let channel = |(name, k): (&str, usize)| {
            let values = texels.iter().map(|texel| texel[k]).collect();
            AnyChannel::new(name, FlatSamples::F32(values))
        };
        let channels =
            AnyChannels::sort([("R", 0), ("G", 1), ("B", 2)].into_iter().map(channel).collect());
        let mut layer =
            Layer::new(size, LayerAttributes::default(), Encoding::UNCOMPRESSED, channels);
        layer.attributes.environment_map = stated;
        Image::from_layer(layer).write().to_file(&path).unwrap();
    };
    write((size, 6 * size), &texels, Some(Stated::Cube));
    let cube = read(&path).0;
    assert!(cube.is_cube());
    let error = EnvironmentMap::from_path(&path).unwrap_err().to_string();
    assert!(error.contains("it is a cube, as its attribute `envmap` states; "), "{error}");
    // A map's middle is OpenEXR's +z, and its right is -x: in this project -z and +x.
    let map = map_of(64, |[x, y, z]| radiance([-x, y, -z]));
    for frame in [Frame::Eigenshade, Frame::OpenExr, Frame::Blender] {
        let of_map = coefficients(&Map::Equirectangular(map.clone()), frame, 2).unwrap();
        super::assert_near(&coefficients(&cube, frame, 2).unwrap(), &of_map, 4e-3);
    }
    write((size, 5 * size), &texels[..5 * size * size], Some(Stated::Cube));
    let error = Map::read(&path, None).unwrap_err().to_string();
    assert!(
        error.contains("it is 32 x 160 pixels, and its attribute `envmap` a cube; "),
        "{error}"
    );
    // With the shape of a cross.
    let wide = vec![[1.0; 3]; 12 * 9];
    write((12, 9), &wide, None);
    assert!(read(&path).0.is_cube());
    write((12, 9), &wide, Some(Stated::LatitudeLongitude));
    assert!(!read(&path).0.is_cube());
}

/// Every orientation of a file shows the same picture.
#[test]
fn orientations_are_applied() {
    // A picture of 16 x 8 pixels without symmetry, in blocks so that JPEG keeps them.
    let color = |x: usize, y: usize| match (x < 8, y < 8) {
        (true, true) => [0.25, 0.5, 1.0],
        (false, true) => [1.0, 0.25, 0.5],
        (true, false) => [0.5, 0.5, 0.25],
        (false, false) => [0.25; 3],
    };
    let (width, height) = (32, 16);
    let shown = |x: usize, y: usize| color(x * 16 / width, y * 16 / height);
    // What EXIF 2.3 calls row 0 and column 0 of the file, as a viewer shows it.
    let place = |code: usize, row: usize, column: usize| match code {
        1 => (column, row),
        2 => (width - 1 - column, row),
        3 => (width - 1 - column, height - 1 - row),
        4 => (column, height - 1 - row),
        5 => (row, column),
        6 => (width - 1 - row, column),
        7 => (width - 1 - row, height - 1 - column),
        _ => (row, height - 1 - column),
    };
    let exif = |code: usize| {
        let entry = [1, 0x12, 0, 3, 0, 0, 0, 1, 0, code as u8, 0, 0];
        [&b"MM\0\x2a\0\0\0\x08\0\x01"[..], &entry, &[0; 4]].concat()
    };
    let hdr_size = |code: usize| match code {
        1 => "-Y 16 +X 32",
        2 => "-Y 16 -X 32",
        3 => "+Y 16 -X 32",
        4 => "+Y 16 +X 32",
        5 => "+X 32 -Y 16",
        6 => "-X 32 -Y 16",
        7 => "-X 32 +Y 16",
        _ => "+X 32 +Y 16",
    };
    for code in 1..=8 {
        let (columns, rows) = if code < 5 { (width, height) } else { (height, width) };
        let texels = (0..columns * rows).map(|k| {
            let (x, y) = place(code, k / columns, k % columns);
            shown(x, y)
        });
        let stored = EnvironmentMap::new(columns, rows, texels.collect()).unwrap();
        let samples: Vec<u8> =
            stored.texels.iter().flatten().map(|value| (255.0 * value) as u8).collect();
        let mut jpg = jpeg((columns, rows), &samples, false);
        let block = [&b"Exif\0\0"[..], &exif(code)].concat();
        let length = (block.len() as u16 + 2).to_be_bytes();
        jpg.splice(2..2, [&[0xff, 0xe1][..], &length, &block].concat());
        let mut picture = png((columns, rows), ColorType::Rgb, BitDepth::Eight, &samples);
        let chunk = [&b"eXIf"[..], &exif(code)].concat();
        let mut sum = flate2::Crc::new();
        sum.update(&chunk);
        let length = (chunk.len() as u32 - 4).to_be_bytes();
        // After the signature and the header.
        picture.splice(33..33, [&length[..], &chunk, &sum.sum().to_be_bytes()].concat());
        let header = format!("#?RADIANCE\n\n{}\n", hdr_size(code));
        for (name, bytes) in
            [("map.jpg", jpg), ("map.png", picture), ("map.hdr", hdr_bytes(&stored, &header, true))]
        {
            let (map, warnings) = read_bytes(name, &bytes);
            assert_eq!((map.width, map.height, warnings.as_str()), (width, height, ""), "{code}");
            // Relative to the first texel: curves of sRGB and mantissas differ.
            for (number, texel) in map.texels.iter().enumerate() {
                let (x, y) = (number % width, number / width);
                let of = |texel: [f32; 3]| texel.map(|value| (value > 0.15, value > 0.8));
                let linear = |value: f32| match name {
                    "map.hdr" => value,
                    _ => value * value,
                };
                let expected = shown(x, y).map(linear);
                assert_eq!(of(*texel), of(expected), "{name}, {code}: {x}, {y}");
            }
        }
    }
}

/// Lines of a header may end in CR LF, and a first sample that begins with an LF is none.
#[test]
fn headers_of_float_maps_end_in_any_way() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.pfm");
    let map = map_of(2, |[x, y, z]| [x, y, z].map(|v| v as f32));
    pfm(&map, &path, "PF", "-1.0", f32::to_le_bytes);
    let bytes = fs::read(&path).unwrap();
    let (head, samples) = bytes.split_at("PF\n4 2\n-1.0\n".len());
    let crlf = String::from_utf8(head.to_vec()).unwrap().replace('\n', "\r\n");
    let (found, warnings) = read_bytes("map.pfm", &[crlf.as_bytes(), samples].concat());
    assert_eq!((found, warnings.as_str()), (map.clone(), ""));
    let mut samples = samples.to_vec();
    samples[0] = b'\n';
    let cr = [&b"PF 4 2 -1.0\r"[..], &samples].concat();
    let expected = f32::from_le_bytes([samples[0], samples[1], samples[2], samples[3]]);
    assert_eq!(read_bytes("map.pfm", &cr).0.texels[4][0], expected);
    let tail = [&bytes[..], b"\n"].concat();
    let (found, warnings) = read_bytes("map.pfm", &tail);
    assert_eq!((found, warnings.as_str()), (map, "bytes after its last row are ignored: 1"));
    let scaled = [&b"PF\n4 2\n-2.5\n"[..], &bytes[head.len()..]].concat();
    assert_eq!(read_bytes("map.pfm", &scaled).1, "its scale, 2.5, is not applied");
}

/// A sun that a half float cannot hold.
#[test]
fn texels_at_the_limit_of_half_floats_are_counted() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.exr");
    for (value, warning) in
        [(65504.0, "texels at 65504, the largest half float: 1; "), (65472.0, "")]
    {
        let mut samples = vec![f16::from_f32(1.0); 8];
        samples[3] = f16::from_f32(value);
        let samples = || FlatSamples::F16(samples.clone());
        exr_channels(&path, (4, 2), ["R", "G", "B"].map(|name| (name, samples())).into());
        let warnings = read(&path).1;
        assert!(warnings.starts_with(warning) && warnings.is_empty() == warning.is_empty());
    }
}

#[test]
fn pictures_say_what_is_ignored_and_convert_primaries() {
    let p3 = SourceChromaticities::new((0.3127, 0.329), (0.68, 0.32), (0.265, 0.69), (0.15, 0.06));
    let of = |color, samples: &[u8], chrm: Option<SourceChromaticities>| {
        png_with((2, 1), color, BitDepth::Eight, samples, |encoder| {
            if let Some(chrm) = chrm {
                encoder.set_source_chromaticities(chrm);
            }
        })
    };
    let (map, warnings) =
        read_bytes("map.png", &of(ColorType::Rgb, &[255, 0, 0, 255, 255, 255], Some(p3)));
    assert_color(map.texels[0], [1.2249, -0.0420, -0.0196]);
    assert_color(map.texels[1], [1.0; 3]);
    assert_eq!(warnings, "its primaries are not those of sRGB: its colors are converted");
    let (_, warnings) =
        read_bytes("map.png", &of(ColorType::Rgba, &[255, 0, 0, 255, 9, 9, 9, 254], None));
    assert_eq!(warnings, "its opacity is ignored");
}
