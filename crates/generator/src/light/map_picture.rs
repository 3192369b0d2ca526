//! Pictures as environment maps: PNG and JPEG, of samples from 0 to white.
//!
//! The samples are decoded by the curve of sRGB, so that white is a radiance of 1. The orientation
//! of EXIF data is applied, and primaries that a PNG states are converted. Opacity and color
//! profiles are ignored, with a warning.

use crate::light::environment::{EnvironmentMap, believable, broken, other_type};
use crate::light::primaries::product;
use crate::orientation::Orientation;
use crate::png_samples::{self, Curve};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::srgb::linear;
use std::fs::File;
use std::io::{BufRead, BufReader, Cursor};
use zune_jpeg::JpegDecoder;
use zune_jpeg::errors::DecodeErrors;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// Decodes a PNG of any color type and depth. A file that declares its samples to be linear is read
/// as linear, any other as sRGB.
pub(crate) fn decode_png(reader: &mut BufReader<File>, file: &InputFile) -> Result<EnvironmentMap> {
    check_signature(reader, file, b"\x89PNG\r\n\x1a\n", "PNG")?;
    let png = png_samples::read(file.clone())?;
    let curve = match &png.curve {
        Curve::Linear => |code| code,
        Curve::Undeclared | Curve::Srgb | Curve::Profile(_) => linear,
        Curve::Other(what) => {
            return Err(Error::new(
                format!("{what}, which is not a supported transfer function"),
                "export the map as sRGB, or better as .exr or .hdr",
            ));
        }
    };
    if let Curve::Profile(name) = &png.curve
        && !name.contains("sRGB")
    {
        file.warn(format!("its color profile `{name}` is ignored: it is read as sRGB"));
    }
    if png.opacities.iter().any(|opacity| *opacity < png.full) {
        file.warn("its opacity is ignored");
    }
    if png.to_srgb.is_some() {
        file.warn("its primaries are not those of sRGB: its colors are converted");
    }
    let png = png.upright();
    let radiance = radiances(png.full, curve);
    let texel = |color: &[u16; 3]| {
        let color = color.map(|sample| radiance[usize::from(sample)]);
        match &png.to_srgb {
            Some(matrix) => product(matrix, color.map(f64::from)).map(|value| value as f32),
            None => color,
        }
    };
    EnvironmentMap::new(png.width, png.height, png.colors.iter().map(texel).collect())
}

/// Every block of 8 x 8 pixels takes a bit at least.
const MOST_PIXELS_PER_BYTE: u64 = 512;

/// The largest side of a JPEG.
const LONGEST_SIDE: usize = u16::MAX as usize;

/// Decodes a JPEG, baseline or progressive, gray or in color.
pub(crate) fn decode_jpeg(
    reader: &mut BufReader<File>,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    check_signature(reader, file, &[0xff, 0xd8, 0xff], "JPEG")?;
    let bytes = file.bytes()?;
    let length = bytes.len() as u64;
    // Without the strict mode, the decoder fills what is missing with gray.
    let options = DecoderOptions::default()
        .set_strict_mode(true)
        .set_max_width(LONGEST_SIDE)
        .set_max_height(LONGEST_SIDE)
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(&bytes), options);
    decoder.decode_headers().map_err(jpeg_fault)?;
    let (width, height) = decoder.dimensions().ok_or_else(|| broken("no size in its header"))?;
    let count = believable(width, height, length)?;
    let pixels = count as u64;
    if pixels > MOST_PIXELS_PER_BYTE * length {
        return Err(broken(format!("{length} bytes cannot hold its {width} x {height} pixels")));
    }
    let samples = decoder.decode().map_err(jpeg_fault)?;
    let orientation = decoder.exif().and_then(|data| Orientation::of_exif(data));
    if decoder.icc_profile().is_some_and(|profile| !is_srgb(&profile)) {
        file.warn("its color profile is ignored: it is read as sRGB");
    }
    drop(decoder);
    if !ends(&bytes) {
        return Err(broken("the marker of its end is missing"));
    }
    let colors: Vec<[u8; 3]> = match samples.len() / count {
        1 => samples.iter().map(|gray| [*gray; 3]).collect(),
        3 => samples.as_chunks().0.to_vec(),
        channels => {
            return Err(Error::new(
                format!("it has {channels} channels"),
                "export it in RGB or gray",
            ));
        }
    };
    drop(samples);
    let orientation = orientation.unwrap_or_default();
    let colors = orientation.picture(colors, [width, height]);
    let [width, height] = orientation.size([width, height]);
    let radiance = radiances(u16::from(u8::MAX), linear);
    let texel = |color: [u8; 3]| color.map(|sample| radiance[usize::from(sample)]);
    EnvironmentMap::new(width, height, colors.into_iter().map(texel).collect())
}

/// Whether a color profile names sRGB, in one byte or two for a letter.
fn is_srgb(profile: &[u8]) -> bool {
    let names = |name: &[u8]| profile.windows(name.len()).any(|part| part == name);
    names(b"sRGB") || names(b"s\0R\0G\0B")
}

fn jpeg_fault(error: DecodeErrors) -> Error {
    match error {
        DecodeErrors::Unsupported(_) => Error::new(
            "it is of a kind of JPEG that is not supported",
            "export it as baseline JPEG, in RGB or gray",
        ),
        error => broken(format!("{error:?}").replace(['"', '\n'], "")),
    }
}

/// Whether the marker of the end follows the last scan: its bytes occur in no packed data.
fn ends(bytes: &[u8]) -> bool {
    let last = |marker: u8| bytes.windows(2).rposition(|two| *two == [0xff, marker]);
    last(0xd9) > last(0xda)
}

fn check_signature(
    reader: &mut BufReader<File>,
    file: &InputFile,
    signature: &[u8],
    name: &str,
) -> Result<()> {
    let beginning = reader.fill_buf().map_err(|error| Error::io(file.path(), &error))?;
    if beginning.starts_with(signature) { Ok(()) } else { Err(other_type(name)) }
}

/// The radiance of each sample from 0 to `full`, which is white.
fn radiances(full: u16, curve: impl Fn(f64) -> f64) -> Vec<f32> {
    (0..=full).map(|sample| curve(f64::from(sample) / f64::from(full)) as f32).collect()
}
