//! Portable float maps: `PF` (colour) or `Pf` (grey), width, height, and a
//! number whose sign gives the byte order, then the rows from the bottom up.
//!
//! Read here, since `zune-ppm` 0.5.1 mixes up the rows of a map of odd height.

use super::environment::{EnvironmentMap, believable, broken, other_type};
use crate::error::Result;

/// Decodes a portable float map of either byte order. The size of the number
/// that gives the order, which some call a scale, is not applied.
pub(crate) fn decode(bytes: &[u8]) -> Result<EnvironmentMap> {
    let (magic, rest) = word(bytes).ok_or_else(|| other_type("PFM"))?;
    let channels = match magic {
        "PF" => 3,
        "Pf" => 1,
        _ => return Err(other_type("PFM")),
    };
    let (width, rest) = number::<usize>(rest, "width")?;
    let (height, rest) = number::<usize>(rest, "height")?;
    let (scale, rest) = number::<f32>(rest, "byte order")?;
    let count = believable(width, height, bytes.len())?;
    let (values, spare) = rest.as_chunks::<4>();
    if values.len() != channels * count || !spare.is_empty() {
        let (expected, found) = (4 * channels * count, rest.len());
        return Err(broken(format!("{expected} bytes of pixels expected, {found} found")));
    }
    let decode = if scale < 0.0 { f32::from_le_bytes } else { f32::from_be_bytes };
    let texels = values
        .chunks_exact(channels * width)
        .rev()
        .flat_map(|row| row.chunks_exact(channels))
        .map(|texel| match *texel {
            [r, g, b] => [decode(r), decode(g), decode(b)],
            [grey, ..] => [decode(grey); 3],
            [] => [0.0; 3],
        })
        .collect();
    EnvironmentMap::new(width, height, texels)
}

/// The next word of the header, and what follows the one blank after it.
fn word(bytes: &[u8]) -> Option<(&str, &[u8])> {
    let bytes = bytes.trim_ascii_start();
    // No word of a header is longer; a file of another type may have none at all.
    let end = bytes.iter().take(32).position(u8::is_ascii_whitespace)?;
    let (word, rest) = bytes.split_at(end);
    Some((std::str::from_utf8(word).ok()?, &rest[1..]))
}

fn number<'a, T: std::str::FromStr>(bytes: &'a [u8], what: &str) -> Result<(T, &'a [u8])> {
    word(bytes)
        .and_then(|(word, rest)| Some((word.parse().ok()?, rest)))
        .ok_or_else(|| broken(format!("no {what} in its header")))
}
