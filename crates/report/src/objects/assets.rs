//! Objects made for measurements, with textures of their own.

use eigenshade_cli::picture::{Canvas, TextHeight};
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType, Encoder};
use std::f64::consts::{PI, TAU};

/// The objects, with their names. Their roughness is at least 0.3.
pub fn all() -> Vec<(&'static str, Glb)> {
    vec![
        ("sphere", sphere()),
        ("bumps", bumps()),
        ("dial", dial()),
        ("coin", coin()),
        ("helmet", helmet()),
        ("scan", scan()),
    ]
}

/// A PNG whose pixels at (u, v), 0 to 1 and v down, have these shares of red, green, blue and
/// opacity.
fn png(size: usize, of: impl Fn(f64, f64) -> [f64; 4]) -> Vec<u8> {
    let at = |k: usize| (k as f64 + 0.5) / size as f64;
    let pixels = (0..size * size).flat_map(|k| of(at(k % size), at(k / size)));
    let bytes: Vec<u8> = pixels.map(|share| (255.0 * share).round() as u8).collect();
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, size as u32, size as u32);
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&bytes).expect("pixels");
    writer.finish().expect("an end");
    file
}

/// A normal map of a height, whose unit is the width of the map; u to the right, v down.
fn normal_map(size: usize, height: impl Fn(f64, f64) -> f64) -> Vec<u8> {
    let step = 0.5 / size as f64;
    png(size, |u, v| {
        let x = (height(u - step, v) - height(u + step, v)) / (2.0 * step);
        let y = (height(u, v + step) - height(u, v - step)) / (2.0 * step);
        let length = (1.0 + x * x + y * y).sqrt();
        let [x, y, z] = [x, y, 1.0].map(|c| 0.5 + 0.5 * c / length);
        [x, y, z, 1.0]
    })
}

const COLOR: &str = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":1}}"#;
const NORMALS: &str = r#","normalTexture":{"index":2}"#;

fn checkers(u: f64, v: f64) -> bool {
    ((8.0 * u).floor() + (4.0 * v).floor()) % 2.0 > 0.0
}

/// Checkers of metal and enamel, rougher downward.
fn sphere() -> Glb {
    let colors = png(128, |u, v| match checkers(u, v) {
        true => [0.9, 0.7, 0.4, 1.0],
        false => [0.2, 0.3, 0.7, 1.0],
    });
    let numbers = png(128, |u, v| [0.0, 0.31 + 0.69 * v, f64::from(u8::from(checkers(u, v))), 1.0]);
    Glb { material: COLOR.to_owned(), images: vec![colors, numbers], ..Glb::sphere(32) }
}

/// The same, with bumps that are near the size of a pixel.
fn bumps() -> Glb {
    let mut glb = sphere();
    let wave = |c: f64| (TAU * 32.0 * c).sin() / (TAU * 32.0);
    glb.images.push(normal_map(512, |u, v| 0.3 * (wave(u) + wave(v))));
    Glb { material: format!("{COLOR}{NORMALS}"), ..glb }
}

/// A surface of revolution about z that faces +z, from its radii and heights. The texture is its
/// view from +z.
fn lathe(profile: &[[f64; 2]]) -> Glb {
    let columns = 96;
    let mut glb = Glb { normals: Vec::new(), ..Glb::square() };
    (glb.positions, glb.coordinates, glb.indices) = (Vec::new(), Vec::new(), Vec::new());
    for [radius, height] in profile {
        for column in 0..columns {
            let (y, x) = (TAU * f64::from(column) / f64::from(columns)).sin_cos();
            let [x, y] = [x, y].map(|c| radius * c);
            glb.positions.push([x, y, *height].map(|c| c as f32));
            glb.coordinates.push([0.5 + 0.5 * x, 0.5 - 0.5 * y].map(|c| c as f32));
        }
    }
    for ring in 0..profile.len() as u32 - 1 {
        for column in 0..columns {
            let at = |ring: u32, column: u32| ring * columns + column % columns;
            let [a, b] = [at(ring, column), at(ring + 1, column)];
            let [c, d] = [at(ring + 1, column + 1), at(ring, column + 1)];
            glb.indices.extend([a, b, c, a, c, d]);
        }
    }
    glb
}

/// A brushed metal dial with painted numerals, inclined.
fn dial() -> Glb {
    const SIDE: usize = 256;
    let mut canvas = Canvas::new(SIDE, SIDE, [0; 3]);
    for hour in 1..=12 {
        let (x, y) = (PI * f64::from(hour) / 6.0).sin_cos();
        let [x, y] = [x, -y].map(|c| (128.0 + 92.0 * c) as usize);
        canvas.centered_text((x, y - 16), TextHeight::Size32, [255; 3], &hour.to_string());
    }
    let paint = |u: f64, v: f64| {
        let radius = (u - 0.5).hypot(v - 0.5);
        let ring = if (0.455..0.475).contains(&radius) { 1.0 } else { 0.0 };
        let [column, row] = [u, v].map(|c| (c * SIDE as f64) as usize);
        f64::from(canvas.bytes[3 * (row * SIDE + column)]).max(255.0 * ring) / 255.0
    };
    let mixed = |a: f64, b: f64, share: f64| a + (b - a) * share;
    let colors = png(SIDE, |u, v| {
        let share = paint(u, v);
        [mixed(0.85, 0.05, share), mixed(0.8, 0.06, share), mixed(0.75, 0.2, share), 1.0]
    });
    let numbers = png(SIDE, |u, v| [0.0, mixed(0.4, 0.8, paint(u, v)), 1.0 - paint(u, v), 1.0]);
    let brushed = |u: f64, v: f64| {
        let radius = (u - 0.5).hypot(v - 0.5);
        0.1 * (TAU * 100.0 * radius).sin() / (TAU * 100.0)
    };
    Glb {
        material: format!("{COLOR}{NORMALS}"),
        images: vec![colors, numbers, normal_map(SIDE, brushed)],
        node: r#","rotation":[-0.22,0.12,0,0.968]"#.to_owned(),
        ..lathe(&[[0.0, 0.0], [0.5, 0.0], [0.95, 0.0], [0.98, -0.02], [1.0, -0.06]])
    }
}

/// A gold coin with a numeral in relief and a beaded edge, inclined.
fn coin() -> Glb {
    const SIDE: usize = 256;
    let mut canvas = Canvas::new(64, 64, [0; 3]);
    canvas.centered_text((32, 16), TextHeight::Size32, [255; 3], "5");
    let ink = |u: f64, v: f64| {
        let [column, row] = [u, v].map(|c| (64.0 * c).clamp(0.0, 63.0) as usize);
        f64::from(canvas.bytes[3 * (row * 64 + column)]) / 255.0
    };
    // Mean over some pixels, for soft edges.
    let soft = |u: f64, v: f64| {
        let steps = || (-4..=4).map(|k| f64::from(k) / 256.0);
        steps().flat_map(|x| steps().map(move |y| ink(u + x, v + y))).sum::<f64>() / 81.0
    };
    let relief = |u: f64, v: f64| {
        let [x, y] = [u - 0.5, v - 0.5];
        let (radius, angle) = (x.hypot(y), y.atan2(x));
        let bead =
            ((36.0 * angle).cos() + 1.0) * (1.0 - ((radius - 0.42) / 0.025).powi(2)).max(0.0);
        0.02 * soft(u, v) + 0.004 * bead
    };
    Glb {
        material: r#""pbrMetallicRoughness":{"baseColorFactor":[1,0.71,0.29,1],"metallicFactor":1,"roughnessFactor":0.35},"normalTexture":{"index":0}"#.to_owned(),
        images: vec![normal_map(SIDE, relief)],
        node: r#","rotation":[-0.25,-0.15,0,0.956]"#.to_owned(),
        ..lathe(&[
            [0.0, 0.0],
            [0.5, 0.0],
            [0.9, 0.0],
            [0.92, 0.025],
            [0.98, 0.025],
            [1.0, 0.0],
            [1.0, -0.15],
        ])
    }
}

/// A painted shell with an opening, rivets and dark folds, which shows its inside.
fn helmet() -> Glb {
    let is_open = |u: f64, v: f64| (u - 0.25).abs() < 0.13 && (0.38..0.48).contains(&v);
    let stripe = |u: f64| (u - 0.25).abs() < 0.02;
    let colors = png(512, |u, v| {
        let [r, g, b] = if stripe(u) { [0.95, 0.9, 0.8] } else { [0.7, 0.12, 0.1] };
        [r, g, b, if is_open(u, v) { 0.0 } else { 1.0 }]
    });
    // Occlusion in red, roughness in green.
    let numbers = png(512, |u, v| {
        let fold = 1.0 - 0.6 * (1.0 - ((v - 0.5) / 0.06).powi(2)).max(0.0);
        [fold, if stripe(u) { 0.6 } else { 0.35 }, 0.0, 1.0]
    });
    let rivet = |u: f64, v: f64| {
        let [x, y] = [(24.0 * u).fract() - 0.5, 12.0 * (v - 0.53)];
        0.02 * (1.0 - (x * x + y * y) / 0.04).max(0.0) / 12.0
    };
    let sphere = Glb::sphere(40);
    let whole = sphere.indices.len() / 40 * 23;
    Glb {
        material: format!(
            r#"{COLOR}{NORMALS},"occlusionTexture":{{"index":1}},"alphaMode":"MASK","doubleSided":true"#
        ),
        images: vec![colors, numbers, normal_map(512, rivet)],
        node: r#","rotation":[0.12,0.2,0,0.972],"scale":[1,1.15,1]"#.to_owned(),
        indices: sphere.indices[..whole].to_vec(),
        ..sphere
    }
}

/// A lumpy stone with colors at its corners and without normals, as scanners make them.
fn scan() -> Glb {
    let mut glb = Glb::sphere(48);
    glb.normals.clear();
    glb.coordinates.clear();
    for at in &mut glb.positions {
        let [x, y, z] = at.map(f64::from);
        let lumps = (5.0 * x + 1.0).sin() + (6.0 * y + 2.0).sin() + (7.0 * z).sin();
        let stain = (11.0 * x).sin() * (9.0 * y + 1.0).sin() * (10.0 * z + 2.0).sin();
        let [r, g, b] = [0.4, 0.3, 0.22].map(|c| c * (1.0 + 0.8 * stain));
        glb.colors.push([r, g, b, 1.0].map(|c| c as f32));
        *at = [x, 0.8 * y, z].map(|c| (c * (1.0 + 0.06 * lumps)) as f32);
    }
    let material = r#""pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.55}"#;
    Glb { material: material.to_owned(), ..glb }
}
