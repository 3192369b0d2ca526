//! `render --object` with the object's own materials.

use crate::support::files::{decoded, gray_png, png};
use crate::support::{Folder, assert_fails};
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType};

/// Pictures of a texture of one color and of a factor, of the peak.
const OF_A_FACTOR: f64 = 1e-5;

/// Against the coefficients of `material gltf`: those of the series are within 2e-4 of them.
const OF_THE_FORMULA: f64 = 3e-4;

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

/// A roughness texture is near the pictures of its roughnesses, left and right.
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
    // The middle of the picture has u = 3/4 or 1/4.
    let mut best = f64::INFINITY;
    for roughness in [0.25, 0.75] {
        folder.write("one.glb", sphere(&material(roughness)).bytes());
        let one = picture(&folder, "--object one.glb --sources 0 --window none");
        let peak = one.iter().copied().fold(0.0, f64::max);
        let middle = 3 * (24 * 48 + 24);
        best = best.min((found[middle] - one[middle]).abs() / peak);
    }
    assert!(best < 0.02, "{best}");
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
    folder.ok("pack-normals a.glb --size 32 --view top --out a.bin");
    for (options, fragments) in [
        ("--object sphere", &["no material, and the object has none", "--material"][..]),
        ("--object none.glb", &["none.glb"]),
        ("--object a.glb --format f64", &["drawn in f32"]),
        ("--object a.glb --flip-green --material chrome", &["--flip-green is for a normal map"]),
    ] {
        let command = format!("render --light lobby {options} --out new.png");
        assert_fails(&folder, &command, fragments);
    }
}
