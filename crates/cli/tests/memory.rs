//! Small files that claim a large size, and large scenes: refused in seconds, before memory is
//! allocated, also under a limit of the operating system.
#![cfg(unix)]

use crate::PROGRAM;
use crate::support::files::{square_png, with_geometry};
use crate::support::{Folder, lights, materials};
use png::{BitDepth, ColorType, Compression, Encoder};
use std::fmt::Write as _;
use std::io::Write as _;
use std::process::{Command, Output};

/// The address space of the program in KiB.
const LIMIT: u64 = 500_000;

/// Seconds of processor time after which the program is ended.
const SECONDS: u64 = 10;

/// Runs the program in this folder, limited to [`SECONDS`] and to this address space in KiB.
fn limited(folder: &Folder, arguments: &str, kibibytes: u64) -> Output {
    Command::new("sh")
        .current_dir(folder.path("."))
        .args([
            "-c",
            &format!(
                "ulimit -t {SECONDS} && ulimit -v {kibibytes} && exec '{PROGRAM}' {arguments}"
            ),
        ])
        .output()
        .expect("a shell")
}

/// Asserts status 1 and one line with the memory that is needed, the limit and how to raise it, and
/// that nothing is written.
fn assert_refused(folder: &Folder, arguments: &str, fragments: &[&str]) {
    let before = folder.names();
    let output = limited(folder, arguments, LIMIT);
    let line = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments}: {line}");
    assert!(line.starts_with("error: ") && line.lines().count() == 1, "{arguments}: {line}");
    for fragment in [&["needs", "the budget is", "--memory"], fragments].concat() {
        assert!(line.contains(fragment), "{arguments}: no `{fragment}` in {line}");
    }
    assert_eq!(folder.names(), before, "{arguments}");
}

/// A black or white PNG of this size.
fn plain_png(width: u32, height: u32, colors: ColorType, sample: u8) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(colors);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Balanced);
    let mut writer = encoder.write_header().expect("a header");
    let mut stream = writer.stream_writer().expect("a stream");
    let row = vec![sample; colors.samples() * width as usize];
    for _ in 0..height {
        stream.write_all(&row).expect("a row");
    }
    stream.finish().expect("an end");
    writer.finish().expect("an end");
    bytes
}

#[test]
fn pngs_that_expand() {
    let folder = Folder::with_table();
    let bomb = plain_png(8192, 8192, ColorType::Rgb, 255);
    assert!(bomb.len() < 300_000, "{}", bomb.len());
    folder.write("bomb.png", &bomb);
    let small = square_png(8, ColorType::Rgb, BitDepth::Eight, &[0.6; 192]);
    folder.write("small.png", &small);
    folder.write("scene.toml", with_geometry("normals = \"bomb.png\"\n"));
    assert_refused(&folder, "basis --scene scene.toml --out new.bin", &["8192 x 8192"]);
    let masked = with_geometry("normals = \"small.png\"\nmask = \"bomb.png\"\n");
    folder.write("scene.toml", masked);
    assert_refused(&folder, "basis --scene scene.toml --out new.bin", &["8192 x 8192"]);
    let pair = "--light lights.csv --material materials.csv";
    for (image, options) in [
        ("bomb.png", "--normals sphere"),
        ("small.png", "--normals bomb.png"),
        ("small.png", "--normals sphere --mask bomb.png"),
    ] {
        let arguments = format!("read {image} --table b.bin {pair} {options} --out new.csv");
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
    let mut attribute = |name: &str, kind: &str, value: &[u8]| {
        for text in [name, kind] {
            bytes.extend(text.as_bytes());
            bytes.push(0);
        }
        bytes.extend((value.len() as u32).to_le_bytes());
        bytes.extend(value);
    };
    let channel = [
        b"Y\0".as_slice(),
        &2u32.to_le_bytes(),
        &[0; 4],
        &1u32.to_le_bytes(),
        &1u32.to_le_bytes(),
        &[0],
    ]
    .concat();
    attribute("channels", "chlist", &channel);
    attribute("compression", "compression", &[3]);
    attribute("dataWindow", "box2i", &window);
    attribute("displayWindow", "box2i", &window);
    attribute("lineOrder", "lineOrder", &[0]);
    attribute("pixelAspectRatio", "float", &1f32.to_le_bytes());
    attribute("screenWindowCenter", "v2f", &[0; 8]);
    attribute("screenWindowWidth", "float", &1f32.to_le_bytes());
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
    let output = limited(&folder, light, 200_000);
    let line = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{line}");
    assert!(line.contains("the system cannot provide") && line.lines().count() == 1, "{line}");
    let output = limited(&folder, light, LIMIT);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
}

/// Four million corners of three bytes each: read in 64 bytes a corner, and no face.
#[test]
fn ply_of_small_corners() {
    let folder = Folder::new();
    let count = 4_000_000;
    let mut bytes = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex {count}\nproperty uchar x\n\
         property uchar y\nproperty uchar z\nelement face 1\n\
         property list uchar int vertex_indices\nend_header\n"
    )
    .into_bytes();
    bytes.extend((0..3 * count).map(|k: u32| (k % 251) as u8));
    bytes.extend([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
    folder.write("large.ply", bytes);
    folder.write("scene.toml", with_geometry("normals = \"large.ply\"\n"));
    let output = limited(&folder, "basis --scene scene.toml --out b.bin", LIMIT);
    let line = String::from_utf8_lossy(&output.stderr).into_owned();
    // The one triangle faces the camera or not: either is an answer.
    assert!(output.status.code() == Some(0) || line.contains("no normal is visible"), "{line}");
    let arguments = "basis --scene scene.toml --out new.bin --memory 64MiB";
    assert_refused(&folder, arguments, &["large.ply", "92 MiB"]);
}

/// Polygons with many corners, each a fan of as many triangles.
#[test]
fn meshes_of_many_facets() {
    let folder = Folder::new();
    let (polygons, corners) = (20_000, 255);
    let mut ply = format!(
        "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty uchar x\n\
         property uchar y\nproperty uchar z\nelement face {polygons}\n\
         property list uchar uchar vertex_indices\nend_header\n"
    )
    .into_bytes();
    ply.extend([0, 0, 0, 1, 0, 0, 0, 1, 0]);
    let fan: Vec<u8> = std::iter::once(corners).chain([0, 1, 2].repeat(85)).collect();
    ply.extend(fan.repeat(polygons));
    let mut obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n".to_owned();
    let face = format!("f{}\n", " 1 2 3".repeat(100));
    for _ in 0..15_000 {
        obj.push_str(&face);
    }
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
        let basis = format!("basis --scene scene.toml --out new.bin {option}");
        assert_refused(&folder, &basis, &[name]);
    }
}

#[test]
fn csv_of_short_rows() {
    let folder = Folder::with_table();
    folder.write("normals.csv", format!("x,y,z\n{}", "0,0,1\n".repeat(3_000_000)));
    let pair = "--light lights.csv --material materials.csv";
    let shade = format!("shade --table b.bin {pair} --normals normals.csv --out new.csv");
    assert_refused(&folder, &shade, &["normals.csv"]);
    folder
        .write("lights.csv", format!("name,l,m,value\n{}", "a,0,0,1\nb,0,0,1\n".repeat(1_250_000)));
    let light = "light lights.csv --degree 0 --out new.csv";
    assert_refused(&folder, light, &["lights.csv"]);
}

#[test]
fn a_scene_beyond_the_budget() {
    let folder = Folder::new();
    folder.write("lights.csv", lights(64, 1));
    folder.write("materials.csv", materials(64, 1));
    let scene = folder.read("scene.toml");
    let scene = scene.replace("degree = 4", "degree = 64").replace("order = 3", "order = 64");
    folder.write("scene.toml", &scene);
    let basis = "basis --scene scene.toml --out new.bin";
    assert_refused(&folder, basis, &["degree 64, order 64", "minutes", "2 GiB"]);
    folder.write("scene.toml", scene.replace("rotation = \"any\"", "rotation = \"none\""));
    assert_refused(&folder, basis, &["degree 64, order 64", "minutes", "2 GiB"]);
}

/// A picture of a sphere takes its bytes: its pixels are not stored before they are drawn. Those of
/// an .exr count.
#[test]
fn large_pictures() {
    let folder = Folder::new();
    let render = "render -q -l park -m chrome";
    let output = limited(&folder, &format!("{render} -s 3072 --out a.png"), LIMIT);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert_refused(&folder, &format!("{render} -s 8192 --out new.exr"), &["new.exr", "2 GiB"]);
    assert_refused(
        &folder,
        &format!("{render} -s 8192 --out new.png --memory 128MiB"),
        &["256 MiB"],
    );
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
    let folder = Folder::new();
    let (degree, order) = (20, 20);
    folder.write("lights.csv", lights(degree, 2));
    folder.write("materials.csv", materials(order, 2));
    let scene = folder.read("scene.toml");
    let mut text = scene.replace("degree = 4", "degree = 20").replace("order = 3", "order = 20");
    let _ = writeln!(text, "rank_cutoff = 1e-10");
    folder.write("scene.toml", text);
    let refused = folder.run("basis --scene scene.toml --out b.bin --memory 4MiB");
    let line = String::from_utf8_lossy(&refused.stderr).into_owned();
    let needed = line.split_once("--memory ").and_then(|(_, rest)| rest.split_once("MiB"));
    let needed: u64 = needed.and_then(|(number, _)| number.parse().ok()).expect("a size");
    // The program itself, and the address space of two threads.
    let own = 300;
    let run = |mebibytes: u64| {
        let basis = format!("basis --scene scene.toml --out b.bin --memory {needed}MiB");
        let output = limited(&folder, &basis, 1024 * (mebibytes + own));
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (status, line) = run(needed);
    assert_eq!(status, Some(0), "{needed} MiB: {line}");
}
