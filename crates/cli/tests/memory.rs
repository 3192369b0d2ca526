//! Small files that claim a large size, and large scenes: refused in seconds, before memory is
//! allocated, also under a limit of the operating system.
#![cfg(unix)]

use crate::PROGRAM;
use crate::support::files::{ply_header, square_png, with_geometry};
use crate::support::{BASIS, Folder, NEW_BASIS, PAIR, SHADE, assert_contains, error_line, stderr};
use png::{BitDepth, ColorType, Compression, Encoder};
use std::io::Write;
use std::process::Output;

/// The address space of the program in KiB.
const LIMIT: u64 = 500_000;

/// Seconds of processor time after which the program is ended.
const SECONDS: u64 = 10;

/// Runs the program in this folder, limited to [`SECONDS`] and to this address space in KiB.
fn limited(folder: &Folder, arguments: &str, kibibytes: u64) -> Output {
    let limits = format!("ulimit -t {SECONDS} && ulimit -v {kibibytes}");
    folder.shell(&format!("{limits} && exec '{PROGRAM}' {arguments}"))
}

/// Asserts status 1 and one line with the memory that is needed, the limit and how to raise it, and
/// that nothing is written.
fn assert_refused(folder: &Folder, arguments: &str, fragments: &[&str]) {
    let before = folder.names();
    let line = error_line(&limited(folder, arguments, LIMIT));
    assert_contains(&line, &["needs", "the budget is", "--memory"]);
    assert_contains(&line, fragments);
    assert_eq!(folder.names(), before, "{arguments}");
}

/// Asserts that this address space in KiB is enough.
fn assert_enough(folder: &Folder, arguments: &str, kibibytes: u64) {
    let output = limited(folder, arguments, kibibytes);
    assert_eq!(output.status.code(), Some(0), "{arguments}: {}", stderr(&output));
}

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
    for geometry in ["normals = \"bomb.png\"\n", "normals = \"small.png\"\nmask = \"bomb.png\"\n"] {
        folder.write("scene.toml", with_geometry(geometry));
        assert_refused(&folder, NEW_BASIS, &["8192 x 8192"]);
    }
    for (image, options) in [
        ("bomb.png", "--normals sphere"),
        ("small.png", "--normals bomb.png"),
        ("small.png", "--normals sphere --mask bomb.png"),
    ] {
        let arguments = format!("read {image} --table b.bin {PAIR} {options} --out new.csv");
        assert_refused(&folder, &arguments, &["bomb.png", "8192 x 8192"]);
    }
}

/// Runs of 127 in rows of their components.
#[test]
fn hdr_of_run_lengths() {
    let folder = Folder::new();
    let (width, height) = (127 * 128, 4096);
    let mut bytes = format!("#?RADIANCE\n\n-Y {height} +X {width}\n").into_bytes();
    let row: Vec<u8> = [255, 1].repeat(4 * 128);
    for row_number in 0..height {
        bytes.extend([2, 2, (width >> 8) as u8, (width & 255) as u8]);
        // The first rows suffice: what is claimed is refused before any is read.
        if row_number < 192 {
            bytes.extend(&row);
        }
    }
    assert!(bytes.len() < 300_000, "{}", bytes.len());
    folder.write("bomb.hdr", bytes);
    assert_refused(&folder, "light bomb.hdr --degree 2 --out new.csv", &["bomb.hdr"]);
}

/// A gray map of one value with compressed blocks.
#[test]
fn exr_of_packed_blocks() {
    let folder = Folder::new();
    // The header of a file of one gray channel, ZIP, and a table of as many blocks.
    let (width, height) = (16_384u32, 8_192u32);
    let window = [0, 0, width as i32 - 1, height as i32 - 1].map(i32::to_le_bytes).concat();
    let mut bytes = vec![0x76, 0x2f, 0x31, 0x01, 2, 0, 0, 0];
    // Its name, its type f32, flags, and the steps between samples.
    let channel = [b"Y\0".as_slice(), &[2, 0, 0, 0], &[0; 4], &[1, 0, 0, 0], &[1, 0, 0, 0], &[0]];
    for (name_and_kind, value) in [
        ("channels\0chlist\0", &channel.concat()[..]),
        ("compression\0compression\0", &[3]),
        ("dataWindow\0box2i\0", &window),
        ("displayWindow\0box2i\0", &window),
        ("lineOrder\0lineOrder\0", &[0]),
        ("pixelAspectRatio\0float\0", &1f32.to_le_bytes()),
        ("screenWindowCenter\0v2f\0", &[0; 8]),
        ("screenWindowWidth\0float\0", &1f32.to_le_bytes()),
    ] {
        bytes.extend(name_and_kind.as_bytes());
        bytes.extend((value.len() as u32).to_le_bytes());
        bytes.extend(value);
    }
    bytes.push(0);
    bytes.extend(vec![0; 8 * (height as usize / 16)]);
    bytes.resize(bytes.len() + (1 << 20), 0);
    folder.write("bomb.exr", bytes);
    assert_refused(&folder, "light bomb.exr --degree 2 --out new.csv", &["bomb.exr"]);
}

/// A file of its full size, which needs more than the budget.
#[test]
fn pfm_of_many_texels() {
    let folder = Folder::new();
    let header = b"Pf\n4096 4096\n-1\n";
    folder.write("large.pfm", [header, vec![0; 4 << 24].as_slice()].concat());
    let arguments = "light large.pfm --degree 0 --out new.csv --memory 100MiB";
    assert_refused(&folder, arguments, &["large.pfm", "193 MiB", "100 MiB", "--memory 193MiB"]);
    let light = "light large.pfm --degree 0 --out l.csv";
    // Within the budget, but beyond the limit of the system: an error, not an abort.
    let line = error_line(&limited(&folder, light, 200_000));
    assert!(line.contains("the system cannot provide"), "{line}");
    assert_enough(&folder, light, LIMIT);
}

/// Four million corners of three bytes each: read in 64 bytes a corner, and no face.
#[test]
fn ply_of_small_corners() {
    let folder = Folder::new();
    let header = ply_header("binary_little_endian", "4000000", "uchar", 1, "uchar int");
    let mut bytes = header.into_bytes();
    bytes.extend((0..3 * 4_000_000).map(|k: u32| (k % 251) as u8));
    bytes.extend([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    folder.write("large.ply", bytes);
    folder.write("scene.toml", with_geometry("normals = \"large.ply\"\n"));
    let output = limited(&folder, BASIS, LIMIT);
    let line = stderr(&output);
    // The one triangle faces the camera or not: either is an answer.
    assert!(output.status.code() == Some(0) || line.contains("no normal is visible"), "{line}");
    assert_refused(&folder, &format!("{NEW_BASIS} --memory 64MiB"), &["large.ply", "92 MiB"]);
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
    let faces = format!("f{}\n", " 1 2 3".repeat(100)).repeat(15_000);
    let obj = format!("v 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}");
    let facets = 1_000_000u32;
    let mut stl = vec![0; 80];
    stl.extend(facets.to_le_bytes());
    stl.resize(84 + 50 * facets as usize, 0);
    for (name, bytes, option) in [
        ("fans.ply", ply, ""),
        ("fans.obj", obj.into_bytes(), ""),
        ("many.stl", stl, "--memory 64MiB"),
    ] {
        folder.write(name, bytes);
        folder.write("scene.toml", with_geometry(&format!("normals = \"{name}\"\n")));
        assert_refused(&folder, &format!("{NEW_BASIS} {option}"), &[name]);
    }
}

#[test]
fn csv_of_short_rows() {
    let folder = Folder::with_table();
    folder.write("normals.csv", format!("x,y,z\n{}", "0,0,1\n".repeat(3_000_000)));
    assert_refused(&folder, &format!("{SHADE} --out new.csv"), &["normals.csv"]);
    folder
        .write("lights.csv", format!("name,l,m,value\n{}", "a,0,0,1\nb,0,0,1\n".repeat(1_250_000)));
    assert_refused(&folder, "light lights.csv --degree 0 --out new.csv", &["lights.csv"]);
}

#[test]
fn a_scene_beyond_the_budget() {
    let folder = Folder::of_size(64, 64, [1, 1]);
    for rotation in ["any", "none"] {
        folder.replace("scene.toml", "rotation = \"any\"", &format!("rotation = \"{rotation}\""));
        assert_refused(&folder, NEW_BASIS, &["degree 64, order 64", "minutes", "2 GiB"]);
    }
}

/// A picture of a sphere takes its bytes: its pixels are not stored before they are drawn. Those of
/// an .exr count.
#[test]
fn large_pictures() {
    let folder = Folder::new();
    let render = "render -q -l park -m chrome";
    assert_enough(&folder, &format!("{render} -s 3072 --out a.png"), LIMIT);
    assert_refused(&folder, &format!("{render} -s 8192 --out new.exr"), &["new.exr", "2 GiB"]);
    let png = format!("{render} -s 8192 --out new.png --memory 128MiB");
    assert_refused(&folder, &png, &["256 MiB"]);
}

/// Eigenimages and images of a large sphere are refused before its normals are computed.
#[test]
fn an_export_of_many_normals() {
    let folder = Folder::new();
    for inputs in ["", "-l park -m chrome"] {
        let export = format!("export --lang npz {inputs} --normals sphere -s 8192 --out new.npz");
        assert_refused(&folder, &export, &["give a smaller input"]);
    }
}

/// The estimated memory is enough.
#[test]
fn a_table_takes_what_was_estimated() {
    let folder = Folder::of_size(20, 20, [2, 2]);
    folder.write("scene.toml", folder.read("scene.toml") + "rank_cutoff = 1e-10\n");
    let line = error_line(&folder.run(&format!("{BASIS} --memory 4MiB")));
    let needed = line.split_once("--memory ").and_then(|(_, rest)| rest.split_once("MiB"));
    let needed: u64 = needed.and_then(|(number, _)| number.parse().ok()).expect("a size");
    // The program itself, and the address space of two threads.
    let own = 300;
    let basis = format!("{BASIS} --memory {needed}MiB");
    assert_enough(&folder, &basis, 1024 * (needed + own));
}
