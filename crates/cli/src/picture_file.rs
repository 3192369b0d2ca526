//! Files of drawn pictures: sRGB as PNG, or linear numbers as OpenEXR.

use crate::picture::{Pixel, write_png};
use eigenshade::Rgb;
use eigenshade::screen::{Display, Exposure, Meter, Tone};
use eigenshade_model::error::{Error, Result};
use std::path::Path;

/// The kinds of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFile {
    /// 8 bits a channel in sRGB.
    Png,
    /// Linear 32-bit floats, multiplied by opacity.
    Exr,
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

impl PictureFile {
    /// The kind of a file, by its extension. Fails if the extension is neither `.png` nor `.exr`,
    /// or this build cannot write the file.
    pub fn of(path: &Path) -> Result<Self> {
        let extension = path.extension().unwrap_or_default().to_ascii_lowercase();
        match extension.to_str() {
            Some("png") => Ok(Self::Png),
            Some("exr") if cfg!(feature = "generate") => Ok(Self::Exr),
            Some("exr") => {
                let remedy = "write a .png, or build with the feature `generate`";
                Err(Error::new("this build writes no OpenEXR", remedy).in_file(path))
            }
            _ => {
                let what = match path.extension() {
                    Some(_) => "unknown kind of picture",
                    None => "its name has no extension, which decides the kind of picture",
                };
                let remedy = "name it .png for sRGB, or .exr for linear numbers";
                Err(Error::new(what, remedy).in_file(path))
            }
        }
    }

    /// Writes a picture of `size` pixels across and down. Metering draws it once more. Fails as
    /// `draw` does, or if the file, its folder or the disk fails, or if the picture is too large.
    pub fn write(
        self,
        path: &Path,
        size: [usize; 2],
        development: Development,
        draw: &mut Draw<'_>,
    ) -> Result<()> {
        match self {
            Self::Png => png(path, size, development, draw),
            Self::Exr => exr(path, size, development, draw),
        }
    }
}

fn png(path: &Path, [width, height]: [usize; 2], how: Development, draw: &mut Draw) -> Result<()> {
    let exposure = match how.exposure {
        Some(exposure) => exposure,
        None => metered(how, draw)?.unwrap_or_default(),
    };
    let display = Display::new(how.tone);
    let channels = if how.is_opaque { 3 } else { 4 };
    let mut bytes = vec![0; channels * width * height];
    draw(&mut |pixel, color| {
        let Rgb { r, g, b } = display.rgb888(exposure.of(color));
        let start = channels * (pixel.row * width + pixel.column);
        let opacity = (255.0 * pixel.coverage).round() as u8;
        bytes[start..start + channels].copy_from_slice(&[r, g, b, opacity][..channels]);
    })?;
    write_png(path, width, height, &bytes)
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

#[cfg(feature = "generate")]
fn exr(path: &Path, [width, height]: [usize; 2], how: Development, draw: &mut Draw) -> Result<()> {
    use eigenshade_model::output::write_atomically;
    use exr::prelude::{
        Encoding, Image, Layer, LayerAttributes, SpecificChannels, Vec2, WritableImage,
    };
    let exposure = how.exposure.unwrap_or_default();
    let mut colors = vec![[0.0_f32; 4]; width * height];
    draw(&mut |pixel, color| {
        let opacity = pixel.coverage as f32;
        let Rgb { r, g, b } = exposure.of(color).map(|channel| channel * opacity);
        colors[pixel.row * width + pixel.column] = [r, g, b, opacity];
    })?;
    let at = |Vec2(column, row)| colors[row * width + column];
    let mut bytes = std::io::Cursor::new(Vec::new());
    // Scan lines from the top in ZIP, which every reader has.
    let (encoding, named) = (Encoding::SMALL_LOSSLESS, LayerAttributes::default());
    let written = if how.is_opaque {
        let channels = SpecificChannels::rgb(|place| {
            let [r, g, b, _] = at(place);
            (r, g, b)
        });
        let layer = Layer::new((width, height), named, encoding, channels);
        Image::from_layer(layer).write().to_buffered(&mut bytes)
    } else {
        let channels = SpecificChannels::rgba(|place| <(f32, f32, f32, f32)>::from(at(place)));
        let layer = Layer::new((width, height), named, encoding, channels);
        Image::from_layer(layer).write().to_buffered(&mut bytes)
    };
    written.map_err(|error| Error::new(error.to_string(), "ask for a smaller picture"))?;
    write_atomically(path, |out| {
        out.write_all(bytes.get_ref()).map_err(|error| Error::io(path, &error))
    })
}

#[cfg(not(feature = "generate"))]
fn exr(path: &Path, _size: [usize; 2], _how: Development, _draw: &mut Draw) -> Result<()> {
    PictureFile::of(path).map(drop)
}
