//! Environment maps as files: OpenEXR, Radiance, portable float maps, and pictures.

use crate::light::environment::{EnvironmentMap, believable, broken, other_type};
use crate::light::{map_exr, map_hdr, map_picture};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::meta::attribute::EnvironmentMap as Stated;
use std::fs;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};

/// The endings of maps' names, as in the messages.
const ENDINGS: &str = ".exr, .hdr, .pfm, .png or .jpg";

/// The largest half float. A program that writes halves leaves brighter light at it.
const LARGEST_HALF: f32 = 65504.0;

impl EnvironmentMap {
    /// Reads an OpenEXR (`.exr`), Radiance (`.hdr`) or portable float map (`.pfm`), or a picture
    /// (`.png`, `.jpg`, `.jpeg`), whose samples are decoded by the curve of sRGB: white is a
    /// radiance of 1. A PNG that declares linear samples is read as such.
    ///
    /// The result is in linear sRGB and as a viewer shows it: other primaries are converted, and
    /// the orientation of a picture's EXIF data is applied. Warnings name what is converted,
    /// chosen among several layers, and ignored: opacity, color profiles, exposure.
    ///
    /// # Errors
    ///
    /// If the file cannot be read, is of another type, is broken, has no texels or a texel that is
    /// not finite, is a cube as its attribute `envmap` states, or has more than
    /// [`MOST_TEXELS`](crate::light::environment::MOST_TEXELS).
    pub fn from_path(file: impl Into<InputFile>) -> Result<Self> {
        let file = file.into();
        match read(&file)? {
            (_, Some(Stated::Cube)) => {
                let what = "it is a cube, as its attribute `envmap` states";
                let remedy = "convert it to an equirectangular map, as by exrenvmap -latlong";
                Err(Error::new(what, remedy).in_file(file.path()))
            }
            (map, _) => Ok(map),
        }
    }

    /// Reads an OpenEXR file as a picture: its colors as they are, which are multiplied by opacity,
    /// and the opacity of each texel, of which there are none if the file has no channel A.
    ///
    /// # Errors
    ///
    /// Those of [`from_path`](Self::from_path).
    pub fn with_opacities(file: impl Into<InputFile>) -> Result<(Self, Vec<f32>)> {
        let file = file.into();
        let (mut reader, length) = file.open()?;
        let found = map_exr::decode(&mut reader, length, &file, true)
            .map_err(|error| error.in_file(file.path()))?;
        warn_of_limit(&found.map, &file);
        Ok((found.map, found.opacities))
    }
}

/// Reads a map, and the projection that it states.
pub(crate) fn read(file: &InputFile) -> Result<(EnvironmentMap, Option<Stated>)> {
    let path = file.path();
    let decode = decoder(path).ok_or_else(|| {
        Error::new("it is not an environment map", format!("give a file that ends in {ENDINGS}"))
            .in_file(path)
    })?;
    let (mut reader, length) = file.open()?;
    let (map, stated) = decode(&mut reader, length, file).map_err(|error| error.in_file(path))?;
    warn_of_limit(&map, file);
    Ok((map, stated))
}

fn warn_of_limit(map: &EnvironmentMap, file: &InputFile) {
    let count = map.texels.iter().filter(|texel| texel.contains(&LARGEST_HALF)).count();
    if count > 0 {
        file.warn(format!(
            "texels at {LARGEST_HALF}, the largest half float: {count}; light that is brighter was \
             clipped when the map was saved, so that lamps or the sun are too dark"
        ));
    }
}

type Decode = fn(&mut BufReader<File>, u64, &InputFile) -> Result<(EnvironmentMap, Option<Stated>)>;

/// The decoder for a file of this name.
fn decoder(path: &Path) -> Option<Decode> {
    match extension(path)?.as_str() {
        "exr" => Some(|reader, length, file| {
            let found = map_exr::decode(reader, length, file, false)?;
            Ok((found.map, found.projection))
        }),
        "hdr" => Some(|reader, length, file| Ok((map_hdr::decode(reader, length, file)?, None))),
        "pfm" => Some(|reader, length, file| Ok((decode_pfm(reader, length, file)?, None))),
        "png" => Some(|reader, _, file| Ok((map_picture::decode_png(reader, file)?, None))),
        "jpg" | "jpeg" => {
            Some(|reader, _, file| Ok((map_picture::decode_jpeg(reader, file)?, None)))
        }
        _ => None,
    }
}

/// Whether a file has the ending of a map.
fn is_map(path: &Path) -> bool {
    decoder(path).is_some()
}

/// The maps of a folder, sorted by name.
pub(crate) fn maps_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let fault = |error: std::io::Error| Error::io(folder, &error);
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        if is_map(&path) && path.is_file() {
            files.push(path);
        }
    }
    if files.is_empty() {
        return Err(Error::new(
            "there is no map in this folder",
            format!("give a folder with {ENDINGS} files"),
        )
        .in_file(folder));
    }
    files.sort();
    Ok(files)
}

/// Whether a file has the ending of a picture, which clips light at white.
#[must_use]
pub fn is_picture(path: &Path) -> bool {
    matches!(extension(path).as_deref(), Some("png" | "jpg" | "jpeg"))
}

/// The extension of a file name, in lower case.
pub(crate) fn extension(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

/// Decodes a portable float map (`.pfm`) of either byte order: `PF` (color) or `Pf` (gray), width,
/// height, and a number whose sign gives the byte order, followed by the rows from the bottom up.
/// The lines of the header may end in CR LF.
///
/// This crate reads them itself because `zune-ppm` 0.5.1 mixes up the rows of a map of odd height.
/// The magnitude of the number that gives the byte order, sometimes called a scale, is not applied;
/// a warning names one other than 1.
fn decode_pfm(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    // A header is far shorter than the buffer.
    let beginning = reader.fill_buf().map_err(io)?;
    let (magic, rest) = header_word(beginning).ok_or_else(|| other_type("PFM"))?;
    let channels = match magic {
        "PF" => 3,
        "Pf" => 1,
        _ => return Err(other_type("PFM")),
    };
    let (width, rest) = header_number::<usize>(rest, "width")?;
    let (height, rest) = header_number::<usize>(rest, "height")?;
    let (scale, rest) = header_number::<f32>(rest, "byte order")?;
    if scale == 0.0 || !scale.is_finite() {
        return Err(broken(format!("its header gives the byte order as {scale}")).with_remedy(
            "write -1 for the order of little-endian bytes, 1 for that of big-endian ones",
        ));
    }
    let count = believable(width, height, length)?;
    let expected = 4 * (channels * count) as u64;
    let mut header = beginning.len() - rest.len();
    let is_longer = length - header as u64 > expected;
    // The last line ends in CR LF, and the LF is no sample.
    if beginning[..header].ends_with(b"\r") && rest.starts_with(b"\n") && is_longer {
        header += 1;
    }
    let found = length - header as u64;
    if expected > found {
        return Err(broken(format!(
            "its header promises {expected} bytes of pixels, but it has {found}"
        )));
    }
    if expected < found {
        file.warn(format!("bytes after its last row are ignored: {}", found - expected));
    }
    if scale.abs() != 1.0 {
        file.warn(format!("its scale, {}, is not applied", scale.abs()));
    }
    reader.consume(header);
    let mut row = vec![0; 4 * channels * width];
    let mut texels = vec![[0.0; 3]; count];
    let decode = if scale < 0.0 { f32::from_le_bytes } else { f32::from_be_bytes };
    for texels in texels.chunks_exact_mut(width).rev() {
        reader.read_exact(&mut row).map_err(io)?;
        let values = row.as_chunks::<4>().0.chunks_exact(channels);
        for (texel, values) in texels.iter_mut().zip(values) {
            *texel = match *values {
                [r, g, b] => [decode(r), decode(g), decode(b)],
                [gray, ..] => [decode(gray); 3],
                [] => [0.0; 3],
            };
        }
    }
    EnvironmentMap::new(width, height, texels)
}

/// The next word of the header, and the bytes after the single blank that ends it.
fn header_word(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let bytes = bytes.trim_ascii_start();
    // No word of a header is longer; a file of another type may contain no blank at all.
    let end = bytes.iter().take(32).position(u8::is_ascii_whitespace)?;
    let (word, rest) = bytes.split_at(end);
    Some((std::str::from_utf8(word).ok()?, &rest[1..]))
}

fn header_number<'a, T: std::str::FromStr>(bytes: &'a [u8], what: &str) -> Result<(T, &'a [u8])> {
    header_word(bytes)
        .and_then(|(word, rest)| Some((word.parse().ok()?, rest)))
        .ok_or_else(|| broken(format!("no {what} in its header")))
}
