//! PNG files.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::write_atomically;
use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};
use std::path::Path;

/// Writes an sRGB picture with 8 bits per channel and three channels, or four with opacity.
///
/// # Errors
///
/// If the file, its folder or the disk fails.
pub fn write(path: &Path, width: usize, height: usize, bytes: &[u8]) -> Result<()> {
    let side = |pixels: usize| {
        u32::try_from(pixels).map_err(|_| Error::new("the picture is too large", "ask for less"))
    };
    let (columns, rows) = (side(width)?, side(height)?);
    let has_opacity = bytes.len() == 4 * width * height;
    write_atomically(path, |out| {
        let mut encoder = Encoder::new(out, columns, rows);
        encoder.set_color(if has_opacity { ColorType::Rgba } else { ColorType::Rgb });
        encoder.set_depth(BitDepth::Eight);
        encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
        let fault = |error: png::EncodingError| {
            Error::new(error.to_string(), "check where the output goes")
        };
        let mut writer = encoder.write_header().map_err(fault)?;
        writer.write_image_data(bytes).map_err(fault)?;
        writer.finish().map_err(fault)
    })
}
