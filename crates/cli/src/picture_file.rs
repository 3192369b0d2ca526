//! Files of drawn pictures: sRGB as PNG, or linear numbers as OpenEXR.

#[cfg(feature = "generate")]
use eigenshade::Rgb;
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::picture::{Development, Draw};
use std::path::Path;

/// The kinds of picture files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PictureFile {
    /// 8 bits a channel in sRGB.
    Png,
    /// Linear 32-bit floats, multiplied by opacity.
    Exr,
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
            Self::Png => development.write_png(path, size, draw),
            Self::Exr => exr(path, size, development, draw),
        }
    }
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
