//! Pictures from irradiances: exposure, tone and PNG files.

use eigenshade::Rgb;
use eigenshade::screen::{Display, Exposure, Meter, Tone};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::output::{write_atomically, write_error};
use png::{BitDepth, ColorType, Encoder, SrgbRenderingIntent};
use std::path::Path;

/// One pixel of an object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pixel {
    /// Column, from the left.
    pub column: usize,
    /// Row, from the top.
    pub row: usize,
    /// The approximate share of the pixel that the object covers.
    pub coverage: f64,
    /// Whether the center of the pixel lies on the object.
    pub is_inside: bool,
}

/// Draws a picture: calls its argument with each pixel and its irradiance. It may be called again.
pub type Draw<'a> = dyn FnMut(&mut dyn FnMut(Pixel, Rgb<f32>)) -> Result<()> + 'a;

/// How irradiances become pixels.
#[derive(Clone, Copy, Debug)]
pub struct Development {
    /// The factor from irradiance to what the tone curve shows; for an .exr, from irradiance to its
    /// numbers. Without, a PNG is metered, and an .exr has 1.
    pub exposure: Option<Exposure>,
    /// The tone curve of a PNG.
    pub tone: Tone,
    /// Whether every pixel is opaque.
    pub is_opaque: bool,
}

impl Development {
    /// Writes a picture of `size` pixels across and down in sRGB. Metering draws it once more.
    ///
    /// # Errors
    ///
    /// Those of `draw`; and if the file, its folder or the disk fails, or the picture is too large.
    pub fn write_png(self, path: &Path, size: [usize; 2], draw: &mut Draw<'_>) -> Result<()> {
        let [width, height] = size;
        let exposure = match self.exposure {
            Some(exposure) => exposure,
            None => metered(self, draw)?.unwrap_or_default(),
        };
        let display = Display::new(self.tone);
        let channels = if self.is_opaque { 3 } else { 4 };
        let mut bytes = vec![0; channels * width * height];
        draw(&mut |pixel, color| {
            let Rgb { r, g, b } = display.rgb888(exposure.of(color));
            let start = channels * (pixel.row * width + pixel.column);
            let opacity = (255.0 * pixel.coverage).round() as u8;
            bytes[start..start + channels].copy_from_slice(&[r, g, b, opacity][..channels]);
        })?;
        write_png(path, width, height, &bytes)
    }
}

/// The exposure of a picture; `None` if it is black. A meter reaches from 2^-16 to 2^16, so that a
/// picture with its peak near an end or beyond is drawn again, with its peak at 1.
fn metered(how: Development, draw: &mut Draw) -> Result<Option<Exposure>> {
    let mut exposed = |factor: f32| {
        let (mut meter, mut peak) = (Meter::default(), 0.0_f32);
        draw(&mut |pixel, color| {
            // A matcap repeats its rim in the corners.
            if pixel.is_inside || !how.is_opaque {
                peak = peak.max(color.largest());
                meter.add(color.map(|channel| factor * channel));
            }
        })?;
        let exposure = meter.exposure().map(|one| factor * one.factor());
        Ok((exposure.and_then(|factor| Exposure::new(factor).ok()), peak))
    };
    let (exposure, peak) = exposed(1.0)?;
    if peak == 0.0 || (2.0_f32.powi(-6)..2.0_f32.powi(15)).contains(&peak) {
        return Ok(exposure);
    }
    Ok(exposed(peak.recip())?.0)
}

/// Writes an sRGB picture with 8 bits per channel and three channels, or four with opacity.
///
/// # Errors
///
/// If the file, its folder or the disk fails.
pub fn write_png(path: &Path, width: usize, height: usize, bytes: &[u8]) -> Result<()> {
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
        let mut writer = encoder.write_header().map_err(write_error)?;
        writer.write_image_data(bytes).map_err(write_error)?;
        writer.finish().map_err(write_error)
    })
}
