//! Radiance maps (`.hdr`), four bytes a pixel: three mantissas and a common
//! exponent, so that no texel is negative.

use super::environment::{EnvironmentMap, believable, broken, other_type};
use crate::error::{Error, Result};
use image::codecs::hdr::HdrDecoder;
use image::{ImageDecoder, ImageError};

/// Decodes a Radiance map, run-length coded or not. The exposure that the
/// header may note is not applied: a map's is arbitrary.
pub(crate) fn decode(bytes: &[u8]) -> Result<EnvironmentMap> {
    if !bytes.starts_with(b"#?") {
        return Err(other_type("Radiance"));
    }
    // Strict, the decoder knows no signature but `#?RADIANCE`; `#?RGBE` is as common.
    let decoder = HdrDecoder::new_nonstrict(bytes).map_err(fault)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    let count = believable(width, height, bytes.len())?;
    let mut pixels = vec![0; 12 * count];
    decoder.read_image(&mut pixels).map_err(fault)?;
    let texels = pixels
        .as_chunks::<4>()
        .0
        .as_chunks::<3>()
        .0
        .iter()
        .map(|texel| texel.map(f32::from_ne_bytes))
        .collect();
    EnvironmentMap::new(width, height, texels)
}

fn fault(error: ImageError) -> Error {
    match error {
        ImageError::Unsupported(error) => Error::new(
            format!("it is of a kind that is not read ({error})"),
            "export it as RGBE, rows from the top, -Y +X",
        ),
        error => broken(error),
    }
}
