//! Objects other than a sphere: packed normals, pictures of them, and matcaps.

use crate::pictures::{assert_same_codes, drawn};
use crate::support::Folder;
use crate::support::files::{decoded, normal_map, obj, ply, stl};
use eigenshade::object::{Matcap, NormalMap, NormalPixel};
use eigenshade::screen::{Display, Exposure, Tone};
use eigenshade::{Normal, presets, sphere};
use eigenshade_cli::object::{ObjectOptions, ObjectView};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_testing::vectors::{Vector, unit};
use eigenshade_testing::{fixtures, largest};
use png::BitDepth;
use std::f64::consts::PI;

/// A normal after packing, in degrees.
const PACKED: f64 = 0.51;

/// The flat facets of a mesh of 24 rings against the ellipsoid that it approximates, in degrees: a
/// pixel averages over a facet at least in part.
const FACETED: f64 = 5.0;

/// The angle between the normal of a pixel and another one.
fn degrees(pixel: NormalPixel, exact: Vector) -> f64 {
    let normal = pixel.normal().components().map(f64::from);
    let square: f64 = normal.iter().zip(exact).map(|(a, b)| (a - b) * (a - b)).sum();
    (2.0 * (0.5 * square.sqrt()).asin()).to_degrees()
}

/// x and y of a pixel's middle in a picture of this width, for an object of this radius in pixels.
fn place(pixel: NormalPixel, width: f64, radius: f64) -> [f64; 2] {
    let at = |k: usize| (k as f64 + 0.5 - 0.5 * width) / radius;
    [at(pixel.column()), -at(pixel.row())]
}

/// The packed bytes of an object, and its printed size.
fn packed(folder: &Folder, input: &str, options: &str) -> (Vec<u8>, [usize; 2]) {
    let printed = folder.ok(&format!("pack-object {input} {options} --out packed.bin"));
    let line = printed.lines().next().unwrap();
    let mut words = line.split([' ', ',']).filter_map(|word| word.parse::<usize>().ok());
    let size = [words.next().unwrap(), words.next().unwrap()];
    (folder.bytes("packed.bin"), size)
}

fn map(bytes: &[u8], [width, height]: [usize; 2]) -> NormalMap<'_> {
    NormalMap::new(width, height, bytes).unwrap()
}

/// A sphere, and a normal map of 16 bits: every normal within the error of packing, coverage at the
/// outline.
#[test]
fn packed_normals_are_those_of_the_object() {
    let folder = Folder::new();
    let (bytes, size) = packed(&folder, "sphere", "--size 64");
    assert_eq!((size, bytes.len()), ([64, 64], 8192));
    let view = ObjectView::sphere(64);
    let mut edges = 0;
    let mut found = map(&bytes, size).pixels();
    for (pixel, normal) in view.pixels.iter().zip(&view.normals) {
        if pixel.coverage < 1.0 / 64.0 {
            continue;
        }
        let Some(shown) = found.next() else { panic!("a pixel is missing") };
        // A tip may have no neighbor that is covered completely.
        assert_eq!([shown.column(), shown.row()], [pixel.column, pixel.row]);
        let off = degrees(shown, *normal);
        if shown.coverage() == 255 {
            assert!(pixel.coverage >= 0.5 && off < PACKED, "{off}");
        } else {
            // Of one pixel beside it: 1/32 inside the rim.
            edges += 1;
            assert!((f64::from(shown.coverage()) / 255.0 - pixel.coverage).abs() < 0.04);
            assert!(off < 25.0, "{off}");
        }
    }
    assert!(found.next().is_none() && edges > 100, "{edges}");

    folder.write("sphere.png", normal_map(BitDepth::Sixteen));
    let (bytes, size) = packed(&folder, "sphere.png", "");
    assert_eq!(size, [64, 64]);
    let disc = fixtures::disc(64);
    assert_eq!(map(&bytes, size).pixels().count(), disc.len());
    for (pixel, exact) in map(&bytes, size).pixels().zip(disc) {
        let off = degrees(pixel, exact);
        assert!(pixel.coverage() == 255 && off < PACKED, "{off}");
    }
    // Half the size: each pixel is a mean of four, and has a coverage.
    let (bytes, size) = packed(&folder, "sphere.png", "--size 32");
    assert_eq!(size, [32, 32]);
    let edges = map(&bytes, size).pixels().filter(|pixel| pixel.coverage() < 255).count();
    assert!(edges > 20, "{edges}");
    for pixel in map(&bytes, size).pixels().filter(|pixel| pixel.coverage() == 255) {
        let [x, y] = place(pixel, 32.0, 16.0);
        let z = (1.0 - x * x - y * y).max(0.0).sqrt();
        if z > 0.3 {
            let off = degrees(pixel, [x, y, z]);
            assert!(off < PACKED + 0.5, "{off}");
        }
    }
}

/// The three mesh formats give one map, which is an ellipsoid's of half-axes 1, 0.7 and 1.3.
#[test]
fn meshes_are_drawn_from_the_camera() {
    let folder = Folder::new();
    folder.write("e.obj", obj());
    folder.write("e.ply", ply());
    folder.write("e.stl", stl());
    let (bytes, size) = packed(&folder, "e.obj", "--size 80");
    assert_eq!(size, [80, 80]);
    assert_eq!(packed(&folder, "e.ply", "--size 80"), (bytes.clone(), size));
    let stl = packed(&folder, "e.stl", "--size 80").0;
    // Corners in single precision move a few samples.
    let other = stl.chunks(2).zip(bytes.chunks(2)).filter(|(a, b)| a != b).count();
    assert!(other < 60, "{other}");
    let (mut area, mut most) = (0.0, 0.0_f64);
    for pixel in map(&bytes, size).pixels() {
        area += f64::from(pixel.coverage()) / 255.0;
        // A margin of half a pixel.
        let [x, y] = place(pixel, 80.0, 39.5);
        let square = 1.0 - x * x - y * y / 0.49;
        if square > 0.05 {
            most = most.max(degrees(pixel, unit([x, y / 0.49, square.sqrt() / 1.3])));
        }
    }
    let exact = PI * 39.5 * 39.5 * 0.7;
    println!("{most} degrees, area {area} of {exact}");
    assert!(most < FACETED && (area / exact - 1.0).abs() < 0.02, "{most} {area} {exact}");
}

/// A nearer sheet hides one behind it, and one that faces away shows nothing.
#[test]
fn the_nearest_facet_is_drawn() {
    let folder = Folder::new();
    // Toward the camera: a slope in front of the left half of a square; a hole over a quarter.
    let corners = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv -1 -1 1\nv 0 -1 2\nv 0 1 2\nv -1 1 1\n\
                   v 0 0 3\nv 1 0 3\nv 1 1 3\nv 0 1 3\n";
    let faces = "f 1 2 3 4\nf 5 6 7 8\nf 9 12 11 10\n";
    folder.write("sheets.obj", format!("{corners}{faces}"));
    let (bytes, size) = packed(&folder, "sheets.obj", "--size 9");
    let map = map(&bytes, size);
    let at = |column: usize, row: usize| {
        map.row(row).find(|pixel| pixel.column() == column).map(|pixel| pixel.normal().components())
    };
    let half = std::f32::consts::FRAC_1_SQRT_2;
    for row in 1..8 {
        let slope = at(2, row).unwrap();
        assert!((slope[0] + half).abs() < 0.01 && (slope[2] - half).abs() < 0.01, "{slope:?}");
        let behind = at(6, row);
        assert_eq!(behind.is_none(), row < 4, "{row}: {behind:?}");
    }
}

/// The source is Rust: its first line is the command, and its numbers are the bytes.
#[test]
fn packed_normals_as_source() {
    let folder = Folder::new();
    let printed = folder.ok("pack-object sphere --size 16 --out ball.rs");
    assert!(printed.contains("16 x 16") && printed.contains("mod ball;"), "{printed}");
    let text = folder.read("ball.rs");
    let (first, rest) = text.split_once('\n').unwrap();
    assert_eq!(first, "// eigenshade pack-object sphere --size 16 --out ball.rs");
    assert!(rest.contains("eigenshade::object::NormalMap::new(16, 16, &BYTES)"));
    let numbers = rest.split_once("= [").unwrap().1.trim_end().trim_end_matches("];");
    let numbers = numbers.split(',').map(str::trim).filter(|number| !number.is_empty());
    let bytes: Vec<u8> = numbers.map(|number| number.parse().unwrap()).collect();
    assert_eq!(bytes, packed(&folder, "sphere", "--size 16").0);
    assert!(text.lines().all(|line| line.len() <= 100));
}

fn lobby() -> sphere::color::Scene {
    sphere::color::scene(presets::light::LOBBY, presets::material::GOLD_METALLIC_PAINT).unwrap()
}

const CHOICE: &str = "--light lobby --material gold-metallic-paint";
/// The scene without what `render` chooses.
const PLAIN: &str = "--sources 0 --window none";

/// Pictures of a mesh and of a normal map have the colors of their normals, and their opacity is
/// the object's coverage.
#[test]
fn any_object_is_rendered() {
    let folder = Folder::new();
    folder.write("e.obj", obj());
    folder.write("map.png", normal_map(BitDepth::Eight));
    let scene = lobby();
    for (input, size, options) in
        [("e.obj", 48, "--size 48"), ("map.png", 64, ""), ("map.png", 20, "--size 20")]
    {
        folder.ok(&format!(
            "render -t sphere {CHOICE} --normals {input} {options} {PLAIN} --exposure 1.5 --tone filmic \
             --out p.png"
        ));
        let (width, _, bytes) = decoded(&folder.path("p.png"));
        assert_eq!((width, bytes.len()), (size, 4 * (size * size) as usize));
        let asked = (!options.is_empty()).then_some(size as usize);
        let view =
            ObjectView::read(folder.path(input).into(), ObjectOptions::of_size(asked)).unwrap();
        assert_same_codes(&bytes, &drawn(&view, &scene, Tone::Filmic, 1.5), input);
        if input == "e.obj" {
            let between = bytes.chunks(4).filter(|pixel| ![0, 255].contains(&pixel[3])).count();
            assert!(between > 50, "{between}");
        }
    }
    // The same by default as by name.
    folder.ok(&format!("render {CHOICE} --size 32 --out a.png"));
    folder.ok(&format!("render {CHOICE} --size 32 --normals sphere --out b.png"));
    assert_eq!(folder.bytes("a.png"), folder.bytes("b.png"));
}

/// Matcaps hold the irradiance of their texels' normals, in linear numbers or in sRGB, with the top
/// row at +y.
#[test]
fn matcaps_hold_the_scene() {
    let folder = Folder::new();
    let scene = lobby();
    let texels = Matcap::new(64).unwrap();
    let peak = largest(texels.map(|texel| f64::from(scene.shade(texel.normal()).largest())));
    for (option, radius) in [
        ("--matcap", 1.0),
        ("--matcap=three", Matcap::THREE_JS),
        ("--matcap=blender", Matcap::BLENDER),
    ] {
        let render =
            format!("render --table sphere {CHOICE} {PLAIN} {option} --size 40 --exposure");
        folder.ok(&format!("{render} 2 --out m.exr"));
        folder.ok(&format!("{render} 0.5 --out m.png"));
        let map = EnvironmentMap::from_path(folder.path("m.exr")).unwrap();
        let (width, _, bytes) = decoded(&folder.path("m.png"));
        assert_eq!((width, bytes.len(), map.width, map.height), (40, 3 * 1600, 40, 40));
        let display = Display::new(Tone::Linear);
        for texel in Matcap::new(40).unwrap().with_radius(radius).unwrap() {
            let exact = scene.shade(texel.normal());
            let place = texel.index();
            for (found, exact) in map.texels[place].into_iter().zip(<[f32; 3]>::from(exact)) {
                assert!((f64::from(found) - 2.0 * f64::from(exact)).abs() < 1e-5 * peak);
            }
            let shown = <[u8; 3]>::from(display.rgb888(Exposure::new(0.5).unwrap().of(exact)));
            let pixel = &bytes[3 * place..3 * place + 3];
            assert!(pixel.iter().zip(shown).all(|(a, b)| a.abs_diff(b) <= 1));
        }
    }
    // Without an exposure, an .exr has irradiance itself, and a picture its opacity.
    folder.ok(&format!("render --table sphere {CHOICE} {PLAIN} --size 16 --out s.exr"));
    let map = EnvironmentMap::from_path(folder.path("s.exr")).unwrap();
    let view = ObjectView::sphere(16);
    let mut expected = vec![[0.0; 3]; 256];
    for (pixel, normal) in view.pixels.iter().zip(&view.normals) {
        let [x, y, z] = normal.map(|component| component as f32);
        let color = <[f32; 3]>::from(scene.shade(Normal::new(x, y, z).unwrap()));
        expected[pixel.row * 16 + pixel.column] = color.map(|one| f64::from(one) * pixel.coverage);
    }
    for (found, expected) in map.texels.iter().flatten().zip(expected.iter().flatten()) {
        assert!((f64::from(*found) - expected).abs() < 1e-5 * peak);
    }
    // Metered as a sphere is: white is not all of it.
    folder.ok(&format!("render {CHOICE} --matcap --size 64 --out metered.png"));
    let (.., bytes) = decoded(&folder.path("metered.png"));
    let white = bytes.chunks(3).filter(|pixel| pixel.contains(&255)).count();
    assert!(white > 0 && white < 400, "{white}");
}
