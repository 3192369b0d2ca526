//! What holds of any bytes that a reader of the host is given: an error of one line with a
//! remedy, or numbers that are what the reader promises; never a panic.

use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::material::{analytic, measurements, merl as merl_file};
use eigenshade_generator::object::geometry::WeightedNormals;
use eigenshade_generator::object::{density, mesh, normal_map};
use eigenshade_generator::picture::png_samples;
use eigenshade_generator::scene_file;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::{coefficient_csv, normals};
use eigenshade_table::wire::{Endian, Format};
use eigenshade_table::{decode, encode, quantise, wire};
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

/// A fuzz target of this name's function; without libFuzzer, a program that reads the files that
/// are named.
#[macro_export]
macro_rules! target {
    ($reader:ident) => {
        #[cfg(fuzzing)]
        libfuzzer_sys::fuzz_target!(|bytes: &[u8]| $crate::$reader(bytes));

        #[cfg(not(fuzzing))]
        fn main() -> std::io::Result<()> {
            for path in std::env::args_os().skip(1) {
                $crate::$reader(&std::fs::read(path)?);
            }
            Ok(())
        }
    };
}

/// OpenEXR.
pub fn exr(bytes: &[u8]) {
    map("exr", bytes);
}

/// Radiance.
pub fn hdr(bytes: &[u8]) {
    map("hdr", bytes);
}

/// Portable float map.
pub fn pfm(bytes: &[u8]) {
    map("pfm", bytes);
}

/// PNG, as samples and as normal map.
pub fn png(bytes: &[u8]) {
    let path = file("png", bytes);
    if let Some(png) = taken(png_samples::read(&path)) {
        let count = png.width * png.height;
        assert_eq!((png.colours.len(), png.opacities.len()), (count, count));
    }
    weighted(normal_map::read(&path, None));
    weighted(normal_map::read(&path, Some(&path)));
}

/// Wavefront.
pub fn obj(bytes: &[u8]) {
    weighted(mesh::read(file("obj", bytes)));
}

/// Stereolithography, text and binary.
pub fn stl(bytes: &[u8]) {
    weighted(mesh::read(file("stl", bytes)));
}

/// Polygon file.
pub fn ply(bytes: &[u8]) {
    weighted(mesh::read(file("ply", bytes)));
}

/// Every kind of CSV; the first byte says which.
pub fn csv(bytes: &[u8]) {
    let Some((kind, text)) = bytes.split_first() else { return };
    let path = file("csv", text);
    match kind % 6 {
        0 => {
            if let Some(lights) = taken(coefficient_csv::read_lights(&path, None)) {
                let count = (lights.degree + 1).pow(2);
                let channels = lights.entries.iter().flat_map(|entry| &entry.rgb);
                channels.for_each(|channel| finite(channel, count));
            }
        }
        1 => {
            if let Some(materials) = taken(coefficient_csv::read_materials(&path, None)) {
                let channels = materials.entries.iter().flat_map(|entry| &entry.rgb);
                channels.for_each(|channel| finite(channel, channel.len()));
            }
        }
        2 => {
            if let Some(normals) = taken(normals::read_normals(&path)) {
                normals.iter().for_each(visible);
            }
        }
        3 => weighted(normals::read_weighted_normals(&path)),
        4 => {
            if let Some(measured) = taken(measurements::read(&path)) {
                assert!(!measured.samples.is_empty());
                measured.samples.iter().for_each(|sample| finite(&sample.rgb, 3));
            }
        }
        _ => {
            let name = path.file_name().and_then(|name| name.to_str()).expect("a name");
            weighted(density::read(name, path.parent().expect("a folder"), 1));
        }
    }
}

/// A list of materials, or a scene, whose databases are there.
pub fn toml(bytes: &[u8]) {
    let path = file("toml", bytes);
    taken(analytic::read(&path));
    if let Some(scene) = taken(scene_file::load(&path)) {
        assert_eq!(scene.lights.degree, scene.scene.degree());
    }
}

/// A MERL file; one whose first byte is odd is filled up to its length.
pub fn merl(bytes: &[u8]) {
    let Some((&fill, bytes)) = bytes.split_first() else { return };
    let mut bytes = bytes.to_vec();
    if fill % 2 == 1 && bytes.len() > 12 {
        let numbers = bytes.split_off(12);
        bytes.extend(numbers.iter().cycle().take(merl_file::BYTES as usize - 12));
    }
    taken(merl_file::read(file("binary", &bytes)));
}

/// A density as a formula.
pub fn formula(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    // The name of a file is none.
    if !text.to_ascii_lowercase().ends_with("csv") {
        weighted(density::read(text, Path::new(""), 0));
    }
}

/// A table. Bytes that do not begin as one are a version and a payload, whose length and checksum
/// are then right. What decodes can be written again, and packed or refused.
pub fn bin(bytes: &[u8]) {
    let sealed = |version: u8, payload: &[u8]| {
        let mut file = b"EIGSHADE".to_vec();
        file.extend(u32::from(2 + version % 4).to_le_bytes());
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
    let Some(table) = taken(found.map_err(|error| Error::table(&error))) else { return };
    assert!(decode(&encode(&table)).as_ref() == Ok(&table));
    for format in [
        Format::F32,
        Format::Integer(quantise::Format::Q15),
        Format::Integer(quantise::Format::Q31),
    ] {
        let _ = wire::encode(&table, format, Endian::Little);
    }
}

fn map(ending: &str, bytes: &[u8]) {
    if let Some(map) = taken(EnvironmentMap::from_path(file(ending, bytes))) {
        assert_eq!(map.texels.len(), map.width * map.height);
        assert!(map.texels.iter().flatten().all(|value| value.is_finite()));
    }
}

/// Normals with weights: those that are taken make an object, or an error.
fn weighted(read: Result<Vec<([f64; 3], f64)>>) {
    if let Some(object) = taken(read).and_then(|pairs| taken(WeightedNormals::new(pairs))) {
        object.normals().iter().for_each(visible);
    }
}

fn visible(normal: &[f64; 3]) {
    let [x, y, z] = normal;
    assert!((x * x + y * y + z * z - 1.0).abs() < 1e-9 && *z >= 0.0, "{normal:?}");
}

fn finite(numbers: &[f64], count: usize) {
    assert!(numbers.len() == count && numbers.iter().all(|number| number.is_finite()));
}

/// What was read; a refusal says what to do.
fn taken<T>(read: Result<T>) -> Option<T> {
    read.map_err(|error| assert!(error.to_string().contains("; "), "no remedy: {error}")).ok()
}

/// A file with these bytes, in a folder that has a scene's databases.
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
pub const LIGHTS: &str = "name,l,m,value\na,0,0,2\na,1,-1,0.5\na,1,0,1\na,1,1,-0.5\n";
/// The material database of a seed's scene.
pub const MATERIALS: &str = "name,o,p,q,value\nm,0,0,0,1\nn,0,0,0,0.5\n";
