//! `render --object` with the object's own materials.

use crate::support::files::{decoded, gray_png, normal_map, png};
use crate::support::{Folder, assert_fails};
use eigenshade::object::{Object, TexturedObject};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType};

/// Pictures of a texture of one color and of a factor, of the peak.
const OF_A_FACTOR: f64 = 1e-5;

/// Against the coefficients of `material gltf` of the same order, of the peak.
const OF_THE_FORMULA: f64 = 1e-5;

/// Irradiance times opacity, from an .exr.
fn picture(folder: &Folder, options: &str) -> Vec<f64> {
    folder.ok(&format!("render --light lobby {options} --size 48 --out p.exr"));
    let map = EnvironmentMap::from_path(folder.path("p.exr")).expect("a picture");
    map.texels.iter().flatten().map(|value| f64::from(*value)).collect()
}

/// The largest difference, of the peak.
fn apart(found: &[f64], expected: &[f64]) -> f64 {
    let peak = expected.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
    assert!(peak > 0.0 && found.len() == expected.len());
    let apart = found.iter().zip(expected).map(|(a, b)| (a - b).abs());
    apart.fold(0.0, f64::max) / peak
}

fn sphere(material: &str) -> Glb {
    Glb { material: material.to_owned(), ..Glb::sphere(24) }
}

/// One uniform texture gives the picture of the factor, also with sources, and that of the material
/// by name.
#[test]
fn a_uniform_texture_is_the_material() {
    let folder = Folder::new();
    // 204 of 255 is 0.8, of which sRGB makes 0.6038273.
    let factor = r#""pbrMetallicRoughness":{"baseColorFactor":[0.6038273389,0.6038273389,0.6038273389,1],"metallicFactor":0.6,"roughnessFactor":0.4}"#;
    let textured = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}}"#;
    folder.write("factor.glb", sphere(factor).bytes());
    let mut glb = sphere(textured);
    let numbers = png([2, 2], BitDepth::Eight, ColorType::Rgb, &[0, 102, 153].repeat(4));
    glb.images = vec![gray_png(4, 4, &[204; 16]), numbers];
    folder.write("textured.glb", glb.bytes());
    for options in ["", "--sources 8", "--sources 0 --window none", "-t sphere --sources 0"] {
        let factor = picture(&folder, &format!("--object factor.glb {options}"));
        let textured = picture(&folder, &format!("--object textured.glb {options}"));
        let error = apart(&textured, &factor);
        println!("{options}: {error:.1e}");
        assert!(error < OF_A_FACTOR, "{options}: {error:e}");
    }
    folder.ok(
        "material gltf --base-color 0.6038273389,0.6038273389,0.6038273389 --metallic 0.6 --roughness \
         0.4 --order 12 --out m.csv",
    );
    let options = "-t pbr --sources 0 --window none";
    let own = picture(&folder, &format!("--object factor.glb {options}"));
    let named = picture(&folder, &format!("--object factor.glb --material m.csv {options}"));
    // At the rim, several texels of a pixel are shaded, and by name one mean normal.
    let inner = |all: &[f64]| -> Vec<f64> {
        let is_inner = |k: usize| {
            let [x, y] = [k / 3 % 48, k / 3 / 48].map(|c| c as f64 - 23.5);
            x.hypot(y) < 18.0
        };
        all.iter().enumerate().filter(|(k, _)| is_inner(*k)).map(|(_, value)| *value).collect()
    };
    let error = apart(&inner(&own), &inner(&named));
    println!("by name: {error:.1e}");
    assert!(error < OF_THE_FORMULA, "{error:e}");
}

/// A roughness texture is near the picture of its roughness in the middle.
#[test]
fn roughness_by_texture() {
    let folder = Folder::new();
    let material =
        |roughness: f64| format!(r#""pbrMetallicRoughness":{{"roughnessFactor":{roughness}}}"#);
    let ramp: Vec<u8> = (0..64 * 64).flat_map(|k| [0, (k % 64 * 4) as u8, 255]).collect();
    let mut glb = sphere(r#""pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}"#);
    glb.images = vec![png([64, 64], BitDepth::Eight, ColorType::Rgb, &ramp)];
    folder.write("ramp.glb", glb.bytes());
    let found = picture(&folder, "--object ramp.glb --sources 0 --window none");
    // The middle of the picture has u = 1/4.
    let error = |roughness: f64| {
        folder.write("one.glb", sphere(&material(roughness)).bytes());
        let one = picture(&folder, "--object one.glb --sources 0 --window none");
        let peak = one.iter().copied().fold(0.0, f64::max);
        let middle = 3 * (24 * 48 + 24);
        (found[middle] - one[middle]).abs() / peak
    };
    let [right, wrong] = [0.25, 0.75].map(error);
    println!("{right:.1e}, of another roughness {wrong:.1e}");
    assert!(right < 0.01 && wrong > 0.02, "{right} {wrong}");
}

#[test]
fn pictures_and_messages() {
    let folder = Folder::new();
    folder.write("a.glb", sphere("").bytes());
    let message = folder.messages("render --object a.glb --light lobby --size 32 --out a.png");
    assert!(message.contains("drawn with table pbr (250 components)"), "{message}");
    let (width, color, bytes) = decoded(&folder.path("a.png"));
    assert_eq!((width, color, bytes.len()), (32, ColorType::Rgba, 4096));
    let opaque = bytes.chunks(4).filter(|pixel| pixel[3] == 255).count();
    assert!((650..850).contains(&opaque), "{opaque}");
    // With a material of its own choice, and packed.
    folder.ok("render --object a.glb --light lobby --material chrome --size 32 --out b.png");
    assert!(folder.bytes("a.png") != folder.bytes("b.png"));
    folder.ok("pack-object a.glb --size 32 --view top --normals-only --out a.bin");
    assert_eq!(folder.bytes("a.bin").len(), 2 * 32 * 32);
    // A map without a mesh has the material that is given.
    folder.write("map.png", normal_map(BitDepth::Eight));
    folder.ok("render --object map.png --light lobby --material chrome --size 32 --out b.png");
    for (options, fragments) in [
        ("--object sphere", &["no material, and the object has none", "--material"][..]),
        ("--object map.png", &["no material, and the object has none", "--material"]),
        ("--object none.glb", &["none.glb"]),
        ("--object a.glb --format f64", &["drawn in f32"]),
        ("--object a.glb --flip-green --material chrome", &["--flip-green is for a normal map"]),
    ] {
        let command = format!("render --light lobby {options} --out new.png");
        assert_fails(&folder, &command, fragments);
    }
}

/// A sphere of two roughnesses, packed: its file, its source and what the program says.
#[test]
fn packed_objects_have_regions() {
    let folder = Folder::new();
    let halves: Vec<u8> =
        (0..64 * 64).flat_map(|k| if k % 32 < 16 { [0, 77, 0] } else { [0, 204, 255] }).collect();
    let mut glb = sphere(r#""pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}"#);
    glb.images = vec![png([64, 64], BitDepth::Eight, ColorType::Rgb, &halves)];
    folder.write("a.glb", glb.bytes());
    let printed = folder.ok("pack-object a.glb --size 32 --out a.bin");
    let bytes = folder.bytes("a.bin");
    let object = Object::new(&bytes).expect("an object");
    let mut found: Vec<f32> = object.regions().map(|region| region.roughness()).collect();
    found.sort_by(f32::total_cmp);
    println!("{printed}{found:?}");
    // Texels at the border of both mix them.
    assert!((2..=4).contains(&found.len()), "{found:?}");
    assert!((found[0] - 0.302).abs() < 0.03 && (found.last().unwrap() - 0.8).abs() < 0.03);
    assert!(printed.contains("32 x 32") && printed.contains("region 1"), "{printed}");
    assert!(printed.contains("in Rust      eigenshade::object::Object::new(include_bytes!("));
    folder.ok("pack-object a.glb --size 32 --regions 1 --out one.bin");
    assert_eq!(Object::new(&folder.bytes("one.bin")).expect("an object").regions().len(), 1);
    folder.ok("pack-object a.glb --size 32 --out a.rs");
    let text = folder.read("a.rs");
    let first = "// eigenshade pack-object a.glb --size 32 --out a.rs\n\n/// The object.\npub static OBJECT: ";
    assert!(text.starts_with(first), "{text}");
    let numbers = text.split_once("] = [").expect("bytes").1.trim_end().trim_end_matches("];");
    let numbers = numbers.split(',').filter_map(|number| number.trim().parse::<u8>().ok());
    assert!(numbers.eq(bytes.iter().copied()));
    assert_fails(&folder, "pack-object a.glb --flip-green --out b.bin", &["for a normal map"]);
}

#[expect(dead_code, reason = "its `main` draws a file that is not there")]
#[path = "../../asset/examples/draw_glb.rs"]
mod program;

/// The ten lines of the README of `eigenshade-asset` draw the bytes that `render` does.
#[test]
fn a_program_draws_the_same_picture() {
    let text = include_str!("../../asset/examples/draw_glb.rs");
    let (_, program) = text.split_once("\n\n").expect("a comment");
    let readme = include_str!("../../asset/README.md");
    assert!(readme.contains(&format!("```rust\n{program}```")), "{program}");
    let folder = Folder::new();
    let material =
        r#""pbrMetallicRoughness":{"baseColorFactor":[0.9,0.6,0.3,1],"roughnessFactor":0.3}"#;
    folder.write("a.glb", sphere(material).bytes());
    let path = |name| folder.path(name).display().to_string();
    program::draw(&path("a.glb"), "lobby", &path("program.png")).expect("a picture");
    folder.ok("render --object a.glb --light lobby --out render.png");
    assert!(folder.bytes("program.png") == folder.bytes("render.png"));
}

/// A mirror is drawn as a roughness of 0.2 with the highlights of lamps, and a note has the error.
#[test]
fn a_mirror_is_far_off() {
    let folder = Folder::new();
    let material = r#""pbrMetallicRoughness":{"roughnessFactor":0}"#;
    folder.write("a.glb", sphere(material).bytes());
    let message = folder.messages("render --object a.glb --light lobby --size 32 --out a.png");
    assert!(
        message.contains("note: `a.glb` is sharper than degree 12, order 12 with"),
        "{message}"
    );
    assert!(message.contains("has an estimated screen error of"), "{message}");
    let (_, _, bytes) = decoded(&folder.path("a.png"));
    assert!(bytes.iter().any(|byte| *byte > 0 && *byte < 255));
}

/// A box whose sides have colors, as a polygon file.
fn colored_box() -> String {
    let mut corners = String::new();
    // The outward axis, and the color, of each side.
    for (axis, sign, color) in [
        (2, 1.0, "1 0 0"),
        (2, -1.0, "0 1 0"),
        (0, 1.0, "0 0 1"),
        (0, -1.0, "1 1 0"),
        (1, 1.0, "1 0 1"),
        (1, -1.0, "0 1 1"),
    ] {
        for [u, v] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
            let mut at = [0.0; 3];
            (at[axis], at[(axis + 1) % 3], at[(axis + 2) % 3]) = (sign, u * sign, v);
            corners += &format!("{} {} {} {color}\n", at[0], at[1], at[2]);
        }
    }
    let channels = ["x", "y", "z", "red", "green", "blue"];
    let channels = channels.map(|name| format!("property float {name}\n")).concat();
    let sides = (0..6).map(|k| [0, 1, 2, 3].map(|corner| 4 * k + corner));
    let sides: String = sides.map(|[a, b, c, d]| format!("4 {a} {b} {c} {d}\n")).collect();
    format!(
        "ply\nformat ascii 1.0\nelement vertex 24\n{channels}element face 6\nproperty list uchar int \
         vertex_indices\nend_header\n{corners}{sides}"
    )
}

/// Each view shows the side of its name, and colors of corners are drawn without a material.
#[test]
fn views_show_the_sides_of_their_names() {
    let folder = Folder::new();
    folder.write("box.ply", colored_box());
    for (view, expected) in [
        ("front", [true, false, false]),
        ("back", [false, true, false]),
        ("right", [false, false, true]),
        ("left", [true, true, false]),
        ("top", [true, false, true]),
        ("bottom", [false, true, true]),
    ] {
        folder.ok(&format!("render --object box.ply --light park --view {view} --size 9 -o v.png"));
        let (_, _, bytes) = decoded(&folder.path("v.png"));
        let middle = &bytes[4 * (4 * 9 + 4)..][..3];
        let brightest = middle.iter().max().copied().unwrap_or_default();
        assert_eq!([0, 1, 2].map(|c: usize| middle[c] > brightest / 2), expected, "{view}");
    }
}

/// Own materials with shadows, on the host and packed.
#[test]
fn own_materials_have_shadows() {
    let folder = Folder::new();
    let material = r#""pbrMetallicRoughness":{"baseColorFactor":[0.6,0.6,0.6,1],"metallicFactor":0.6,"roughnessFactor":0.5}"#;
    folder.write("a.glb", sphere(material).bytes());
    let own = picture(&folder, "--object a.glb --shadows");
    folder
        .ok("material gltf --base-color 0.6 --metallic 0.6 --roughness 0.5 --order 12 --out m.csv");
    let named = picture(&folder, "--object a.glb --shadows --material m.csv");
    let squares: f64 = own.iter().zip(&named).map(|(a, b)| (a - b).powi(2)).sum();
    let peak = named.iter().copied().fold(0.0, f64::max);
    let rms = (squares / own.len() as f64).sqrt() / peak;
    // By name it is a series.
    println!("by name: {rms:.1e}");
    assert!(rms < 0.01, "{rms}");
    let command = "pack-object a.glb --shadows --size 16";
    let printed = folder.ok(&format!("{command} --out o.bin"));
    assert!(printed.contains("eigenshade::object::TexturedObject::new("), "{printed}");
    let bytes = folder.bytes("o.bin");
    let object = TexturedObject::new(&bytes).expect("an object");
    assert_eq!([object.width(), object.degree()], [16, 16]);
    folder.ok(&format!("{command} --out o.rs"));
    let source = folder.read("o.rs");
    assert!(
        source.starts_with("// eigenshade pack-object a.glb --size 16 --shadows --codes 4096 ")
    );
    assert!(source.contains("pub static OBJECT: eigenshade::object::TexturedObject<'static>"));
    let of_info = folder.ok("info --table o.bin");
    assert!(of_info.contains("with shadows, in its own materials"), "{of_info}");
    assert!(of_info.contains("version                  3"), "{of_info}");
    let in_c = "C draws objects with shadows in one material only; give a --material";
    assert_fails(&folder, &format!("{command} --out o.h"), &[in_c]);
    folder.ok(&format!("{command} --material chrome --out o.h"));
    // No materials.
    folder.write("plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    let none = "no material, and the object has none of its own; give --material NAME";
    assert_fails(&folder, "render --light lobby --object plain.obj --shadows --out p.png", &[none]);
    assert_fails(&folder, "pack-object plain.obj --shadows --out p.bin", &[none]);
    // What is not drawn is named.
    let varied = r#""pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}},"occlusionTexture":{"index":0}"#;
    let ramp: Vec<u8> = (0..64 * 64).flat_map(|k| [255, 100 + (k % 64 * 2) as u8, 255]).collect();
    let mut glb = sphere(varied);
    glb.images = vec![png([64, 64], BitDepth::Eight, ColorType::Rgb, &ramp)];
    folder.write("varied.glb", glb.bytes());
    let render = "render --object varied.glb --light lobby --shadows --size 24 --out p.png";
    let said = folder.messages(render);
    for expected in
        ["drawn with shadows, light of degree", "have one roughness", "occlusion maps are left out"]
    {
        assert!(said.contains(expected), "{said}");
    }
}
