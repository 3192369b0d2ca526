//! Files that describe objects, images to read, and tables of objects.

use super::{DEGREE, Folder, ORDER, lights, materials, noise, rows, scene};
use eigenshade_testing::fixtures;
use png::{BitDepth, ColorType, Encoder};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;
use std::path::Path;
use std::sync::OnceLock;

/// The small scene with another `[geometry]`, every component.
pub fn with_geometry(geometry: &str) -> String {
    let text = scene("image-centered", 10_000, "[]");
    text.replace("normals = \"sphere\"\n", geometry)
}

/// A folder with these files and the table of this scene.
pub fn built(scene: &str, files: &[(&str, Vec<u8>)]) -> Folder {
    let folder = Folder::new();
    for (name, bytes) in files {
        folder.write(name, bytes);
    }
    folder.write("scene.toml", scene);
    folder.ok("basis --scene scene.toml --out b.bin");
    folder
}

/// A folder with the table of this geometry.
pub fn table(geometry: &str, files: &[(&str, Vec<u8>)]) -> Folder {
    built(&with_geometry(geometry), files)
}

/// The eigenvalues, without the empty one of the constant.
pub fn eigenvalues(folder: &Folder) -> Vec<f64> {
    let text = folder.ok("eigenvalues --table b.bin");
    let rows = rows(&text, "criterion,index,m,eigenvalue");
    rows[1..].iter().map(|row| row[3].parse().expect("a number")).collect()
}

/// An ellipsoid: corners, and triangles counterclockwise seen from outside.
pub fn ellipsoid() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (rings, around) = (24, 48);
    let mut corners = Vec::new();
    for ring in 0..=rings {
        let (sine, cosine) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        for k in 0..around {
            let (y, x) = (TAU * f64::from(k) / f64::from(around)).sin_cos();
            corners.push([sine * x, 0.7 * sine * y, 1.3 * cosine]);
        }
    }
    let mut triangles = Vec::new();
    let at = |ring: i32, k: i32| (ring * around + k % around) as usize;
    for ring in 0..rings {
        for k in 0..around {
            let (a, b) = (at(ring, k), at(ring, k + 1));
            let (c, d) = (at(ring + 1, k), at(ring + 1, k + 1));
            // Those at the poles have no area.
            triangles.extend([[a, c, b], [b, c, d]]);
        }
    }
    (corners, triangles)
}

pub fn obj() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = String::new();
    for [x, y, z] in corners {
        writeln!(text, "v {x} {y} {z}").expect("text");
    }
    for [a, b, c] in triangles {
        writeln!(text, "f {} {} {}", a + 1, b + 1, c + 1).expect("text");
    }
    text
}

pub fn ply() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = format!(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n\
         property double z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
        corners.len(),
        triangles.len()
    );
    for [x, y, z] in corners {
        writeln!(text, "{x} {y} {z}").expect("text");
    }
    for [a, b, c] in triangles {
        writeln!(text, "3 {a} {b} {c}").expect("text");
    }
    text
}

pub fn stl() -> Vec<u8> {
    let (corners, triangles) = ellipsoid();
    let mut bytes = vec![0; 80];
    bytes.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        bytes.extend([0; 12]);
        for corner in triangle {
            bytes.extend(corners[corner].iter().flat_map(|&x| (x as f32).to_le_bytes()));
        }
        bytes.extend([0; 2]);
    }
    bytes
}

/// Facets that face the camera less than this, of numbers of order one, are seen edge on, but
/// for rounding.
const EDGE_ON: f64 = 1e-12;

/// The facets of the ellipsoid, as a list of normals with weights.
pub fn facets() -> String {
    let (corners, triangles) = ellipsoid();
    let mut text = "x,y,z,weight\n".to_owned();
    for [a, b, c] in triangles {
        let [a, b, c] = [corners[a], corners[b], corners[c]];
        let (u, v) = ([0, 1, 2].map(|k| b[k] - a[k]), [0, 1, 2].map(|k| c[k] - a[k]));
        let cross = |i: usize, j: usize| u[i] * v[j] - u[j] * v[i];
        let (x, y, z) = (cross(1, 2), cross(2, 0), cross(0, 1));
        if z > EDGE_ON {
            writeln!(text, "{x},{y},{z},{z}").expect("text");
        }
    }
    text
}

/// A disc of a sphere's normals, a pixel each.
pub fn normal_map(bits: png::BitDepth) -> Vec<u8> {
    let size = 64;
    let mut samples = Vec::new();
    for row in 0..size {
        for column in 0..size {
            let at = |k: usize| (k as f64 + 0.5) / size as f64 * 2.0 - 1.0;
            let (x, y) = (at(column), -at(row));
            let square = 1.0 - x * x - y * y;
            let alpha = if square > 0.0 { 1.0 } else { 0.0 };
            let z = square.max(0.0).sqrt();
            samples.extend([(x + 1.0) / 2.0, (y + 1.0) / 2.0, (z + 1.0) / 2.0, alpha]);
        }
    }
    square_png(size, png::ColorType::Rgba, bits, &samples)
}

pub fn square_png(size: usize, color: ColorType, bits: BitDepth, samples: &[f64]) -> Vec<u8> {
    let data: Vec<u8> = match bits {
        BitDepth::Sixteen => {
            let fragment = |value: &f64| ((value * 65_535.0).round() as u16).to_be_bytes();
            samples.iter().flat_map(fragment).collect()
        }
        _ => samples.iter().map(|value| (value * 255.0).round() as u8).collect(),
    };
    png(size, size, bits, color, &data)
}

const HEADER: &str = "quantity,name,index,r,g,b";

/// The numbers of an answer of `read`, by quantity and name.
pub type Answer = HashMap<(String, String), Vec<[f64; 3]>>;

/// The numbers of an answer of `read` by quantity and name, in the order of the index.
pub fn answer(text: &str) -> Answer {
    let mut found = Answer::new();
    for row in rows(text, HEADER) {
        let rgb = [3, 4, 5].map(|field| row[field].parse::<f64>().expect("a number"));
        assert!(rgb.iter().all(|value| value.is_finite()), "{row:?}");
        let list = found.entry((row[0].clone(), row[1].clone())).or_default();
        if row[0].starts_with("material-") {
            // The index is the place among the materials.
            list.push([row[2].parse().unwrap(), rgb[0], rgb[1]]);
        } else {
            assert_eq!(row[2], list.len().to_string(), "{row:?}");
            list.push(rgb);
        }
    }
    found
}

pub fn get<'a>(answer: &'a Answer, quantity: &str, name: &str) -> &'a [[f64; 3]] {
    &answer[&(quantity.to_owned(), name.to_owned())]
}

/// The nearest material.
pub fn nearest(answer: &Answer) -> &str {
    let first = |((quantity, _), list): &(&(String, String), &Vec<[f64; 3]>)| {
        quantity == "material-evidence" && list[0][0] == 0.0
    };
    &answer.iter().find(first).expect("a first material").0.1
}

pub fn png(
    width: usize,
    height: usize,
    depth: BitDepth,
    color: ColorType,
    bytes: &[u8],
) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width as u32, height as u32);
    encoder.set_depth(depth);
    encoder.set_color(color);
    encoder.write_header().unwrap().write_image_data(bytes).unwrap();
    file
}

/// The width, the colors and the bytes of a PNG file.
pub fn decoded(path: &Path) -> (u32, ColorType, Vec<u8>) {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut bytes).unwrap();
    (info.width, info.color_type, bytes)
}

/// A PNG whose header claims another size, with a correct checksum.
pub fn claims(mut bytes: Vec<u8>, width: u32, height: u32) -> Vec<u8> {
    bytes[16..20].copy_from_slice(&width.to_be_bytes());
    bytes[20..24].copy_from_slice(&height.to_be_bytes());
    let crc = !bytes[12..29].iter().fold(u32::MAX, |crc, byte| {
        (0..8).fold(crc ^ u32::from(*byte), |crc, _| (crc >> 1) ^ (0xedb8_8320 * (crc & 1)))
    });
    bytes[29..33].copy_from_slice(&crc.to_be_bytes());
    bytes
}

/// A folder with the small table of all components, 400 normals, and `image.csv`, the image of one
/// colored light on the third material.
pub fn with_image() -> Folder {
    static IMAGE: OnceLock<String> = OnceLock::new();
    let folder = Folder::with_table();
    folder.write("light.csv", lights(DEGREE, 1));
    let all = materials(ORDER, 4);
    let one: String = all
        .lines()
        .filter(|line| !line.starts_with("material-") || line.starts_with("material-2,"))
        .map(|line| format!("{line}\n"))
        .collect();
    folder.write("material.csv", one);
    let (mut text, mut noise) = ("x,y,z\n".to_owned(), noise(5));
    for _ in 0..400 {
        writeln!(text, "{},{},{}", noise(), noise(), noise().abs()).unwrap();
    }
    folder.write("normals.csv", text);
    let pair = "--light light.csv --material material.csv --normals normals.csv";
    let image = || folder.ok(&format!("shade --table b.bin {pair} --format f64"));
    folder.write("image.csv", IMAGE.get_or_init(image));
    folder
}

/// Reads that image.
pub const READ: &str = "read image.csv --normals normals.csv --table b.bin";

/// A map in the portable float format, 8 x 4, of one gray.
pub fn map(value: f32) -> Vec<u8> {
    fixtures::pfm(8, &[[value; 3]; 8 * 4])
}
