//! Every fault of a map's file: one line, with a remedy, and no panic.

use super::files::{Type, exr_channels, map_of, message, refusal, write};
use super::pictures::small;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::light::projection::named_maps;
use exr::prelude::{FlatSamples, *};
use std::fs::{self, File, OpenOptions};
use std::io::{Seek, SeekFrom, Write};
use std::path::PathBuf;
use tempfile::TempDir;

#[track_caller]
pub fn assert_starts(text: &str, start: &str) {
    assert!(text.starts_with(start), "`{text}` is not `{start}...`");
    assert!(text.contains("; "), "a remedy in `{text}`");
}

fn bytes_of(file_type: Type) -> (String, Vec<u8>) {
    let folder = TempDir::new().unwrap();
    let path = write(file_type, &map_of(8, |[x, _, z]| [x as f32, z as f32, 0.1]), folder.path());
    let name = path.file_name().unwrap().to_str().unwrap().to_owned();
    (name, fs::read(path).unwrap())
}

#[test]
fn files_that_are_no_maps_are_refused() {
    for name in ["map.gif", "map", "map.exr.txt"] {
        assert_starts(
            &message(name, b"PF\n1 1\n-1\n0123456789ab"),
            &format!("{name}: it is not an environment map; "),
        );
    }
    for (name, file_type) in [
        ("map.exr", "OpenEXR"),
        ("map.hdr", "Radiance"),
        ("map.pfm", "PFM"),
        ("map.png", "PNG"),
        ("map.jpg", "JPEG"),
        ("map.jpeg", "JPEG"),
    ] {
        for bytes in [&b""[..], b"GIF89a", b"text\n1 2 3\n", &[0; 64]] {
            assert_starts(
                &message(name, bytes),
                &format!("{name}: it is not a file of type {file_type}, "),
            );
        }
    }
    let missing = EnvironmentMap::from_path("nowhere/map.exr").unwrap_err();
    assert_starts(&missing.to_string(), "nowhere/map.exr: ");
}

/// A file that is changed in place: thousands of new ones would take minutes on some systems.
fn changeable(folder: &TempDir, name: &str, bytes: &[u8]) -> (PathBuf, File) {
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    let file = OpenOptions::new().write(true).open(&path).unwrap();
    (path, file)
}

#[test]
fn a_file_cut_anywhere_is_refused() {
    for (name, bytes) in Type::ALL.map(bytes_of).into_iter().chain(small()) {
        let folder = TempDir::new().unwrap();
        let (path, file) = changeable(&folder, &name, &bytes);
        for length in (0..bytes.len()).rev() {
            file.set_len(length as u64).unwrap();
            assert_starts(&refusal(&path), &format!("{name}: it is "));
        }
    }
}

#[test]
fn no_damage_is_a_panic() {
    for (name, bytes) in Type::ALL.map(bytes_of).into_iter().chain(small()) {
        let folder = TempDir::new().unwrap();
        let (path, mut file) = changeable(&folder, &name, &bytes);
        let mut put = |place: usize, byte: u8| {
            file.seek(SeekFrom::Start(place as u64)).unwrap();
            file.write_all(&[byte]).unwrap();
        };
        for (place, byte) in bytes.iter().enumerate().take(600) {
            for flipped in [0xff, 0x80, 0x01] {
                put(place, byte ^ flipped);
                if let Ok(map) = EnvironmentMap::from_path(&path) {
                    assert_eq!(map.texels.len(), map.width * map.height);
                }
            }
            put(place, *byte);
        }
    }
}

#[test]
fn a_block_that_claims_too_much_takes_no_memory() {
    // The first block of this file begins at byte 321 with its row and its length; its
    // counters follow. The decoder would ask for as many bytes as they say.
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tables/inputs/maps/sky.exr");
    let bytes = fs::read(path).unwrap();
    for counter in [1, 6, 7, 8, 9] {
        let mut damaged = bytes.clone();
        damaged[321 + 8 + 8 * counter + 5] = 0xf9;
        assert_starts(
            &message("map.exr", &damaged),
            "map.exr: it is broken or cut short (a DWA block claims more than it can hold); ",
        );
    }
}

#[test]
fn absurd_sizes_take_no_memory() {
    for (width, height) in
        [("99999999", "99999999"), ("18446744073709551615", "2"), ("65536", "65536")]
    {
        let pfm = format!("PF\n{width} {height}\n-1\n0123");
        assert_starts(&message("map.pfm", pfm.as_bytes()), "map.pfm: its header claims ");
    }
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 30000 +X 30000\n0123";
    assert_starts(&message("map.hdr", hdr), "map.hdr: its header claims 30000 x 30000 ");
    let (name, mut exr) = bytes_of(Type::ExrFloat);
    // Both windows end at 15, 7; far from there:
    for k in 0..exr.len() - 8 {
        if exr[k..k + 8] == [15, 0, 0, 0, 7, 0, 0, 0] {
            exr[k..k + 8].copy_from_slice(&[0xff, 0xff, 0xff, 0x1f, 7, 0, 0, 0]);
        }
    }
    assert_starts(&message(&name, &exr), "map.exr: its header claims 536870912 x 8 ");
}

#[test]
fn maps_without_texels_are_refused() {
    assert_starts(
        &message("map.pfm", b"PF\n0 4\n-1\n"),
        "map.pfm: it is 0 x 4 pixels: it has none; ",
    );
    let hdr = b"#?RGBE\nFORMAT=32-bit_rle_rgbe\n\n-Y 0 +X 8\n";
    assert_starts(&message("map.hdr", hdr), "map.hdr: it is 8 x 0 pixels: it has none; ");
    assert!(EnvironmentMap::new(0, 0, vec![]).is_err());
    assert!(EnvironmentMap::new(2, 2, vec![[0.0; 3]; 3]).is_err());
    assert!(EnvironmentMap::new(usize::MAX, 2, vec![[0.0; 3]; 3]).is_err());
}

#[test]
fn other_kinds_of_the_types_are_refused() {
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_luv\n\n-Y 1 +X 1\n0123";
    assert_starts(&message("map.hdr", hdr), "map.hdr: it is of a kind that is not supported ");
    let hdr = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n+X 2 +X 1\n01230123";
    assert_starts(&message("map.hdr", hdr), "map.hdr: it is broken or cut short (its size is `+X ");
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.exr");
    let samples = || FlatSamples::F32(vec![1.0; 8]);
    for channels in [&["R", "depth"][..], &["X", "Y", "Z"]] {
        exr_channels(&path, (4, 2), channels.iter().map(|name| (*name, samples())).collect());
        let names = channels.join(", ");
        let start = format!("map.exr: its channels are {names}, without R, G, B; ");
        assert_starts(&refusal(&path), &start);
    }
    for depth in ["depth", "Z"] {
        exr_channels(&path, (4, 2), vec![(depth, samples()), ("Y", samples())]);
        assert_eq!(EnvironmentMap::from_path(&path).unwrap().texels, [[1.0; 3]; 8]);
    }
}

#[test]
fn cropped_and_shifted_maps_are_refused() {
    let (name, exr) = bytes_of(Type::ExrFloat);
    let attribute = b"displayWindow\0box2i\0";
    let start = exr.windows(attribute.len()).position(|bytes| bytes == attribute).unwrap();
    // Its size, then the first and the last column and row.
    let window = start + attribute.len() + 4;
    for (first, last, shown) in
        [(0, 16, "17 x 8 pixels from 0, 0"), (1, 16, "16 x 8 pixels from 1, 0")]
    {
        let mut other = exr.clone();
        (other[window], other[window + 8]) = (first, last);
        let start = format!("map.exr: it stores 16 x 8 pixels from 0, 0, but shows {shown}; save ");
        assert_starts(&message(&name, &other), &start);
    }
}

#[test]
fn texels_that_are_not_finite_are_counted() {
    let mut map = map_of(8, |_| [1.0; 3]);
    map.texels[3 * 16 + 5] = [1.0, f32::NAN, f32::NAN];
    map.texels[7 * 16 + 2] = [f32::NEG_INFINITY, 1.0, 1.0];
    for file_type in [Type::ExrFloat, Type::ExrZip, Type::ExrHalf, Type::PfmLittle, Type::PfmBig] {
        let folder = TempDir::new().unwrap();
        let text = EnvironmentMap::from_path(write(file_type, &map, folder.path()))
            .unwrap_err()
            .to_string();
        assert!(
            text.contains(": pixels that are not finite: 2, the first in column 5 of row 3, "),
            "{text}"
        );
        assert!(text.contains("; clean the map"), "{text}");
    }
}

/// The largest and the smallest half, -0 and negative texels are finite.
#[test]
fn extreme_half_floats_are_kept() {
    let halves = [0x7bff, 0x0001, 0x8000, 0xbc00, 0x3c00, 0x3c00, 0xfbff, 0x3c00];
    let values = [65504.0, 2f32.powi(-24), 0.0, -1.0, 1.0, 1.0, -65504.0, 1.0];
    let samples = || FlatSamples::F16(halves.map(f16::from_bits).to_vec());
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("map.exr");
    exr_channels(&path, (4, 2), ["R", "G", "B"].map(|name| (name, samples())).into());
    let map = EnvironmentMap::from_path(&path).unwrap();
    assert_eq!(map.texels, values.map(|value| [value; 3]));
}

#[test]
fn lights_are_called_as_their_files() {
    let folder = TempDir::new().unwrap();
    let map = map_of(4, |[x, _, _]| [x as f32, 1.0, 2.0]);
    let (one, two) = (folder.path().join("one"), folder.path().join("two"));
    for sub in [&one, &two] {
        fs::create_dir(sub).unwrap();
        write(Type::ExrFloat, &map, sub);
    }
    fs::rename(one.join("map.exr"), one.join("b.EXR")).unwrap();
    write(Type::PfmBig, &map, &one);
    fs::rename(one.join("map.PFM"), one.join("a.pfm")).unwrap();
    fs::write(one.join("notes.txt"), "no map").unwrap();
    let maps = named_maps(&[&one, &two]).unwrap();
    let names: Vec<_> = maps.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["a", "b", "map"]);
    let [first, _, last] = [0, 1, 2].map(|k| EnvironmentMap::from_path(&maps[k].1).unwrap());
    assert_eq!(first.texels, last.texels);

    fs::rename(two.join("map.exr"), two.join("a.exr")).unwrap();
    let twice = named_maps(&[&one, &two]).unwrap_err().to_string();
    assert!(twice.contains("a.exr: `a` is also the name of "), "{twice}");
    assert!(twice.contains("; rename one of the two files"), "{twice}");
    let empty = folder.path().join("empty");
    fs::create_dir(&empty).unwrap();
    let empty = named_maps(&[&empty]).unwrap_err().to_string();
    assert!(empty.contains("empty: there is no map in this folder; "), "{empty}");
    assert!(named_maps(&[folder.path().join("nowhere.exr")]).is_err());
}
