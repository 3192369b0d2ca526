//! A photograph or rendering as irradiance: linear values with a weight for each pixel.

use crate::picture::linear;
use eigenshade_generator::light::environment::EnvironmentMap;
use eigenshade_generator::png_samples;
use eigenshade_generator::png_samples::Curve;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::Sheet;

/// Bytes per pixel of a [`LinearImage`] while it is read, including its weight and its normal.
const BYTES_PER_PIXEL: u64 = 136;

/// How the samples of a PNG encode light.
#[derive(Clone, Copy, Debug, PartialEq, Eq, clap::ValueEnum)]
pub enum Transfer {
    /// Proportional to the light
    Linear,
    /// The curve of IEC 61966-2-1
    Srgb,
}

/// An image in linear units.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearImage {
    /// Width and height in pixels; `None` for a list of pixels.
    pub size: Option<[usize; 2]>,
    /// r, g, b of each pixel, row by row from the top. The full scale of a PNG is 1.
    pub pixels: Vec<[f64; 3]>,
    /// The weight of each pixel: its opacity, or 0 if it is clipped.
    pub weights: Vec<f64>,
    /// The number of pixels left out because one of their channels is at full scale.
    pub clipped: usize,
    /// The number of pixels left out because they are transparent.
    pub transparent: usize,
}

impl LinearImage {
    /// Reads a `.png`, an environment map's file types (`.exr`, `.hdr`, `.pfm`), or a CSV with the
    /// columns `r,g,b` or `value` and one row per pixel.
    ///
    /// Without a `transfer`, a PNG is read with the curve that it declares ([`Curve`]). A PNG that
    /// declares no curve is read as sRGB if it has 8 bits, as cameras and programs write such
    /// files, and as linear if it has 16. The other types are linear. The true value of a clipped
    /// pixel is unknown, so its weight is 0.
    ///
    /// # Errors
    ///
    /// If the file has another type, cannot be read or is broken; if a transfer is given for a type
    /// that has none, or none is given for a PNG that declares another curve; if numbers are not
    /// finite.
    pub fn read(file: impl Into<InputFile>, transfer: Option<Transfer>) -> Result<Self> {
        let file = file.into().with_bytes_beside(BYTES_PER_PIXEL);
        let path = file.path();
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let ending = ending.to_ascii_lowercase();
        if ending == "png" {
            return Self::of_png(&file, transfer);
        }
        if transfer.is_some() {
            let what = "only PNGs have a transfer function; this file is linear";
            return Err(Error::new(what, "leave --transfer out").in_file(path));
        }
        match ending.as_str() {
            "csv" => Self::of_csv(file),
            "exr" | "hdr" | "pfm" => {
                let map = EnvironmentMap::from_path(file)?;
                let pixels = map.texels.iter().map(|texel| texel.map(f64::from)).collect();
                Ok(Self::whole(Some([map.width, map.height]), pixels))
            }
            _ => Err(Error::new(
                "it is not an image of a supported type",
                "give a file that ends in .png, .exr, .hdr, .pfm or .csv",
            )
            .in_file(path)),
        }
    }

    fn whole(size: Option<[usize; 2]>, pixels: Vec<[f64; 3]>) -> Self {
        Self { size, weights: vec![1.0; pixels.len()], pixels, clipped: 0, transparent: 0 }
    }

    fn of_png(file: &InputFile, transfer: Option<Transfer>) -> Result<Self> {
        let png = png_samples::read(file.clone())?;
        let full = f64::from(png.full);
        let transfer = match (transfer, &png.curve) {
            (Some(transfer), _) => transfer,
            (None, Curve::Linear) => Transfer::Linear,
            (None, Curve::Srgb) => Transfer::Srgb,
            (None, Curve::Undeclared) if png.full == u16::from(u8::MAX) => Transfer::Srgb,
            (None, Curve::Undeclared) => Transfer::Linear,
            (None, Curve::Other(what)) => {
                let what = format!("{what}, which is not a supported transfer function");
                let remedy = "give --transfer linear or --transfer srgb";
                return Err(Error::new(what, remedy).in_file(file.path()));
            }
        };
        let value = |sample: u16| match transfer {
            Transfer::Linear => f64::from(sample) / full,
            Transfer::Srgb => linear(f64::from(sample) / full),
        };
        let pixels = png.colors.iter().map(|color| color.map(value)).collect();
        let mut image = Self::whole(Some([png.width, png.height]), pixels);
        for ((weight, color), opacity) in
            image.weights.iter_mut().zip(&png.colors).zip(&png.opacities)
        {
            let clips = color.contains(&png.full);
            *weight = if clips { 0.0 } else { f64::from(*opacity) / full };
            image.transparent += usize::from(*opacity == 0);
            image.clipped += usize::from(clips && *opacity > 0);
        }
        Ok(image)
    }

    fn of_csv(file: InputFile) -> Result<Self> {
        let sheet = Sheet::read(file, "r,g,b")?;
        let columns = sheet.colors()?.ok_or_else(|| sheet.wrong_header("`r,g,b` or `value`"))?;
        let mut pixels = Vec::new();
        for row in sheet.rows() {
            let mut pixel = [0.0; 3];
            for (channel, column) in pixel.iter_mut().zip(columns) {
                *channel = row.number(column)?;
            }
            pixels.push(pixel);
        }
        Ok(Self::whole(None, pixels))
    }

    /// Whether the three channels are equal in every pixel.
    #[must_use]
    pub fn is_gray(&self) -> bool {
        self.pixels.iter().all(|[r, g, b]| r == g && g == b)
    }
}
