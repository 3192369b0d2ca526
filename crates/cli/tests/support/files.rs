//! Files that describe objects, and images to read.

use super::{BASIS, DEGREE, Folder, ORDER, lights, materials, normals, numbers, rows};
use eigenshade_testing::fixtures;
use png::{BitDepth, ColorType, Encoder};
use std::collections::HashMap;
use std::f64::consts::{PI, TAU};
use std::path::Path;
use std::sync::OnceLock;

/// A folder with these files and the table of this scene.
pub fn built(scene: &str, files: &[(&str, Vec<u8>)]) -> Folder {
    let folder = Folder::new();
    for (name, bytes) in files {
        folder.write(name, bytes);
    }
    folder.write("scene.toml", scene);
    folder.ok(BASIS);
    folder
}

/// The eigenvalues, without the empty one of the constant.
pub fn eigenvalues(folder: &Folder) -> Vec<f64> {
    let text = folder.ok("eigenvalues --table b.bin");
    numbers(&rows(&text, "criterion,index,m,eigenvalue")[1..], 1)
}

/// An ellipsoid: corners, and triangles counterclockwise seen from outside.
pub fn ellipsoid() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let (rings, around) = (24, 48);
    let places = |rings: i32| (0..rings).flat_map(move |ring| (0..around).map(move |k| (ring, k)));
    let corner = |(ring, k): (i32, i32)| {
        let (sine, cosine) = (PI * f64::from(ring) / f64::from(rings)).sin_cos();
        let (y, x) = (TAU * f64::from(k) / f64::from(around)).sin_cos();
        [sine * x, 0.7 * sine * y, 1.3 * cosine]
    };
    let facets = |(ring, k): (i32, i32)| {
        let at = |ring: i32, k: i32| (ring * around + k % around) as usize;
        let (a, b) = (at(ring, k), at(ring, k + 1));
        let (c, d) = (at(ring + 1, k), at(ring + 1, k + 1));
        // Those at the poles have no area.
        [[a, c, b], [b, c, d]]
    };
    (places(rings + 1).map(corner).collect(), places(rings).flat_map(facets).collect())
}

pub fn obj() -> String {
    let (corners, triangles) = ellipsoid();
    let corners = corners.iter().map(|[x, y, z]| format!("v {x} {y} {z}\n"));
    let faces = triangles.iter().map(|[a, b, c]| format!("f {} {} {}\n", a + 1, b + 1, c + 1));
    corners.chain(faces).collect()
}

/// The header of a polygon file: its format, the number of corners and the type of their
/// coordinates, the number of faces and the types of their lists.
pub fn ply_header(format: &str, corners: &str, number: &str, faces: usize, list: &str) -> String {
    format!(
        "ply\nformat {format} 1.0\nelement vertex {corners}\nproperty {number} x\n\
         property {number} y\nproperty {number} z\nelement face {faces}\n\
         property list {list} vertex_indices\nend_header\n"
    )
}

pub fn ply() -> String {
    let (corners, triangles) = ellipsoid();
    let count = corners.len().to_string();
    let header = ply_header("ascii", &count, "double", triangles.len(), "uchar int");
    let corners = corners.iter().map(|[x, y, z]| format!("{x} {y} {z}\n"));
    let faces = triangles.iter().map(|[a, b, c]| format!("3 {a} {b} {c}\n"));
    std::iter::once(header).chain(corners).chain(faces).collect()
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

/// A disc of a sphere's normals, a pixel each.
pub fn normal_map(bits: BitDepth) -> Vec<u8> {
    let size = 64;
    let at = |k: usize| (k as f64 + 0.5) / size as f64 * 2.0 - 1.0;
    let pixel = |k: usize| {
        let (x, y) = (at(k % size), -at(k / size));
        let square = 1.0 - x * x - y * y;
        let alpha = if square > 0.0 { 1.0 } else { 0.0 };
        let z = square.max(0.0).sqrt();
        [(x + 1.0) / 2.0, (y + 1.0) / 2.0, (z + 1.0) / 2.0, alpha]
    };
    let samples: Vec<f64> = (0..size * size).flat_map(pixel).collect();
    square_png(size, ColorType::Rgba, bits, &samples)
}

pub fn square_png(size: usize, color: ColorType, bits: BitDepth, samples: &[f64]) -> Vec<u8> {
    let data: Vec<u8> = match bits {
        BitDepth::Sixteen => {
            let fragment = |value: &f64| ((value * 65_535.0).round() as u16).to_be_bytes();
            samples.iter().flat_map(fragment).collect()
        }
        _ => samples.iter().map(|value| (value * 255.0).round() as u8).collect(),
    };
    png([size as u32; 2], bits, color, &data)
}

/// The numbers of an answer of `read`, by quantity and name.
pub type Answer = HashMap<(String, String), Vec<[f64; 3]>>;

/// The numbers of an answer of `read` by quantity and name, in the order of the index.
pub fn answer(text: &str) -> Answer {
    let mut found = Answer::new();
    for row in rows(text, "quantity,name,index,r,g,b") {
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

/// A gray PNG of 8 bits.
pub fn gray_png(width: u32, height: u32, bytes: &[u8]) -> Vec<u8> {
    png([width, height], BitDepth::Eight, ColorType::Grayscale, bytes)
}

pub fn png([width, height]: [u32; 2], bits: BitDepth, color: ColorType, bytes: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, width, height);
    encoder.set_depth(bits);
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

/// The third material of the small scene.
pub fn third_material() -> String {
    let all = materials(ORDER, 4);
    let keep = |line: &&str| line.starts_with("name,") || line.starts_with("material-2,");
    all.lines().filter(keep).map(|line| format!("{line}\n")).collect()
}

/// A folder with the small table of all components, 400 normals, and `image.csv`, the image of one
/// colored light on the third material.
pub fn with_image() -> Folder {
    static IMAGE: OnceLock<String> = OnceLock::new();
    let folder = Folder::with_table();
    folder.write("light.csv", lights(DEGREE, 1));
    folder.write("material.csv", third_material());
    folder.write("normals.csv", normals("", 5, 400));
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
