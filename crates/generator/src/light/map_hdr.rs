//! Radiance maps (`.hdr`): four bytes per pixel, three mantissas and a common exponent, so no texel
//! is negative.

use crate::light::environment::{BYTES_PER_TEXEL, EnvironmentMap, believable, broken, other_type};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use image::codecs::hdr::HdrDecoder;
use image::{ImageDecoder, ImageError};
use std::fs::File;
use std::io::{BufRead, BufReader};

/// Decodes a Radiance map, run-length encoded or not. The exposure in the header, if any, is not
/// applied, because the exposure of a map is arbitrary.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    if !reader.fill_buf().map_err(io)?.starts_with(b"#?") {
        return Err(other_type("Radiance"));
    }
    // In strict mode the decoder accepts only the signature `#?RADIANCE`; `#?RGBE` is equally
    // common.
    let decoder = HdrDecoder::new_nonstrict(&mut *reader).map_err(fault)?;
    let (width, height) = decoder.dimensions();
    let (width, height) = (width as usize, height as usize);
    let count = believable(width, height, length)?;
    file.admit_pixels(count as u64, BYTES_PER_TEXEL, 4 * width as u64)?;
    let mut texels = vec![[0.0; 3]; count];
    decoder.read_image(bytemuck::cast_slice_mut(&mut texels)).map_err(fault)?;
    if !reader.fill_buf().map_err(io)?.is_empty() {
        return Err(broken("bytes follow its last row"));
    }
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
