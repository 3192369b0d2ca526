//! A PNG as the numbers that it stores, without any reading of what they mean.

use super::png_curve::Curve;
use crate::error::{Error, Result};
use png::{BitDepth, ColorType, Decoder, DecodingError, Limits, Transformations};
use std::io::Cursor;
use std::path::Path;

/// The most pixels: expanded they take twelve bytes each, which a small file can claim.
const MOST_PIXELS: u64 = 1 << 26;

/// Four channels of 16 bits.
const MOST_BYTES_PER_PIXEL: u64 = 8;

/// Bytes for what is small.
const BESIDE: u64 = 1 << 16;

/// Deflate packs no more bytes than this into one.
const MOST_BYTES_PER_BYTE: u64 = 1032;

/// The samples of a PNG, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct PngSamples {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// The largest sample that the file can hold: 255 or 65535.
    pub full: u16,
    /// What the file itself says of how samples stand for light.
    pub curve: Curve,
    /// Red, green and blue of each pixel; three times the same in a grey file.
    pub colours: Vec<[u16; 3]>,
    /// Opacity of each pixel; `full` everywhere in a file without.
    pub opacities: Vec<u16>,
}

/// Reads a PNG of any colour type, 1 to 16 bits; of an animation the first frame.
///
/// # Errors
///
/// A file that cannot be read, is no PNG, broken, cut short, or claims more pixels
/// than its bytes can hold.
pub fn read(path: &Path) -> Result<PngSamples> {
    let bytes = std::fs::read(path).map_err(|error| Error::io(path, &error))?;
    decode(&bytes).map_err(|error| error.in_file(path))
}

fn decode(bytes: &[u8]) -> Result<PngSamples> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    // A colour profile or a text may unpack to a thousand times its size, and neither is wanted.
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    let header = decoder.read_header_info().map_err(|error| fault(&error))?;
    let (width, height) = (u64::from(header.width), u64::from(header.height));
    let bits = (header.bits_per_pixel() as u64).max(1);
    let most = (bytes.len() as u64).saturating_mul(MOST_BYTES_PER_BYTE);
    if width * height > MOST_PIXELS {
        return Err(Error::new(
            format!("its header claims {width} x {height} pixels"),
            "give a picture of at most 67 million pixels, 8192 x 8192",
        ));
    }
    if width * height / 8 * bits > most {
        return Err(Error::new(
            format!(
                "its header claims {width} x {height} pixels, which {} bytes cannot hold",
                bytes.len()
            ),
            "export the picture again",
        ));
    }
    // A row of the picture, and buffers of other chunks, which are doubled as they are read.
    let limit = (MOST_BYTES_PER_PIXEL * width).saturating_add(4 * bytes.len() as u64);
    decoder.set_limits(Limits { bytes: usize::try_from(limit + BESIDE).unwrap_or(usize::MAX) });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| fault(&error))?;
    let curve = Curve::of(reader.info(), bytes);
    let size = reader.output_buffer_size().ok_or_else(|| fault(&DecodingError::LimitsExceeded))?;
    let mut buffer = vec![0; size];
    let frame = reader.next_frame(&mut buffer).map_err(|error| fault(&error))?;
    buffer.truncate(frame.buffer_size());
    // The end is where a file that was cut short is found out.
    reader.finish().map_err(|error| fault(&error))?;
    let (samples, full) = match frame.bit_depth {
        BitDepth::Sixteen => (
            buffer.as_chunks::<2>().0.iter().map(|pair| u16::from_be_bytes(*pair)).collect(),
            u16::MAX,
        ),
        _ => (buffer.iter().map(|byte| u16::from(*byte)).collect::<Vec<u16>>(), u16::from(u8::MAX)),
    };
    let (channels, has_opacity) = match frame.color_type {
        ColorType::Rgba => (4, true),
        ColorType::Rgb | ColorType::Indexed => (3, false),
        ColorType::GrayscaleAlpha => (2, true),
        ColorType::Grayscale => (1, false),
    };
    let pixels = || samples.chunks_exact(channels);
    Ok(PngSamples {
        width: frame.width as usize,
        height: frame.height as usize,
        full,
        curve,
        colours: pixels()
            .map(|pixel| match pixel {
                [r, g, b, ..] => [*r, *g, *b],
                [grey, ..] => [*grey; 3],
                [] => [0; 3],
            })
            .collect(),
        opacities: pixels()
            .map(|pixel| if has_opacity { pixel[channels - 1] } else { full })
            .collect(),
    })
}

fn fault(error: &DecodingError) -> Error {
    Error::new(
        format!("it is no PNG, or broken or cut short ({error})"),
        "check the file, or export the picture again as PNG",
    )
}
