//! Pictures: reading them, the transfer functions of PNG files, and the normals of a sphere.

use crate::support::files::{answer, decoded, get, gray_png, nearest, png};
use crate::support::{Folder, assert_contains, rows, shipped_path};
use crate::tolerances;
use eigenshade::lights::Window;
use eigenshade::screen::{Display, Exposure, Tone};
use eigenshade::sphere::color::Scene;
use eigenshade::{Light, Normal, Rgb, Rotation, presets, sphere};
use eigenshade_cli::object::ObjectView;
use eigenshade_cli::picture::SphereView;
use eigenshade_cli::pixels::{LinearImage, Transfer};
use eigenshade_model::shipped;
use eigenshade_model::sphere_rings::rings;
use eigenshade_model::srgb::linear;
use eigenshade_testing::largest_difference;
use png::chunk::ChunkType;
use png::{BitDepth, ColorType, Encoder, ScaledFloat, SrgbRenderingIntent};
use std::fs;

/// d of an image and normals in 16 bits against d of an image in 8 bits of sRGB and exact normals,
/// relative to the largest: half a step of 2^-16 in normals, more at the rim.
const READ_SIXTEEN_BITS: f64 = 5e-4;

/// Share of the energy that 50 components leave of a picture in 8 bits: 3 % in amplitude.
const READ_PICTURE: f64 = 1e-3;

/// A name is the same light or material as the shipped file's entry, and no table is `sphere.bin`.
#[test]
fn names_are_entries_of_the_shipped_files() {
    let folder = Folder::new();
    let [table, lights, materials] =
        ["color.bin", "inputs/lights.csv", "inputs/materials.csv"].map(shipped_path);
    let sphere = shipped_path("sphere.bin");
    folder.ok(&format!(
        "render -t {sphere} -l {lights}:park -m {materials}:07-velvet --size 32 --out a.png"
    ));
    folder.ok("render --light park --material 07-velvet --size 32 --out b.png");
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
    let header = "kind,name,size,color,mean_9_7,mean_most_9_7,p95_9_7,p95_most_9_7,\
                  mean_12_12,mean_most_12_12,p95_12_12,p95_most_12_12";
    let listed = rows(&folder.ok("list"), header);
    // Shipped materials in color have errors; the gray ones of CUReT have none.
    for row in &listed {
        let errors: Vec<Option<f64>> = row[4..].iter().map(|text| text.parse().ok()).collect();
        if row[0] == "material" && (row[3] == "rgb" || row[1] == "ptfe-633nm") {
            let errors: Vec<f64> = errors.into_iter().map(|one| one.expect("a number")).collect();
            // 95 of 100 maps do not exceed at least the median, nor 95 of 100 pixels half the mean.
            for pair in errors.chunks(2) {
                assert!(pair[0] > 0.0 && pair[1] > pair[0], "{row:?}");
            }
            assert!(errors[2] > errors[0] && errors[6] > errors[4], "{row:?}");
        } else {
            assert_eq!(errors, [None; 8], "{row:?}");
        }
    }
    for (kind, entries) in [
        ("light", shipped::lights().unwrap().entries),
        ("material", shipped::named_materials(7).unwrap().entries),
    ] {
        let of_kind = listed.iter().filter(|row| row[0] == kind).map(|row| &row[1]);
        assert!(of_kind.eq(entries.iter().map(|entry| &entry.name)), "{kind}");
    }
    // The other commands take names as well.
    let shaded =
        |rest: &str| folder.ok(&format!("shade --table {table} {rest} --normals normals.csv"));
    let by_name = shaded("--light park --material 07-velvet");
    let of_file = shaded(&format!("--light {lights} --material {materials}"));
    let of_both: Vec<_> =
        of_file.lines().filter(|row| row.starts_with("park,07-velvet,")).collect();
    assert_eq!(by_name.lines().skip(1).collect::<Vec<_>>(), of_both);
    let projected = format!("--table {table} --light park --material 07-velvet --components 3");
    assert_eq!(folder.projected(&projected).len(), 3 * 3);
}

/// Exposure, tone curve, rotation, window, effects and components change a picture as the runtime
/// does.
#[test]
fn pictures_follow_their_options() {
    let folder = Folder::new();
    let size = 24;
    // Without sources and windows, which the runtime's scene does not choose.
    let picture = |options: &str| {
        let window = if options.contains("--window") { "" } else { "--window none" };
        let sources = if options.contains("--effects") { "" } else { "--sources 0" };
        picture_of_gold(&folder, size, &format!("{options} {window} {sources}"))
    };
    let near = |options: &str, expected: Vec<u8>| {
        let found = picture(options);
        assert_same_codes(&found, &expected, options);
        found
    };
    let lobby = presets::light::LOBBY;
    let linear = near("--exposure 0.5", gold(size, Tone::Linear, 0.5, lobby));
    near("--exposure 0.5 --tone reinhard", gold(size, Tone::Reinhard, 0.5, lobby));
    near("--exposure 2 --tone filmic", gold(size, Tone::Filmic, 2.0, lobby));
    let rotation = Rotation::from_euler(0.5, 1.2, -0.3).unwrap();
    let turned = lobby.turned::<100>(&rotation).unwrap();
    let turned = gold(size, Tone::Linear, 0.5, turned.lights().unwrap());
    assert!(turned != linear);
    near("--exposure 0.5 --rotate 0.5,1.2,-0.3", turned);
    let windowed = lobby.windowed::<100>(Window::SincFourth { width: 12.0 }).unwrap();
    near("--exposure 0.5 --window 12", gold(size, Tone::Linear, 0.5, windowed.lights().unwrap()));
    // Metered: a pixel in a hundred is white in some channel, or up to one in ten.
    let metered = picture("");
    let visible = metered.chunks(4).filter(|pixel| pixel[3] > 0);
    let white = visible.clone().filter(|pixel| pixel[..3].contains(&255)).count();
    let visible = visible.count();
    assert!(white > 0 && white <= visible / 8, "{white} of {visible}");
    // As is light of any scale.
    for scale in ["1e-25", "1e-5", "1e5", "1e25"] {
        let light: String =
            (0..4).map(|k| format!("x,{},{},{scale},0,0\n", k.min(1), [0, -1, 0, 1][k])).collect();
        folder.write("scaled.csv", format!("name,l,m,r,g,b\n{light}"));
        folder.ok(&format!("render --light scaled.csv --material nylon --out a.png --size {size}"));
        let (.., pixels) = decoded(&folder.path("a.png"));
        let white = pixels.chunks(4).filter(|pixel| pixel[3] > 0 && pixel[0] == 255).count();
        assert!(white > 0 && white < visible / 10, "{scale}: {white} of {visible}");
    }
    assert!(picture("--exposure 0.5 --components 3") != linear);
    let effects = picture("--exposure 0.1 --effects ambient,diffuse");
    assert!(effects != picture("--exposure 0.1"));
    // More pixels than are shaded together have no seams.
    let found = picture_of_gold(&folder, 600, "--exposure 0.5 --sources 0 --window none");
    assert_same_codes(&found, &gold(600, Tone::Linear, 0.5, lobby), "in bands");
}

/// The bytes of the picture of gold paint under the lobby's light.
fn picture_of_gold(folder: &Folder, size: usize, options: &str) -> Vec<u8> {
    let scene = "--table sphere --light lobby --material gold-metallic-paint";
    folder.ok(&format!("render {scene} --size {size} --out a.png {options}"));
    decoded(&folder.path("a.png")).2
}

/// Rounding may move a code by one.
pub fn assert_same_codes(found: &[u8], expected: &[u8], name: &str) {
    let most = found.iter().zip(expected).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(found.len() == expected.len() && most <= Some(1), "{name}: {most:?}");
}

/// The bytes of the picture of a sphere of gold paint under a light.
fn gold(size: usize, tone: Tone, exposure: f32, light: Rgb<Light<'_>>) -> Vec<u8> {
    let scene = sphere::color::scene(light, presets::material::GOLD_METALLIC_PAINT).unwrap();
    drawn(&ObjectView::sphere(size), &scene, tone, exposure)
}

/// The bytes of the picture of an object, as the runtime computes it.
pub fn drawn(view: &ObjectView, scene: &Scene, tone: Tone, exposure: f32) -> Vec<u8> {
    let (display, exposure) = (Display::new(tone), Exposure::new(exposure).unwrap());
    let mut bytes = vec![0; 4 * view.width * view.height];
    for (normal, pixel) in view.normals.iter().zip(&view.pixels) {
        let [x, y, z] = normal.map(|component| component as f32);
        let color = exposure.of(scene.shade(Normal::new(x, y, z).unwrap()));
        let [r, g, b] = <[u8; 3]>::from(display.rgb888(color));
        let start = 4 * (pixel.row * view.width + pixel.column);
        let opacity = (255.0 * pixel.coverage).round() as u8;
        bytes[start..start + 4].copy_from_slice(&[r, g, b, opacity]);
    }
    bytes
}

#[test]
fn pictures_of_velvet() {
    let folder = Folder::new();
    folder.ok("render --table curet --light park --material 07-velvet --size 96 --out v.png");
    let read = |arguments: &str| {
        let (text, message) = folder.both(&format!("read {arguments} --table curet"));
        (answer(&text), message)
    };
    // 8 bits of sRGB, transparent around, a hundredth of it clipped.
    let (sphere, message) = read("v.png --normals sphere");
    assert_eq!(nearest(&sphere), "07-velvet", "{message}");
    assert_contains(&message, &["v.png: 9216 pixels, ", " clipped"]);
    assert!(get(&sphere, "relative-residual", "posterior")[0][0] < READ_PICTURE);

    // The same in 16 linear bits, with the normals as a map and a mask of half.
    let (.., bytes) = decoded(&folder.path("v.png"));
    let (mut samples, mut map, mut mask) = (Vec::new(), Vec::new(), Vec::new());
    for (place, pixel) in bytes.chunks_exact(4).enumerate() {
        let [x, y] = [(place % 96) as f64 - 47.5, 47.5 - (place / 96) as f64].map(|at| at / 47.5);
        let square = 1.0 - x * x - y * y;
        let normal = if square > 0.0 { [x, y, square.sqrt()] } else { [0.0; 3] };
        for (channel, n) in pixel.iter().zip(normal) {
            let value = linear(f64::from(*channel) / 255.0);
            samples.extend(((65535.0 * value).round() as u16).to_be_bytes());
            map.extend(((65535.0 * (0.5 + 0.5 * n)).round() as u16).to_be_bytes());
        }
        mask.push(if x < 0.5 { 255 } else { 0 });
    }
    folder.write("linear.png", png([96; 2], BitDepth::Sixteen, ColorType::Rgb, &samples));
    folder.write("map.png", png([96; 2], BitDepth::Sixteen, ColorType::Rgb, &map));
    folder.write("mask.png", gray_png(96, 96, &mask));
    let (mapped, _) = read("linear.png --normals map.png");
    let [of_sphere, of_map] =
        [&sphere, &mapped].map(|found| get(found, "d", "posterior").as_flattened());
    let largest = of_sphere[0].abs();
    let far = largest_difference(of_sphere, of_map) / largest;
    println!("16 bits: {far:.1e}");
    assert!(far <= READ_SIXTEEN_BITS, "{far:e}");
    let (masked, message) = read("linear.png --normals map.png --mask mask.png");
    let counts = [&mapped, &masked].map(|found| get(found, "fit", "pixels")[0][0]);
    assert!(counts[1] < 0.85 * counts[0] && counts[1] > 0.7 * counts[0], "{counts:?} {message}");
    // A table without its databases uses the shipped ones.
    fs::copy(shipped_path("curet.bin"), folder.path("alone.bin")).unwrap();
    let alone = answer(&folder.ok("read v.png --normals sphere --table alone.bin"));
    assert_eq!(alone, sphere);
    // Read as linear, the 8 bits of sRGB are another image.
    let (wrong, _) = read("v.png --normals sphere --transfer linear");
    assert!((get(&wrong, "d", "posterior")[0][0] / largest - 1.0).abs() > 0.1);
    // Noise and components from options.
    let (fewer, _) = read("v.png --normals sphere --components 9 --noise 0.01");
    assert_eq!(get(&fewer, "d", "posterior").len(), 9);
    assert!(get(&fewer, "fit", "noise")[0][0] > 0.01);
}

/// Half of full scale, less a half.
const SAMPLE: [u8; 2] = [127, 255];

/// The header fields of a PNG.
#[derive(Clone, Copy, Debug, Default)]
struct Declared {
    srgb: bool,
    gamma: Option<u32>,
    profile: bool,
    points: Option<u8>,
}

fn picture(depth: BitDepth, declared: Declared) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 1, 1);
    encoder.set_depth(depth);
    encoder.set_color(ColorType::Grayscale);
    if let Some(gamma) = declared.gamma {
        encoder.set_source_gamma(ScaledFloat::from_scaled(gamma));
    }
    if declared.srgb {
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
    }
    let mut writer = encoder.write_header().unwrap();
    if declared.profile {
        // Its contents are not a profile, and must not be read.
        writer.write_chunk(ChunkType(*b"iCCP"), b"name\0\0rubbish").unwrap();
    }
    if let Some(points) = declared.points {
        writer.write_chunk(ChunkType(*b"cICP"), &[1, points, 0, 1]).unwrap();
    }
    let bytes = if depth == BitDepth::Sixteen { &SAMPLE[..] } else { &SAMPLE[..1] };
    writer.write_image_data(bytes).unwrap();
    writer.finish().unwrap();
    file
}

#[test]
fn curves_are_those_that_files_declare() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("one.png");
    let (eight, sixteen) = (BitDepth::Eight, BitDepth::Sixteen);
    let (linear, srgb) = (Ok(Transfer::Linear), Ok(Transfer::Srgb));
    let nothing = Declared::default();
    let gamma = |value| Declared { gamma: Some(value), ..nothing };
    let profile = Declared { profile: true, ..nothing };
    let points = |value| Declared { points: Some(value), ..nothing };
    for (depth, declared, expected) in [
        (eight, nothing, srgb),
        (sixteen, nothing, linear),
        (sixteen, Declared { srgb: true, ..nothing }, srgb),
        (eight, gamma(100_000), linear),
        (sixteen, gamma(100_000), linear),
        (eight, gamma(45_455), srgb),
        (sixteen, gamma(45_455), srgb),
        (sixteen, gamma(45_454), srgb),
        (eight, gamma(55_556), Err("gAMA chunk is 0.55556")),
        (sixteen, gamma(50_000), Err("gAMA chunk is 0.5,")),
        // Meaningless; by the format it is ignored.
        (sixteen, gamma(0), linear),
        (eight, profile, Err("color profile")),
        (sixteen, profile, Err("color profile")),
        (eight, Declared { gamma: Some(100_000), ..profile }, Err("color profile")),
        (sixteen, Declared { srgb: true, ..profile }, srgb),
        (eight, points(8), linear),
        (sixteen, points(13), srgb),
        (eight, points(16), Err("cICP chunk has the transfer 16")),
    ] {
        fs::write(&path, picture(depth, declared)).unwrap();
        let stored = match depth {
            BitDepth::Sixteen => f64::from(u16::from_be_bytes(SAMPLE)) / 65535.0,
            _ => f64::from(SAMPLE[0]) / 255.0,
        };
        let of = |transfer| match transfer {
            Transfer::Linear => stored,
            Transfer::Srgb => ((stored + 0.055) / 1.055).powf(2.4),
        };
        let value = |image: LinearImage| image.pixels[0][0];
        match (LinearImage::read(&path, None), expected) {
            (Ok(image), Ok(transfer)) => {
                let (found, expected) = (value(image), of(transfer));
                assert!((found - expected).abs() < 1e-9, "{declared:?}: {found}, not {expected}");
            }
            (Err(error), Err(fragment)) => {
                let line = error.to_string();
                assert_contains(&line, &[fragment, "one.png", "; ", "--transfer"]);
                assert_eq!(line.lines().count(), 1, "{declared:?}: {line}");
            }
            (found, expected) => panic!("{declared:?}: {found:?}, not {expected:?}"),
        }
        // The option has precedence over the file.
        for transfer in [Transfer::Linear, Transfer::Srgb] {
            let found = value(LinearImage::read(&path, Some(transfer)).unwrap());
            assert!((found - of(transfer)).abs() < 1e-9, "{declared:?} as {transfer:?}: {found}");
        }
    }
}

/// A mean over midpoints between rings: a quarter of the square of the step.
const RING_MIDPOINTS: f64 = 1e-4;

/// Squared length of a unit normal: some roundings.
const UNIT_LENGTH: f64 = 1e-15;

/// ∫ cos α cos(α)/π dω = 2/3 over the disc.
#[test]
fn shares_are_those_of_the_disc() {
    let rings = rings(0.02);
    let sum = |of: fn(f64) -> f64| -> f64 {
        rings.iter().map(|ring| ring.weight * ring.tilts.len() as f64 * of(ring.slant)).sum()
    };
    assert!((sum(|_| 1.0) - 1.0).abs() < tolerances::RING_SHARES);
    assert!((sum(f64::cos) - 2.0 / 3.0).abs() < RING_MIDPOINTS);
}

#[test]
fn normals_are_unit_and_up_is_y() {
    let view = SphereView::new(33);
    for n in &view.normals {
        let square: f64 = n.iter().map(|c| c * c).sum();
        assert!((square - 1.0).abs() < UNIT_LENGTH && n[2] >= 0.0);
    }
    assert!(view.normals[0][1] > 0.9 && view.pixels[0].row == 0);
    let middle = view.pixels.iter().position(|p| (p.column, p.row) == (16, 16)).unwrap();
    assert_eq!(view.normals[middle], [0.0, 0.0, 1.0]);
}
