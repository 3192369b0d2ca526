//! What a PNG carries beside its picture is not unpacked. Alone in its file: the memory of a
//! process is measured.
#![cfg(target_os = "linux")]

use eigenshade_generator::png_samples;
use flate2::{Compression, write::ZlibEncoder};
use png::{BitDepth, ColorType, Encoder, chunk::ChunkType};
use std::io::Write;

/// Bytes that a chunk unpacks to.
const UNPACKED: usize = 1 << 28;

/// The most memory that the process ever had, in bytes.
fn most_memory() -> usize {
    let status = std::fs::read_to_string("/proc/self/status").expect("a status");
    let line = status.lines().find(|line| line.starts_with("VmHWM:")).expect("a peak");
    let kibibytes = line.split_whitespace().nth(1).and_then(|word| word.parse::<usize>().ok());
    1024 * kibibytes.expect("a number")
}

/// A picture of 2 x 1 with a chunk of this kind, which begins so and goes on with packed zeros.
fn picture(kind: &[u8; 4], beginning: &[u8]) -> Vec<u8> {
    let mut packed = ZlibEncoder::new(beginning.to_vec(), Compression::best());
    for _ in 0..UNPACKED >> 20 {
        packed.write_all(&[0; 1 << 20]).expect("memory");
    }
    let chunk = packed.finish().expect("memory");
    assert!(chunk.len() < UNPACKED / 500, "{}", chunk.len());
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 2, 1);
    encoder.set_color(ColorType::Grayscale);
    encoder.set_depth(BitDepth::Eight);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_chunk(ChunkType(*kind), &chunk).expect("a chunk");
    writer.write_image_data(&[7, 200]).expect("an image");
    writer.finish().expect("an end");
    file
}

#[test]
fn profiles_and_texts_stay_packed() {
    let folder = tempfile::tempdir().expect("a folder");
    for (kind, beginning) in
        [(b"iCCP", &b"profile\0\0"[..]), (b"zTXt", b"text\0\0"), (b"iTXt", b"text\0\x01\0\0\0")]
    {
        let path = folder.path().join("map.png");
        std::fs::write(&path, picture(kind, beginning)).expect("a file");
        let before = most_memory();
        let samples = png_samples::read(&path).expect("a picture");
        let taken = most_memory() - before;
        assert_eq!(samples.colors, [[7; 3], [200; 3]]);
        assert!(taken < UNPACKED / 16, "{taken} bytes for {}", String::from_utf8_lossy(kind));
    }
}
