//! Large objects in bounded memory. Alone in its file: the memory of a process is measured.
#![cfg(target_os = "linux")]

use eigenshade_asset::asset::Asset;
use eigenshade_asset::picture::{Picture, Settings};
use eigenshade_testing::glb::Glb;
use png::{BitDepth, ColorType, Compression, Encoder};
use std::io::Write;
use std::path::PathBuf;

/// Bytes of a picture of 490,000 triangles: 260 for each of them, and what the mesh and its file
/// take.
const OF_TRIANGLES: usize = 350 << 20;

/// Bytes of a texture of 8192 x 8192 while it is read: 8 for each texel, and a quarter for the next
/// level.
const OF_A_TEXTURE: usize = 720 << 20;

/// The memory of the process in bytes: `VmRSS:` now, `VmHWM:` at most.
fn memory(which: &str) -> usize {
    let status = std::fs::read_to_string("/proc/self/status").expect("a status");
    let line = status.lines().find(|line| line.starts_with(which)).expect("a line");
    let kibibytes = line.split_whitespace().nth(1).and_then(|word| word.parse::<usize>().ok());
    1024 * kibibytes.expect("a number")
}

/// The bytes that a picture of this file takes, above those before.
fn taken(path: PathBuf) -> usize {
    let file = path.into();
    let light = "lobby".parse().expect("a light");
    let settings = Settings { size: 64, ..Settings::default() };
    let before = memory("VmRSS:");
    let asset = Asset::read(&file).expect("an object").expect("materials");
    Picture::of(&file, &asset, &light, &settings).expect("a picture");
    memory("VmHWM:") - before
}

#[test]
fn large_objects_take_bounded_memory() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("a.glb");
    let mut glb = Glb::sphere(350);
    glb.normals.clear();
    std::fs::write(&path, glb.bytes()).expect("a file");
    drop(glb);
    let found = taken(path.clone());
    println!("490,000 triangles: {} MiB", found >> 20);
    assert!(found < OF_TRIANGLES, "{found}");

    let mut image = Vec::new();
    let mut encoder = Encoder::new(&mut image, 8192, 8192);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::Fast);
    let mut writer = encoder.write_header().expect("a header");
    let mut rows = writer.stream_writer().expect("rows");
    let row: Vec<u8> = (0..3 * 8192).map(|k| (k / 96) as u8).collect();
    (0..8192).for_each(|_| rows.write_all(&row).expect("a row"));
    rows.finish().expect("an end");
    writer.finish().expect("an end");
    let material = r#""pbrMetallicRoughness":{"baseColorTexture":{"index":0}}"#;
    let glb = Glb { material: material.to_owned(), images: vec![image], ..Glb::square() };
    std::fs::write(&path, glb.bytes()).expect("a file");
    let found = taken(path);
    println!("8192 x 8192 texels: {} MiB", found >> 20);
    assert!(found < OF_A_TEXTURE, "{found}");
}
