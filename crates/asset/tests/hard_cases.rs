//! Objects at the edge of what a file may hold.

use crate::support::{at, drawn, png, read, square};
use eigenshade_asset::texels::Texels;
use eigenshade_generator::object::surface::View;
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType, Encoder};

const TILTED: &str = r#""normalTexture":{"index":0}"#;

/// Where the coordinates of a texture are mirrored, red tilts to the left.
#[test]
fn mirrored_textures_tilt_the_other_way() {
    let mut glb = square(TILTED, vec![png([4, 4], |_, _| [204, 128, 230, 255])]);
    let plain = at(&drawn(&glb, 16), 5, 9).expect("a texel").normal;
    glb.coordinates.iter_mut().for_each(|[u, _]| *u = 1.0 - *u);
    let mirrored = at(&drawn(&glb, 16), 5, 9).expect("a texel").normal;
    assert!(plain[0] > 0.59 && (plain[0] + mirrored[0]).abs() < 1e-6, "{plain:?} {mirrored:?}");
    assert!((plain[1] - mirrored[1]).abs() < 0.01, "{plain:?} {mirrored:?}");
}

/// Triangles without an area change nothing.
#[test]
fn triangles_without_an_area_are_left_out() {
    let glb = Glb { material: TILTED.to_owned(), ..Glb::sphere(8) };
    let glb = Glb { images: vec![png([4, 4], |_, _| [204, 128, 230, 255])], ..glb };
    let mut with = glb.clone();
    with.indices = glb.indices.iter().copied().chain([3, 3, 9, 5, 6, 5, 7, 7, 7]).collect();
    assert_eq!(drawn(&with, 24), drawn(&glb, 24));
}

/// The two sides of a leaf: one sheet seen from both sides, or two whose normals are opposite.
#[test]
fn leaves_show_the_side_that_is_seen() {
    let turned = r#","rotation":[0,1,0,0]"#.to_owned();
    // From behind, its normals point away, and are turned.
    let sheet = Glb { material: r#""doubleSided":true"#.to_owned(), ..Glb::square() };
    let bent = |glb: &Glb| {
        let normals = [[0.6, 0.0, 0.8], [0.6, 0.0, 0.8], [0.6, 0.0, 0.8], [0.6, 0.0, 0.8]];
        Glb { normals: normals.to_vec(), ..glb.clone() }
    };
    let [front, back] = [String::new(), turned.clone()]
        .map(|node| at(&drawn(&Glb { node, ..bent(&sheet) }, 9), 4, 4).expect("a texel").normal);
    for (found, expected) in front.iter().zip([0.6, 0.0, 0.8]) {
        assert!((found - expected).abs() < 1e-6, "{front:?}");
    }
    // A turn about y by 180 degrees takes (0.6, 0, 0.8) to (-0.6, 0, -0.8); its back has the other.
    for (found, expected) in back.iter().zip([0.6, 0.0, 0.8]) {
        assert!((found - expected).abs() < 1e-6, "{back:?}");
    }
    // Two sheets in one place: each side shows its own color.
    let mut leaf = Glb::square();
    let corners = leaf.positions.len() as u32;
    let back: Vec<u32> =
        leaf.indices.as_chunks().0.iter().flat_map(|&[a, b, c]| [a, c, b]).collect();
    leaf.indices.extend(back.into_iter().map(|corner| corners + corner));
    leaf.positions = leaf.positions.repeat(2);
    leaf.coordinates = leaf.coordinates.repeat(2);
    leaf.normals.extend([[0.0, 0.0, -1.0]; 4]);
    leaf.colors = [[[1.0, 0.0, 0.0, 1.0]; 4], [[0.0, 1.0, 0.0, 1.0]; 4]].concat();
    leaf.material = r#""pbrMetallicRoughness":{"metallicFactor":0}"#.to_owned();
    for (node, channel) in [(String::new(), 0), (turned, 1)] {
        let texels = drawn(&Glb { node, ..leaf.clone() }, 16);
        assert!(texels.pixels.len() > 200);
        for texel in &texels.texels {
            assert!(texel.matte[channel] > 0.9 && texel.matte[1 - channel] == 0.0, "{texel:?}");
            assert_eq!(texel.normal, [0.0, 0.0, 1.0]);
        }
    }
}

/// A normal map of 16 bits tilts by a hundredth of a degree.
#[test]
fn normal_maps_of_16_bits() {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 2, 2);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Sixteen);
    let mut writer = encoder.write_header().expect("a header");
    let tilt = 2e-4_f64;
    let pixel = [tilt, 0.0, 1.0].map(|c| (32767.5 * (c + 1.0)).round() as u16);
    let bytes: Vec<u8> = pixel.repeat(4).iter().flat_map(|code| code.to_be_bytes()).collect();
    writer.write_image_data(&bytes).expect("pixels");
    writer.finish().expect("an end");
    let normal = at(&drawn(&square(TILTED, vec![file]), 16), 8, 8).expect("a texel").normal;
    // A code is 3e-5.
    assert!((normal[0] - tilt).abs() < 2e-5 && normal[1].abs() < 2e-5, "{normal:?}");
}

/// An object of one pixel, and one far smaller than the distance between samples.
#[test]
fn objects_of_one_pixel() {
    let texels = drawn(&Glb::sphere(16), 2);
    let area: f64 = texels.pixels.iter().map(|pixel| pixel.coverage).sum();
    assert!((area - std::f64::consts::FRAC_PI_4).abs() < 0.1, "{area}");
    assert!(texels.texels.iter().all(|texel| texel.normal[2] > 0.0));
    // A needle of 1 to 10,000 hits no sample, or few.
    let mut needle = Glb::square();
    needle.positions.iter_mut().for_each(|[x, ..]| *x *= 1e-4);
    let (texels, _) = read(&[("a.glb", &needle.bytes())], 8, &View::default());
    let is_small = |texels: &Texels| texels.pixels.iter().all(|pixel| pixel.coverage < 1.0);
    assert!(texels.as_ref().map_or_else(|error| error.contains("nothing of it"), is_small));
}

/// Numbers that are none, or out of range: one line that says where.
#[test]
fn factors_that_are_not_numbers() {
    for (material, expected) in [
        (r#""pbrMetallicRoughness":{"metallicFactor":1e999}"#, "not a complete glTF file"),
        (r#""pbrMetallicRoughness":{"roughnessFactor":NaN}"#, "not a complete glTF file"),
        (r#""pbrMetallicRoughness":{"roughnessFactor":-0.1}"#, "a factor of -0.1"),
        (r#""pbrMetallicRoughness":{"baseColorFactor":[1,2,0,1]}"#, "a factor of 2"),
        (r#""occlusionTexture":{"index":0,"strength":7}"#, "an occlusion strength of 7"),
        (r#""normalTexture":{"index":0,"scale":1e39}"#, "not a complete glTF file"),
    ] {
        let glb = square(material, vec![png([2, 2], |_, _| [128, 128, 255, 255])]);
        let (error, _) = read(&[("a.glb", &glb.bytes())], 9, &View::default());
        let error = error.expect_err(material);
        assert!(error.contains(expected) && error.lines().count() == 1, "{error}");
    }
    for color in [f32::NAN, f32::INFINITY] {
        let glb = Glb { colors: vec![[0.5, color, 0.5, 1.0]; 4], ..Glb::square() };
        let (error, _) = read(&[("a.glb", &glb.bytes())], 9, &View::default());
        let error = error.expect_err("a color");
        assert!(error.contains("the color of a corner is not finite"), "{error}");
    }
}

/// Textures without a mesh.
#[test]
fn maps_without_a_mesh() {
    let mut glb = square(TILTED, vec![png([2, 2], |_, _| [128, 128, 255, 255])]);
    glb.primitive = r#","mode":0"#.to_owned();
    let (error, warning) = read(&[("a.glb", &glb.bytes())], 9, &View::default());
    let error = error.expect_err("no mesh");
    assert!(error.contains("it contains no triangle"), "{error} {warning}");
}

/// Every share of metal between 0 and 1 has f0 between those of the two.
#[test]
fn metallic_between_0_and_1() {
    for metallic in [0.0_f32, 0.25, 0.5, 0.9, 1.0] {
        let material = format!(
            r#""pbrMetallicRoughness":{{"baseColorFactor":[0.8,0.4,0,1],"metallicFactor":{metallic}}}"#
        );
        let texel = at(&drawn(&square(&material, Vec::new()), 9), 4, 4).expect("a texel");
        for (c, base) in [0.8_f32, 0.4, 0.0].into_iter().enumerate() {
            let f0 = 0.04 * (1.0 - metallic) + base * metallic;
            let matte = base * (1.0 - metallic) * (1.0 - f0);
            assert!((texel.reflectance[c] - f0).abs() < 1e-6, "{texel:?}");
            assert!((texel.matte[c] - matte).abs() < 1e-6, "{texel:?}");
        }
    }
}
