//! Maps written to files of every type and read back.

use eigenshade_generator::light::environment::EnvironmentMap;
use exr::prelude::{FlatSamples, *};
use std::fs;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// What a map goes through.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Type {
    ExrFloat,
    ExrZip,
    ExrHalf,
    ExrLayer,
    Hdr,
    PfmLittle,
    PfmBig,
    PfmGray,
}

impl Type {
    pub const ALL: [Self; 8] = [
        Self::ExrFloat,
        Self::ExrZip,
        Self::ExrHalf,
        Self::ExrLayer,
        Self::Hdr,
        Self::PfmLittle,
        Self::PfmBig,
        Self::PfmGray,
    ];
}

/// The map of a function of direction.
pub fn map_of(height: usize, radiance: impl Fn([f64; 3]) -> [f32; 3]) -> EnvironmentMap {
    let width = 2 * height;
    let blank = EnvironmentMap::new(width, height, vec![[0.0; 3]; width * height]).unwrap();
    let places = (0..height).flat_map(|row| (0..width).map(move |column| (column, row)));
    let texels = places.map(|(column, row)| radiance(blank.direction(column, row))).collect();
    EnvironmentMap::new(width, height, texels).unwrap()
}

/// The map, written and read.
pub fn through(file_type: Type, map: &EnvironmentMap) -> EnvironmentMap {
    let folder = tempfile::TempDir::new().unwrap();
    let read = EnvironmentMap::from_path(write(file_type, map, folder.path())).unwrap();
    assert_eq!((read.width, read.height), (map.width, map.height));
    read
}

/// The map as this file has it, of texels that it can hold: a mantissa of a Radiance file stands for
/// the middle of what is cut off to it.
pub fn held(file_type: Type, map: &EnvironmentMap) -> EnvironmentMap {
    let mut map = map.clone();
    if file_type == Type::Hdr {
        for texel in map.texels.iter_mut().filter(|texel| **texel != [0.0; 3]) {
            let half = 2.0f32.powi(exponent(texel) - 9);
            *texel = texel.map(|value| value + half);
        }
    }
    map
}

/// The map as a file of this folder.
pub fn write(file_type: Type, map: &EnvironmentMap, folder: &Path) -> PathBuf {
    let ending = match file_type {
        Type::ExrFloat | Type::ExrZip | Type::ExrHalf | Type::ExrLayer => "exr",
        Type::Hdr => "hdr",
        Type::PfmLittle | Type::PfmBig | Type::PfmGray => "PFM",
    };
    let path = folder.join(format!("map.{ending}"));
    match file_type {
        Type::ExrFloat => exr(map, &path, false, ["R", "G", "B"], Encoding::UNCOMPRESSED),
        Type::ExrZip => exr(
            map,
            &path,
            false,
            ["R", "G", "B"],
            Encoding { compression: Compression::ZIP16, ..Encoding::UNCOMPRESSED },
        ),
        Type::ExrHalf => exr(map, &path, true, ["R", "G", "B"], Encoding::FAST_LOSSLESS),
        Type::ExrLayer => {
            exr(map, &path, true, ["sky.R", "sky.G", "sky.B"], Encoding::SMALL_LOSSLESS);
        }
        Type::Hdr => hdr(map, &path),
        Type::PfmLittle => pfm(map, &path, "PF", "-1.0", f32::to_le_bytes),
        Type::PfmBig => pfm(map, &path, "PF", "1", f32::to_be_bytes),
        Type::PfmGray => pfm(map, &path, "Pf", "-2.5", f32::to_le_bytes),
    }
    path
}

/// Named channels, each a list of samples row by row.
pub fn exr_channels(
    path: &Path,
    (width, height): (usize, usize),
    channels: Vec<(&str, FlatSamples)>,
) {
    let channels =
        channels.into_iter().map(|(name, samples)| AnyChannel::new(name, samples)).collect();
    let layer = Layer::new(
        (width, height),
        LayerAttributes::named("map"),
        Encoding::UNCOMPRESSED,
        AnyChannels::sort(channels),
    );
    Image::from_layer(layer).write().to_file(path).unwrap();
}

fn exr(map: &EnvironmentMap, path: &Path, half: bool, names: [&str; 3], encoding: Encoding) {
    let channel = |k: usize| {
        let values = map.texels.iter().map(|texel| texel[k]);
        let samples = if half {
            FlatSamples::F16(values.map(f16::from_f32).collect())
        } else {
            FlatSamples::F32(values.collect())
        };
        AnyChannel::new(names[k], samples)
    };
    let layer = Layer::new(
        (map.width, map.height),
        LayerAttributes::named("map"),
        encoding,
        AnyChannels::sort([0, 1, 2].map(channel).into_iter().collect()),
    );
    Image::from_layer(layer).write().to_file(path).unwrap();
}

/// The largest of three values as a power of 2 that is above it, as a Radiance file has it.
fn exponent(texel: &[f32; 3]) -> i32 {
    let largest = texel.iter().fold(0.0f32, |most, value| most.max(*value));
    (-126..128).find(|power| 2.0f32.powi(*power) > largest).unwrap()
}

/// Four bytes, of which the mantissas are cut off.
pub fn rgbe(texel: &[f32; 3]) -> [u8; 4] {
    if *texel == [0.0; 3] {
        return [0; 4];
    }
    let power = exponent(texel);
    let [r, g, b] = texel.map(|value| (value * 2.0f32.powi(8 - power)) as u8);
    [r, g, b, (power + 128) as u8]
}

/// A Radiance file with run lengths of each component, or pixel by pixel.
pub fn hdr_bytes(map: &EnvironmentMap, header: &str, is_coded: bool) -> Vec<u8> {
    let mut file = header.as_bytes().to_vec();
    for row in map.texels.chunks(map.width) {
        let pixels: Vec<_> = row.iter().map(rgbe).collect();
        if !is_coded {
            file.extend(pixels.as_flattened());
            continue;
        }
        file.extend([2, 2, (map.width >> 8) as u8, map.width as u8]);
        for component in 0..4 {
            let values: Vec<u8> = pixels.iter().map(|pixel| pixel[component]).collect();
            for run in values.chunk_by(|a, b| a == b).flat_map(|run| run.chunks(127)) {
                match run {
                    [one] => file.extend([1, *one]),
                    _ => file.extend([128 + run.len() as u8, run[0]]),
                }
            }
        }
    }
    file
}

fn hdr(map: &EnvironmentMap, path: &Path) {
    let size = format!("-Y {} +X {}\n", map.height, map.width);
    let header = format!("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n{size}");
    fs::write(path, hdr_bytes(map, &header, (8..0x8000).contains(&map.width))).unwrap();
}

pub fn pfm(map: &EnvironmentMap, path: &Path, magic: &str, order: &str, bytes: fn(f32) -> [u8; 4]) {
    let mut file = format!("{magic}\n{} {}\n{order}\n", map.width, map.height).into_bytes();
    let channels = if magic == "PF" { 3 } else { 1 };
    for row in map.texels.chunks(map.width).rev() {
        for value in row.iter().flat_map(|texel| &texel[..channels]) {
            file.extend(bytes(*value));
        }
    }
    fs::write(path, file).unwrap();
}

/// The message about a file, from its name on.
pub fn message(name: &str, bytes: &[u8]) -> String {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join(name);
    fs::write(&path, bytes).unwrap();
    refusal(&path)
}

/// The message about the file at a path, from its name on.
pub fn refusal(path: &Path) -> String {
    let read = EnvironmentMap::from_path(path).map(|map| (map.width, map.height));
    let text = read.unwrap_err().to_string();
    assert!(!text.contains('\n'), "one line: {text}");
    let name = path.file_name().unwrap().to_str().unwrap();
    text[text.find(name).unwrap()..].to_owned()
}
