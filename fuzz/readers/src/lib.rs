//! Invariants of the host's readers for any bytes: an error of one line with a remedy, or numbers
//! as documented; never a panic.

use eigenshade_asset::asset::Asset;
use eigenshade_asset::texels::Texels;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::{analytic, measurements, merl as merl_file};
use eigenshade_generator::object::picture::Picture;
use eigenshade_generator::object::surface::View;
use eigenshade_generator::{png_samples, scene_file};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::{coefficient_csv, normals};
use eigenshade_table::wire::{Endian, NumberFormat};
use eigenshade_table::{decode, encode, wire};
use std::path::PathBuf;
use std::sync::OnceLock;

/// A reader with its invariants: panics if one does not hold.
pub type Reader = fn(&[u8]);

/// The readers by name.
pub const READERS: [(&str, Reader); 12] = [
    ("exr", |bytes| map("exr", bytes)),
    ("hdr", |bytes| map("hdr", bytes)),
    ("pfm", |bytes| map("pfm", bytes)),
    ("png", png),
    ("obj", |bytes| mesh("obj", bytes)),
    ("stl", |bytes| mesh("stl", bytes)),
    ("ply", |bytes| mesh("ply", bytes)),
    ("glb", glb),
    ("csv", csv),
    ("toml", toml),
    ("merl", merl),
    ("bin", bin),
];

/// The reader that the environment variable `READER` names.
///
/// # Panics
///
/// If there is none of this name.
#[must_use]
pub fn chosen() -> Reader {
    static READER: OnceLock<Reader> = OnceLock::new();
    *READER.get_or_init(|| {
        let name = std::env::var("READER").unwrap_or_default();
        let found = READERS.into_iter().find(|(one, _)| *one == name);
        let names = || READERS.map(|(name, _)| name).join(", ");
        found.unwrap_or_else(|| panic!("READER is `{name}`, expected one of {}", names())).1
    })
}

/// PNG files, as samples and as normal maps.
fn png(bytes: &[u8]) {
    let path = file("png", bytes);
    if let Some(png) = accepted(png_samples::read(&path)) {
        let count = png.width * png.height;
        assert_eq!((png.colors.len(), png.opacities.len()), (count, count));
    }
    drawn(Picture::of_map(&path, None, false));
}

/// Every kind of CSV; the first byte chooses the kind.
fn csv(bytes: &[u8]) {
    let Some((kind, text)) = bytes.split_first() else { return };
    let path = file("csv", text);
    match kind % 4 {
        0 => {
            if let Some(lights) = accepted(coefficient_csv::read_lights(&path, None)) {
                let count = (lights.degree + 1).pow(2);
                let channels = lights.entries.iter().flat_map(|entry| &entry.rgb);
                channels.for_each(|channel| finite(channel, count));
            }
        }
        1 => {
            if let Some(materials) = accepted(coefficient_csv::read_materials(&path, None)) {
                let channels = materials.entries.iter().flat_map(|entry| &entry.rgb);
                channels.for_each(|channel| finite(channel, channel.len()));
            }
        }
        2 => {
            if let Some(normals) = accepted(normals::read_normals(&path)) {
                normals.iter().for_each(visible);
            }
        }
        _ => {
            if let Some(measured) = accepted(measurements::read(&path)) {
                assert!(!measured.samples.is_empty());
                measured.samples.iter().for_each(|sample| finite(&sample.rgb, 3));
            }
        }
    }
}

/// Lists of materials, and scenes, whose databases exist.
fn toml(bytes: &[u8]) {
    let path = file("toml", bytes);
    accepted(analytic::read(&path));
    if let Some(scene) = accepted(scene_file::load(&path)) {
        assert_eq!(scene.lights.degree, scene.scene.degree());
    }
}

/// MERL files. If the first byte is odd, the file is padded to its full length.
fn merl(bytes: &[u8]) {
    let Some((&fill, bytes)) = bytes.split_first() else { return };
    let mut bytes = bytes.to_vec();
    if fill % 2 == 1 && bytes.len() > 12 {
        let numbers = bytes.split_off(12);
        bytes.extend(numbers.iter().cycle().take(merl_file::BYTES as usize - 12));
    }
    accepted(merl_file::read(file("binary", &bytes)));
}

/// A table. Bytes that do not begin with `E` are a version and a payload, which get the right
/// length and checksum. A decoded table can be encoded again, and packed or rejected.
fn bin(bytes: &[u8]) {
    let sealed = |version: u8, payload: &[u8]| {
        let mut file = b"EIGSHADE".to_vec();
        file.extend(u32::from(1 + version % 4).to_le_bytes());
        file.extend((payload.len() as u64).to_le_bytes());
        file.extend(crc32fast::hash(payload).to_le_bytes());
        file.extend(payload);
        file
    };
    let found = match bytes.split_first() {
        Some((first, _)) if *first == b'E' => decode(bytes),
        Some((&version, payload)) => decode(&sealed(version, payload)),
        None => return,
    };
    let Some(table) = accepted(found.map_err(|error| Error::table(&error))) else { return };
    assert!(decode(&encode(&table)).as_ref() == Ok(&table));
    for format in NumberFormat::ALL {
        let _ = wire::encode(&table, format, Endian::Little);
    }
}

fn map(ending: &str, bytes: &[u8]) {
    if let Some(map) = accepted(EnvironmentMap::from_path(file(ending, bytes))) {
        assert_eq!(map.texels.len(), map.width * map.height);
        assert!(map.texels.iter().flatten().all(|value| value.is_finite()));
    }
}

/// A mesh, drawn small, smooth and flat.
fn mesh(ending: &str, bytes: &[u8]) {
    let path = file(ending, bytes);
    for is_flat in [false, true] {
        drawn(Picture::of_mesh(&path, 8, &View { is_flat, ..View::default() }));
    }
}

/// Checks the normals of a picture.
fn drawn(picture: Result<Picture>) {
    let pixels = accepted(picture).into_iter().flat_map(|picture| picture.pixels);
    pixels.flatten().for_each(|shown| visible(&shown.normal));
}

fn glb(bytes: &[u8]) {
    let file = file("glb", bytes).into();
    let drawn = Asset::read(&file)
        .and_then(|asset| Texels::of(&file, &asset.unwrap_or_default(), 8, &View::default()));
    for texel in accepted(drawn).into_iter().flat_map(|drawn| drawn.texels) {
        visible(&texel.normal);
        let shares = [texel.matte, texel.reflectance].concat();
        assert!((0.0..=1.0).contains(&texel.roughness), "{texel:?}");
        assert!(shares.iter().all(|share| (-1e-6..=1.000_001).contains(share)), "{texel:?}");
    }
}

fn visible(normal: &[f64; 3]) {
    let [x, y, z] = normal;
    assert!((x * x + y * y + z * z - 1.0).abs() < 1e-9 && *z >= 0.0, "{normal:?}");
}

fn finite(numbers: &[f64], count: usize) {
    assert!(numbers.len() == count && numbers.iter().all(|number| number.is_finite()));
}

/// The value that was read, if any; checks that an error contains a remedy.
fn accepted<T>(read: Result<T>) -> Option<T> {
    read.map_err(|error| assert!(error.to_string().contains("; "), "no remedy: {error}")).ok()
}

/// Writes these bytes to a file in a folder that has the databases of a scene.
fn file(ending: &str, bytes: &[u8]) -> PathBuf {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    let folder = FOLDER.get_or_init(|| {
        let folder = std::env::temp_dir().join(format!("eigenshade-fuzz-{}", std::process::id()));
        std::fs::create_dir_all(&folder).expect("a folder");
        std::fs::write(folder.join("lights.csv"), LIGHTS).expect("a file");
        std::fs::write(folder.join("materials.csv"), MATERIALS).expect("a file");
        folder
    });
    let path = folder.join(format!("any.{ending}"));
    std::fs::write(&path, bytes).expect("a file");
    path
}

/// The light database of a seed's scene.
const LIGHTS: &str = "name,l,m,value\na,0,0,2\na,1,-1,0.5\na,1,0,1\na,1,1,-0.5\n";
/// The material database of a seed's scene.
const MATERIALS: &str = "name,o,p,q,value\nm,0,0,0,1\nn,0,0,0,0.5\n";
