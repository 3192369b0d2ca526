//! Materials and textures in the pixels of a picture.

use crate::support::{at, drawn, png, read, square};
use eigenshade_generator::object::surface::View;
use eigenshade_model::srgb::linear;
use eigenshade_testing::glb::Glb;

const GRAY: &str = r#""pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,1,1],"metallicFactor":0.25,"roughnessFactor":0.4}"#;

/// Degrees between the normals of a sphere of 32 rings and the true ones, rms.
const SPHERE: f64 = 0.3;

fn near(found: [f32; 3], expected: [f64; 3]) -> bool {
    found.iter().zip(expected).all(|(a, b)| (f64::from(*a) - b).abs() < 1e-6)
}

#[test]
fn factors_of_a_material() {
    let texel = at(&drawn(&square(GRAY, Vec::new()), 16), 8, 8).expect("a texel");
    let f0 = [0.5, 0.25, 1.0].map(|base| 0.04 + (base - 0.04) * 0.25);
    let base = [0.5, 0.25, 1.0];
    let matte = [0, 1, 2].map(|c: usize| base[c] * 0.75 * (1.0 - f0[c]));
    assert!(near(texel.reflectance, f0) && near(texel.matte, matte), "{texel:?}");
    assert_eq!((texel.roughness, texel.normal), (0.4, [0.0, 0.0, 1.0]));
}

#[test]
fn a_sphere_is_smooth() {
    for has_normals in [true, false] {
        let mut glb = Glb::sphere(32);
        glb.material = GRAY.to_owned();
        if !has_normals {
            glb.normals.clear();
        }
        let texels = drawn(&glb, 64);
        let (mut sum, mut count, mut area, mut first) = (0.0, 0.0, 0.0, 0);
        for pixel in &texels.pixels {
            area += pixel.coverage;
            let [x, y] = [pixel.column as f64 - 31.5, 31.5 - pixel.row as f64].map(|c| c / 31.5);
            let square = x * x + y * y;
            if square < 0.95 {
                let exact = [x, y, (1.0 - square).sqrt()];
                let normal = texels.texels[first].normal;
                let chord: f64 = normal.iter().zip(exact).map(|(a, b)| (a - b) * (a - b)).sum();
                (sum, count) = (sum + chord, count + 1.0);
                assert_eq!(texels.texels[first].roughness, 0.4);
            }
            first += pixel.texels;
        }
        let off = f64::to_degrees(f64::sqrt(sum / count));
        let disc = std::f64::consts::PI * 31.5 * 31.5;
        println!("{off:.3} degrees, area {:.4}", area / disc);
        assert!(off < SPHERE && (area / disc - 1.0).abs() < 0.01, "{off}, {area} of {disc}");
    }
}

/// A texture of one color is that color as a factor, at any size.
#[test]
fn uniform_textures_are_factors() {
    let [r, g, b] = [200u8, 90, 30];
    let color = [r, g, b].map(|code| linear(f64::from(code) / 255.0));
    let factor = format!(
        r#""pbrMetallicRoughness":{{"baseColorFactor":[{},{},{},1],"metallicFactor":0.6,"roughnessFactor":0.2}}"#,
        color[0], color[1], color[2]
    );
    let expected = drawn(&square(&factor, Vec::new()), 20);
    let textured = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}},"normalTexture":{"index":2},"occlusionTexture":{"index":3}"#;
    for size in [[1, 1], [2, 3], [64, 64], [513, 300]] {
        let images = vec![
            png(size, |_, _| [r, g, b, 255]),
            png(size, |_, _| [0, 51, 153, 255]),
            png(size, |_, _| [128, 128, 255, 255]),
            png(size, |_, _| [255; 4]),
        ];
        let found = drawn(&square(textured, images), 20);
        assert_eq!((&found.pixels, &found.shares), (&expected.pixels, &expected.shares));
        for (found, expected) in found.texels.iter().zip(&expected.texels) {
            assert!(near(found.matte, expected.matte.map(f64::from)), "{size:?}: {found:?}");
            assert!(near(found.reflectance, expected.reflectance.map(f64::from)), "{size:?}");
            assert!((found.roughness - 0.2).abs() < 1e-6, "{size:?}: {found:?}");
            // 128 of 255 is not quite 0.
            assert!(found.normal[2] > 0.9999, "{size:?}: {found:?}");
        }
    }
}

/// Red at the upper left, green right, blue below; colors of corners multiply.
#[test]
fn textures_lie_as_they_should() {
    let picture = png([8, 8], |column, row| match (column / 4, row / 4) {
        (0, 0) => [255, 0, 0, 255],
        (1, 0) => [0, 255, 0, 255],
        (0, 1) => [0, 0, 255, 255],
        _ => [255; 4],
    });
    let material = r#""pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}"#;
    let mut glb = square(material, vec![picture]);
    let texels = drawn(&glb, 41);
    let color = |column, row| at(&texels, column, row).expect("a texel").matte;
    assert!(near(color(10, 10), [0.96, 0.0, 0.0]), "{:?}", color(10, 10));
    assert!(near(color(30, 10), [0.0, 0.96, 0.0]) && near(color(10, 30), [0.0, 0.0, 0.96]));
    glb.colors = vec![[0.5, 0.5, 0.5, 1.0]; 4];
    assert!(near(at(&drawn(&glb, 41), 30, 30).expect("a texel").matte, [0.48; 3]));
    // Moved by half of its width.
    let moved = r#""pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0,"extensions":{"KHR_texture_transform":{"offset":[0.5,0]}}}}"#;
    let glb = Glb {
        material: moved.to_owned(),
        extra: r#""extensionsUsed":["KHR_texture_transform"],"#.to_owned(),
        ..glb
    };
    assert!(near(at(&drawn(&glb, 41), 10, 10).expect("a texel").matte, [0.0, 0.48, 0.0]));
}

/// Occlusion darkens the matte part alone.
#[test]
fn occlusion_is_of_the_matte_part() {
    let images = vec![png([4, 4], |_, _| [51, 0, 0, 255])];
    let material = format!(r#"{GRAY},"occlusionTexture":{{"index":0,"strength":0.5}}"#);
    let plain = at(&drawn(&square(GRAY, Vec::new()), 16), 8, 8).expect("a texel");
    let texel = at(&drawn(&square(&material, images), 16), 8, 8).expect("a texel");
    assert_eq!((texel.reflectance, texel.roughness), (plain.reflectance, plain.roughness));
    assert!(near(texel.matte, plain.matte.map(|matte| 0.6 * f64::from(matte))), "{texel:?}");
}

/// Red tilts to the right, green up, by MikkTSpace's tangents; also behind a mirror, a rotation and
/// on the back of a double-sided square.
#[test]
fn normal_maps_tilt_normals() {
    let material = format!(r#"{GRAY},"doubleSided":true,"normalTexture":{{"index":0,"scale":1}}"#);
    for (color, expected) in
        [([204, 128, 230], [0.6, 0.0, 0.8]), ([128, 204, 230], [0.0, 0.6, 0.8])]
    {
        let [r, g, b] = color;
        let glb = square(&material, vec![png([4, 4], |_, _| [r, g, b, 255])]);
        let normal = |glb: &Glb| at(&drawn(glb, 16), 5, 9).expect("a texel").normal;
        let close = |found: [f64; 3], expected: [f64; 3]| {
            found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 0.01)
        };
        assert!(close(normal(&glb), expected), "{:?}", normal(&glb));
        let [x, y, z] = expected;
        let mirrored = Glb { node: r#","scale":[-1,1,1]"#.to_owned(), ..glb.clone() };
        assert!(close(normal(&mirrored), [-x, y, z]), "{:?}", normal(&mirrored));
        let turned = Glb {
            node: r#","rotation":[0,0,0.7071067811865476,0.7071067811865476]"#.to_owned(),
            ..glb.clone()
        };
        assert!(close(normal(&turned), [-y, x, z]), "{:?}", normal(&turned));
        // From behind, x runs the other way, and bumps become hollows.
        let back = Glb { node: r#","rotation":[0,1,0,0]"#.to_owned(), ..glb };
        assert!(close(normal(&back), [x, -y, z]), "{:?}", normal(&back));
    }
}

/// Where normals differ within a sample, the lobe is wider; a map of one normal changes nothing.
#[test]
fn bumps_widen_the_roughness() {
    let material = format!(r#"{GRAY},"normalTexture":{{"index":0}}"#);
    let roughness = |of: &dyn Fn(u32, u32) -> [u8; 4]| {
        let texels = drawn(&square(&material, vec![png([256, 256], of)]), 8);
        let texel = at(&texels, 4, 4).expect("a texel");
        (texel.roughness, texel.normal)
    };
    assert_eq!(roughness(&|_, _| [204, 128, 230, 255]).0, 0.4);
    let (wide, normal) = roughness(&|column, _| {
        if column % 2 == 0 { [204, 128, 230, 255] } else { [51, 128, 230, 255] }
    });
    // A mean of length 0.8.
    let expected = (0.4_f32.powi(4) + 0.5).sqrt().sqrt();
    assert!((wide - expected).abs() < 0.01 && normal[2] > 0.999, "{wide} {expected} {normal:?}");
}

/// Holes are seen through, and backs are not there, unless they are double-sided.
#[test]
fn holes_and_backs() {
    let half = png([8, 8], |column, _| [255, 255, 255, if column < 4 { 255 } else { 0 }]);
    let material = r#""alphaMode":"MASK","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}"#;
    let glb = square(material, vec![half]);
    let texels = drawn(&glb, 33);
    assert!(at(&texels, 8, 16).is_some() && at(&texels, 24, 16).is_none());
    let area: f64 = texels.pixels.iter().map(|pixel| pixel.coverage).sum();
    assert!((area / (32.0 * 16.0) - 1.0).abs() < 0.05, "{area}");
    let back = r#","rotation":[0,1,0,0]"#.to_owned();
    let (error, _) = read(
        &[("a.glb", &Glb { node: back.clone(), ..Glb::square() }.bytes())],
        9,
        &View::default(),
    );
    assert!(error.expect_err("a back").contains("nothing of it is seen"));
    let leaf = Glb { node: back, material: r#""doubleSided":true"#.to_owned(), ..Glb::square() };
    assert_eq!(at(&drawn(&leaf, 9), 4, 4).expect("a texel").normal, [0.0, 0.0, 1.0]);
}
