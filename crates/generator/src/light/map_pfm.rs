//! Portable float maps: `PF` (color) or `Pf` (gray), width, height, and a number whose sign gives
//! the byte order, followed by the rows from the bottom up.
//!
//! This module reads them itself because `zune-ppm` 0.5.1 mixes up the rows of a map of odd height.

use crate::light::environment::{BYTES_PER_TEXEL, EnvironmentMap, believable, broken, other_type};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use std::fs::File;
use std::io::{BufRead, BufReader, Read};

/// Decodes a portable float map of either byte order. The magnitude of the number that gives the
/// byte order, sometimes called a scale, is not applied.
pub(crate) fn decode(
    reader: &mut BufReader<File>,
    length: u64,
    file: &InputFile,
) -> Result<EnvironmentMap> {
    let io = |error: std::io::Error| Error::io(file.path(), &error);
    // A header is far shorter than the buffer.
    let beginning = reader.fill_buf().map_err(io)?;
    let (magic, rest) = word(beginning).ok_or_else(|| other_type("PFM"))?;
    let channels = match magic {
        "PF" => 3,
        "Pf" => 1,
        _ => return Err(other_type("PFM")),
    };
    let (width, rest) = number::<usize>(rest, "width")?;
    let (height, rest) = number::<usize>(rest, "height")?;
    let (scale, rest) = number::<f32>(rest, "byte order")?;
    if scale == 0.0 || !scale.is_finite() {
        return Err(broken(format!("its header gives the byte order by {scale}")).with_remedy(
            "write -1 for the order of little-endian bytes, 1 for that of big-endian ones",
        ));
    }
    let count = believable(width, height, length)?;
    let header = beginning.len() - rest.len();
    let (expected, found) = (4 * (channels * count) as u64, length - header as u64);
    if expected != found {
        return Err(broken(format!("{expected} bytes of pixels expected, {found} found")));
    }
    reader.consume(header);
    let mut row = vec![0; 4 * channels * width];
    file.admit_pixels(count as u64, BYTES_PER_TEXEL, row.len() as u64)?;
    let mut texels = vec![[0.0; 3]; count];
    let decode = if scale < 0.0 { f32::from_le_bytes } else { f32::from_be_bytes };
    for texels in texels.chunks_exact_mut(width).rev() {
        reader.read_exact(&mut row).map_err(io)?;
        let values = row.as_chunks::<4>().0.chunks_exact(channels);
        for (texel, values) in texels.iter_mut().zip(values) {
            *texel = match *values {
                [r, g, b] => [decode(r), decode(g), decode(b)],
                [gray, ..] => [decode(gray); 3],
                [] => [0.0; 3],
            };
        }
    }
    EnvironmentMap::new(width, height, texels)
}

/// The next word of the header, and the bytes after the single blank that ends it.
fn word(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let bytes = bytes.trim_ascii_start();
    // No word of a header is longer; a file of another type may contain no blank at all.
    let end = bytes.iter().take(32).position(u8::is_ascii_whitespace)?;
    let (word, rest) = bytes.split_at(end);
    Some((std::str::from_utf8(word).ok()?, &rest[1..]))
}

fn number<'a, T: std::str::FromStr>(bytes: &'a [u8], what: &str) -> Result<(T, &'a [u8])> {
    word(bytes)
        .and_then(|(word, rest)| Some((word.parse().ok()?, rest)))
        .ok_or_else(|| broken(format!("no {what} in its header")))
}
