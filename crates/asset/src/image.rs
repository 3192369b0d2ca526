//! The pixels of textures: PNG and JPEG.

use eigenshade_model::error::{Error, Result};
use png::{ColorType, Decoder, Limits, Transformations};
use std::io::Cursor;
use zune_jpeg::JpegDecoder;
use zune_jpeg::zune_core::colorspace::ColorSpace;
use zune_jpeg::zune_core::options::DecoderOptions;

/// The most pixels of a texture: 8192 x 8192.
const MOST_PIXELS: usize = 1 << 26;

/// The most pixels that a byte holds: 1032 bytes of deflate's output, of eight pixels each. Every
/// block of 8 x 8 pixels of a JPEG takes a bit at least.
const MOST_PIXELS_PER_BYTE: usize = 1032 * 8;

/// Pixels of four channels, row by row from the top.
#[derive(Clone, Debug, PartialEq)]
pub struct Image {
    /// Pixels across and down.
    pub size: [usize; 2],
    /// Red, green, blue and opacity of each pixel, from 0 to 65535.
    pub pixels: Vec<[u16; 4]>,
}

impl Image {
    /// Decodes a PNG or a JPEG. Gray is three equal channels.
    ///
    /// # Errors
    ///
    /// If the bytes are of another type, broken or cut short, claim more pixels than they can hold,
    /// or have more than 2²⁶.
    pub fn decode(bytes: &[u8]) -> Result<Self> {
        match bytes {
            [0x89, b'P', b'N', b'G', ..] => decode_png(bytes),
            [0xff, 0xd8, 0xff, ..] => decode_jpeg(bytes),
            _ => Err(Error::new("it is neither a PNG nor a JPEG", "convert it to PNG")),
        }
    }
}

/// Checks the size that a header claims.
fn check([width, height]: [usize; 2], bytes: &[u8]) -> Result<()> {
    let count = width.saturating_mul(height);
    let most = MOST_PIXELS.min(bytes.len().saturating_mul(MOST_PIXELS_PER_BYTE));
    if count == 0 || count > most {
        let what = format!("{width} x {height} pixels in {} bytes", bytes.len());
        return Err(Error::new(what, "use a texture of at most 8192 x 8192"));
    }
    Ok(())
}

fn broken(error: impl std::fmt::Display) -> Error {
    let what = format!("it is broken or cut short ({error})").replace('\n', " ");
    Error::new(what, "export the texture again")
}

fn decode_png(bytes: &[u8]) -> Result<Image> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    let header = decoder.read_header_info().map_err(broken)?;
    let size = [header.width as usize, header.height as usize];
    check(size, bytes)?;
    // A row of four channels of 16 bits, and buffers of chunks.
    decoder.set_limits(Limits { bytes: 8 * size[0] + 4 * bytes.len() + (1 << 16) });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(broken)?;
    let (color, depth) = reader.output_color_type();
    let (channels, has_opacity) = match color {
        ColorType::Rgba => (4, true),
        ColorType::Rgb | ColorType::Indexed => (3, false),
        ColorType::GrayscaleAlpha => (2, true),
        ColorType::Grayscale => (1, false),
    };
    let wide = usize::from(depth == png::BitDepth::Sixteen);
    let pixel = |samples: &[u8]| {
        let at = |channel: usize| match wide {
            0 => 257 * u16::from(samples[channel]),
            _ => u16::from_be_bytes([samples[2 * channel], samples[2 * channel + 1]]),
        };
        let opacity = if has_opacity { at(channels - 1) } else { u16::MAX };
        match channels {
            1 | 2 => [at(0), at(0), at(0), opacity],
            _ => [at(0), at(1), at(2), opacity],
        }
    };
    let mut pixels = Vec::with_capacity(size[0] * size[1]);
    if reader.info().interlaced {
        let length = reader.output_buffer_size().ok_or_else(|| broken("its size"))?;
        let mut buffer = vec![0; length];
        reader.next_frame(&mut buffer).map_err(broken)?;
        pixels.extend(buffer.chunks_exact(channels << wide).map(pixel));
    } else {
        // Row by row: a whole picture would take half as much memory again.
        while let Some(row) = reader.next_row().map_err(broken)? {
            pixels.extend(row.data().chunks_exact(channels << wide).map(pixel));
        }
    }
    Ok(Image { size, pixels })
}

fn decode_jpeg(bytes: &[u8]) -> Result<Image> {
    // Without the strict mode, the decoder fills what is missing with gray.
    let options = DecoderOptions::default()
        .set_strict_mode(true)
        .set_max_width(usize::from(u16::MAX))
        .set_max_height(usize::from(u16::MAX))
        .jpeg_set_out_colorspace(ColorSpace::RGB);
    let fault = |error| broken(format!("{error:?}").replace('"', ""));
    let mut decoder = JpegDecoder::new_with_options(Cursor::new(bytes), options);
    decoder.decode_headers().map_err(fault)?;
    let (width, height) = decoder.dimensions().ok_or_else(|| broken("no size"))?;
    check([width, height], bytes)?;
    let samples = decoder.decode().map_err(fault)?;
    let wide = |sample: u8| 257 * u16::from(sample);
    let pixels = match samples.len() / (width * height) {
        1 => samples.iter().map(|gray| [wide(*gray); 3]).map(opaque).collect(),
        3 => samples.as_chunks().0.iter().map(|rgb: &[u8; 3]| opaque(rgb.map(wide))).collect(),
        channels => return Err(broken(format!("{channels} channels"))),
    };
    Ok(Image { size: [width, height], pixels })
}

fn opaque([r, g, b]: [u16; 3]) -> [u16; 4] {
    [r, g, b, u16::MAX]
}
