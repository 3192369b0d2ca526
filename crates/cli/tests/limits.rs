//! Files that are larger than their readers take, and tables, pictures and exports that would be
//! too large: one line, before anything is written.
#![cfg(unix)]

use crate::PROGRAM;
use crate::support::files::{ply_header, square_png};
use crate::support::{BASIS, Folder, NEW_BASIS, PAIR, SHADE, assert_fails, stderr};
use eigenshade_generator::basis::estimate::Estimate;
use eigenshade_generator::scene_file;
use png::{BitDepth, ColorType, Compression, Encoder};
use std::fs::File;
use std::io::Write;

/// A white PNG of this width and height.
fn white_png(size: u32) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, size, size);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    let mut writer = encoder.write_header().expect("a header");
    let mut stream = writer.stream_writer().expect("a stream");
    let row = vec![255u8; 3 * size as usize];
    for _ in 0..size {
        stream.write_all(&row).expect("a row");
    }
    stream.finish().expect("an end");
    writer.finish().expect("an end");
    bytes
}

#[test]
fn pngs_that_expand() {
    let folder = Folder::with_table();
    let bomb = white_png(8192);
    assert!(bomb.len() < 300_000, "{}", bomb.len());
    folder.write("bomb.png", &bomb);
    let small = square_png(8, ColorType::Rgb, BitDepth::Eight, &[0.6; 192]);
    folder.write("small.png", &small);
    let expected = ["bomb.png: it has 67108864 pixels, too many to read; give at most 33554432"];
    let render = "render --light lobby --material chrome --normals bomb.png --out new.png";
    assert_fails(&folder, render, &expected);
    for (image, options) in [
        ("bomb.png", "--normals sphere"),
        ("small.png", "--normals bomb.png"),
        ("small.png", "--normals sphere --mask bomb.png"),
    ] {
        let arguments = format!("read {image} --table b.bin {PAIR} {options} --out new.csv");
        assert_fails(&folder, &arguments, &expected);
    }
}

/// Runs of 127 in rows of their components. The first rows suffice: what is claimed is refused
/// before any is read.
#[test]
fn hdr_of_run_lengths() {
    let folder = Folder::new();
    for (height, expected) in [
        (8192, "it is broken or cut short (row 192"),
        (8292, "it is 16256 x 8292 pixels, too many"),
    ] {
        let width = 127 * 128;
        let mut bytes = format!("#?RADIANCE\n\n-Y {height} +X {width}\n").into_bytes();
        for _ in 0..192 {
            bytes.extend([2, 2, (width >> 8) as u8, (width & 255) as u8]);
            bytes.extend([255u8, 1].repeat(4 * 128));
        }
        folder.write("bomb.hdr", bytes);
        assert_fails(&folder, "light bomb.hdr --degree 2 --out new.csv", &["bomb.hdr", expected]);
    }
}

/// The header of a gray map with compressed blocks of 16 lines or as one tile, and their places.
fn exr(width: u32, height: u32, is_tile: bool) -> Vec<u8> {
    let window = [0, 0, width as i32 - 1, height as i32 - 1].map(i32::to_le_bytes).concat();
    let mut bytes = vec![0x76, 0x2f, 0x31, 0x01, 2, if is_tile { 2 } else { 0 }, 0, 0];
    // Its name, its type f32, flags, and the steps between samples.
    let channel = [b"Y\0".as_slice(), &[2, 0, 0, 0], &[0; 4], &[1, 0, 0, 0], &[1, 0, 0, 0], &[0]];
    let mut attributes = vec![
        ("channels\0chlist\0", channel.concat()),
        ("compression\0compression\0", vec![3]),
        ("dataWindow\0box2i\0", window.clone()),
        ("displayWindow\0box2i\0", window),
        ("lineOrder\0lineOrder\0", vec![0]),
        ("pixelAspectRatio\0float\0", 1f32.to_le_bytes().to_vec()),
        ("screenWindowCenter\0v2f\0", vec![0; 8]),
        ("screenWindowWidth\0float\0", 1f32.to_le_bytes().to_vec()),
    ];
    if is_tile {
        let whole = [&width.to_le_bytes()[..], &height.to_le_bytes(), &[0]].concat();
        attributes.push(("tiles\0tiledesc\0", whole));
    }
    for (name_and_kind, value) in attributes {
        bytes.extend(name_and_kind.as_bytes());
        bytes.extend((value.len() as u32).to_le_bytes());
        bytes.extend(value);
    }
    bytes.push(0);
    bytes.extend(vec![0; if is_tile { 8 } else { height as usize / 2 }]);
    bytes.resize(bytes.len() + (1 << 20), 0);
    bytes
}

#[test]
fn exr_of_packed_blocks() {
    let folder = Folder::new();
    for (bytes, expected) in [
        (exr(32_768, 16_384, false), "it is 32768 x 16384 pixels, too many to read"),
        (exr(16_384, 8192, true), "a block of it has 536870912 bytes"),
    ] {
        folder.write("bomb.exr", bytes);
        assert_fails(&folder, "light bomb.exr --degree 2 --out new.csv", &["bomb.exr: ", expected]);
    }
}

/// Polygons with many corners, each a fan of as many triangles.
#[test]
fn meshes_of_many_facets() {
    let folder = Folder::new();
    let (polygons, corners) = (20_000, 255);
    let header = ply_header("binary_little_endian", "3", "uchar", polygons, "uchar uchar");
    let mut ply = header.into_bytes();
    ply.extend([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    let fan: Vec<u8> = std::iter::once(corners).chain([0, 1, 2].repeat(85)).collect();
    ply.extend(fan.repeat(polygons));
    folder.write("fans.ply", ply);
    let faces = format!("f{}\n", " 1 2 3".repeat(100)).repeat(15_000);
    folder.write("fans.obj", format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}"));
    // A file with a hole takes no room.
    let facets = 5_000_000u32;
    let header = [vec![0; 80], facets.to_le_bytes().to_vec()].concat();
    let path = folder.write("many.stl", header);
    let file = File::options().write(true).open(path).expect("a file");
    file.set_len(84 + 50 * u64::from(facets)).expect("room");
    for name in ["fans.ply", "fans.obj", "many.stl"] {
        let render =
            format!("render --light lobby --material chrome --normals {name} --out new.png");
        assert_fails(&folder, &render, &[name, "too many to read; give at most 4194304"]);
    }
}

#[test]
fn csv_of_short_rows() {
    let folder = Folder::with_table();
    folder.write("normals.csv", format!("x,y,z\n{}", "0,0,1\n".repeat(3_000_000)));
    assert_fails(&folder, &format!("{SHADE} --out new.csv"), &["normals.csv", "3000002 rows"]);
    folder.write("normals.csv", format!("x,y,z\n{}\n", ",".repeat(1 << 25)));
    assert_fails(&folder, &format!("{SHADE} --out new.csv"), &["normals.csv", "fields, too many"]);
}

/// Whatever its kind.
#[test]
fn files_of_many_bytes() {
    let folder = Folder::with_table();
    for name in ["b.bin", "lights.csv"] {
        let file = File::options().write(true).open(folder.path(name)).expect("a file");
        file.set_len((512 << 20) + 1).expect("room");
        let project = format!("project -t b.bin {PAIR} --out new.csv");
        assert_fails(&folder, &project, &[name, "it has 536870913 bytes, too many to read"]);
        folder.write(name, Folder::with_table().bytes(name));
    }
}

#[test]
fn tables_that_are_too_large() {
    let folder = Folder::of_size(64, 64, [1, 1]);
    let expected = ["scene.toml: a table of degree 64, order 64 needs", "reduce the degree"];
    assert_fails(&folder, NEW_BASIS, &expected);
}

/// The estimated memory is enough.
#[test]
fn a_table_takes_what_was_estimated() {
    let folder = Folder::of_size(20, 20, [2, 2]);
    folder.write("scene.toml", folder.read("scene.toml") + "rank_cutoff = 1e-10\n");
    let loaded = scene_file::load(folder.path("scene.toml")).expect("a scene");
    // The program itself, and the address space of two threads.
    let own = 300 << 20;
    let kibibytes = (Estimate::of(&loaded).bytes + own) >> 10;
    let output = folder.shell(&format!("ulimit -v {kibibytes}; exec '{PROGRAM}' {BASIS}"));
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
}
