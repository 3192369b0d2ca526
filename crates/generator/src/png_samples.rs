//! Reads the numbers that a PNG stores, and what the file says about how they represent light.

use crate::light::primaries::Primaries;
use crate::orientation::Orientation;
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use png::{BitDepth, ColorType, Decoder, DecodingError, Info, Limits, Transformations};
use std::io::Cursor;

/// The most pixels that are read: 8192 x 4096.
const MOST_PIXELS: u64 = 1 << 25;

/// Four channels of 16 bits.
const MOST_BYTES_PER_PIXEL: u64 = 8;

/// Bytes for small buffers.
const BESIDE: u64 = 1 << 16;

/// Deflate compresses at most this many bytes into one.
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
    /// How the samples represent light, according to the file.
    pub curve: Curve,
    /// Red, green and blue of each pixel; three equal values in a gray file.
    pub colors: Vec<[u16; 3]>,
    /// Opacity of each pixel; `full` everywhere if the file stores no opacity.
    pub opacities: Vec<u16>,
    /// The matrix from linear values to linear sRGB, if the file declares other primaries.
    pub to_srgb: Option<[[f64; 3]; 3]>,
    /// How a viewer shows the file, if its EXIF data state another orientation than the rows have.
    pub orientation: Option<Orientation>,
}

impl PngSamples {
    /// The picture as a viewer shows it.
    #[must_use]
    pub fn upright(self) -> Self {
        let Some(orientation) = self.orientation else { return self };
        let stored = [self.width, self.height];
        let [width, height] = orientation.size(stored);
        Self {
            width,
            height,
            colors: orientation.picture(self.colors, stored),
            opacities: orientation.picture(self.opacities, stored),
            orientation: None,
            ..self
        }
    }
}

/// Reads a PNG of any color type, 1 to 16 bits. For an animation it reads the first frame.
///
/// # Errors
///
/// If the file cannot be read, is not a PNG, is broken or cut short, claims more pixels than its
/// bytes can hold, or has more than 2²⁵.
pub fn read(file: impl Into<InputFile>) -> Result<PngSamples> {
    let file = file.into();
    let bytes = file.bytes()?;
    decode(&bytes, &file).map_err(|error| error.in_file(file.path()))
}

fn decode(bytes: &[u8], file: &InputFile) -> Result<PngSamples> {
    let mut decoder = Decoder::new(Cursor::new(bytes));
    // A color profile or a text may unpack to a thousand times its size, and neither is needed.
    decoder.set_ignore_iccp_chunk(true);
    decoder.set_ignore_text_chunk(true);
    let header = decoder.read_header_info().map_err(|error| fault(&error))?;
    let (width, height) = (u64::from(header.width), u64::from(header.height));
    let bits = (header.bits_per_pixel() as u64).max(1);
    let most = (bytes.len() as u64).saturating_mul(MOST_BYTES_PER_BYTE);
    // 128 bits hold the product of any values in a header.
    if u128::from(width) * u128::from(height) / 8 * u128::from(bits) > u128::from(most) {
        return Err(Error::new(
            format!(
                "its header claims {width} x {height} pixels, which {} bytes cannot hold",
                bytes.len()
            ),
            "export the picture again",
        ));
    }
    file.at_most(width.saturating_mul(height), MOST_PIXELS, "pixels")?;
    // A row of the picture, and the buffers of other chunks, which double as they are read.
    let limit = (MOST_BYTES_PER_PIXEL * width).saturating_add(4 * bytes.len() as u64);
    decoder.set_limits(Limits { bytes: usize::try_from(limit + BESIDE).unwrap_or(usize::MAX) });
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(|error| fault(&error))?;
    let curve = Curve::of(reader.info(), bytes);
    let to_srgb = to_srgb(reader.info());
    let size = reader.output_buffer_size().ok_or_else(|| fault(&DecodingError::LimitsExceeded))?;
    let mut buffer = vec![0; size];
    let frame = reader.next_frame(&mut buffer).map_err(|error| fault(&error))?;
    buffer.truncate(frame.buffer_size());
    // Reading to the end detects a truncated file.
    reader.finish().map_err(|error| fault(&error))?;
    let orientation =
        reader.info().exif_metadata.as_ref().and_then(|data| Orientation::of_exif(data));
    let (channels, has_opacity) = match frame.color_type {
        ColorType::Rgba => (4, true),
        ColorType::Rgb | ColorType::Indexed => (3, false),
        ColorType::GrayscaleAlpha => (2, true),
        ColorType::Grayscale => (1, false),
    };
    let (bytes_per_sample, full) = match frame.bit_depth {
        BitDepth::Sixteen => (2, u16::MAX),
        _ => (1, u16::from(u8::MAX)),
    };
    let sample = |pixel: &[u8], channel: usize| match bytes_per_sample {
        2 => u16::from_be_bytes([pixel[2 * channel], pixel[2 * channel + 1]]),
        _ => u16::from(pixel[channel]),
    };
    let color = |pixel: &[u8]| match channels {
        3.. => [0, 1, 2].map(|channel| sample(pixel, channel)),
        _ => [sample(pixel, 0); 3],
    };
    let opacity = |pixel: &[u8]| if has_opacity { sample(pixel, channels - 1) } else { full };
    let pixels = || buffer.chunks_exact(channels * bytes_per_sample);
    Ok(PngSamples {
        width: frame.width as usize,
        height: frame.height as usize,
        full,
        curve,
        colors: pixels().map(color).collect(),
        opacities: pixels().map(opacity).collect(),
        to_srgb,
        orientation,
    })
}

/// The conversion of the primaries that the chunk cICP states, or else those of cHRM.
fn to_srgb(info: &Info<'_>) -> Option<[[f64; 3]; 3]> {
    let stated = match (info.coding_independent_code_points, info.chromaticities()) {
        (Some(points), _) => Primaries::of_code(points.color_primaries),
        (None, Some(chrm)) => {
            let points = [chrm.red, chrm.green, chrm.blue, chrm.white];
            let list = points.map(|(x, y)| [x, y].map(|one| f64::from(one.into_value())));
            let [rgb @ .., white] = list;
            Some(Primaries { rgb, white })
        }
        (None, None) => None,
    };
    stated.filter(|primaries| !primaries.is_srgb()).and_then(Primaries::to_srgb)
}

fn fault(error: &DecodingError) -> Error {
    Error::new(
        format!("it is not a PNG, or it is broken or cut short ({error})"),
        "check the file, or export the picture again as PNG",
    )
}

/// Bytes before the first chunk.
const SIGNATURE: usize = 8;

/// The values 1 and 1 / 2.2 in a gAMA chunk, in units of 1/100,000.
const LINEAR_GAMMA: u32 = 100_000;
const SRGB_GAMMA: u32 = 45_455;

/// How a PNG's samples represent light, as declared in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Curve {
    /// Not declared.
    Undeclared,
    /// Proportional to light.
    Linear,
    /// The curve of IEC 61966-2-1.
    Srgb,
    /// That of a color profile of this name, which is not unpacked.
    Profile(String),
    /// Another curve; the text describes it.
    Other(String),
}

impl Curve {
    /// Uses the first of the chunks cICP, sRGB, iCCP and gAMA that is present.
    ///
    /// Transfer characteristics 8 and 13 of cICP (ITU-T H.273) are linear and sRGB. A gAMA of 1 is
    /// linear and one of 0.45455 is sRGB, each within one unit of the last digit. Color profiles
    /// are not unpacked.
    fn of(info: &Info<'_>, bytes: &[u8]) -> Self {
        let points = info.coding_independent_code_points.map(|points| points.transfer_function);
        if points.is_none()
            && info.srgb.is_none()
            && let Some(name) = profile(bytes)
        {
            return Self::Profile(name);
        }
        let gamma = info.gama_chunk.map(png::ScaledFloat::into_scaled);
        match (points, gamma) {
            (Some(8), _) => Self::Linear,
            (Some(13), _) => Self::Srgb,
            (Some(other), _) => Self::Other(format!("its cICP chunk has the transfer {other}")),
            _ if info.srgb.is_some() => Self::Srgb,
            (None, Some(gamma)) if gamma.abs_diff(LINEAR_GAMMA) <= 1 => Self::Linear,
            (None, Some(gamma)) if gamma.abs_diff(SRGB_GAMMA) <= 1 => Self::Srgb,
            (None, Some(gamma)) => {
                Self::Other(format!("its gAMA chunk is {}", f64::from(gamma) / 1e5))
            }
            (None, None) => Self::Undeclared,
        }
    }
}

/// The name of the color profile in an iCCP chunk before the image data.
fn profile(bytes: &[u8]) -> Option<String> {
    let mut rest = bytes.get(SIGNATURE..)?;
    // Each chunk has a length, a kind, contents and a checksum.
    while let Some(([a, b, c, d, kind @ ..], after)) = rest.split_first_chunk::<8>() {
        match kind {
            b"iCCP" => {
                let name = after.iter().take(80).take_while(|byte| **byte != 0);
                return Some(name.map(|byte| char::from(*byte)).collect());
            }
            b"IDAT" => return None,
            _ => {}
        }
        let length = u32::from_be_bytes([*a, *b, *c, *d]) as usize;
        rest = after.get(length.saturating_add(4)..)?;
    }
    None
}
