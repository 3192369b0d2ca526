//! Normal maps: PNG with 8 or 16 bits per channel.

use crate::png_samples::{self, PngSamples};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::normals::visible;
use std::ops::RangeInclusive;
use std::path::Path;

/// Allowed lengths of a normal's vector: the length is 1 up to rounding and filtering, and √3 for
/// black and for white.
pub const LENGTHS: RangeInclusive<f64> = 0.5..=1.5;

/// The normal of each pixel that counts, all with the same weight: in orthographic view each pixel
/// is an equal piece of projected area.
///
/// Pixels without a normal, see [`normals`], and pixels that are black in the mask do not count.
///
/// Memory: that of [`png_samples::read`], one more byte for each pixel, and [`BYTES_PER_NORMAL`]
/// for each pixel that counts.
///
/// # Errors
///
/// If a file is not a PNG or is broken, the mask has another size, a pixel that counts points away
/// from the camera, or the file's budget has no room for the memory above.
pub fn read(file: impl Into<InputFile>, mask: Option<&Path>) -> Result<Vec<([f64; 3], f64)>> {
    let file = file.into().with_bytes_beside(1);
    let map = png_samples::read(file.clone())?;
    let mask = match mask {
        Some(mask) => mask_of(file.other(mask), [map.width, map.height])?,
        None => vec![true; map.width * map.height],
    };
    let seen = || {
        each(&map, &mask)
            .zip(&mask)
            .filter(|(_, counts)| **counts)
            .filter_map(|(normal, _)| normal.transpose())
            .map(|normal| normal.map_err(|error| error.in_file(file.path())))
    };
    let count = seen().map(|normal| normal.map(|_| 1)).sum::<Result<u64>>()?;
    file.admit_pixels(mask.len() as u64, png_samples::BYTES_PER_PIXEL, count * BYTES_PER_NORMAL)?;
    let mut pairs = Vec::with_capacity(count as usize);
    for normal in seen() {
        pairs.push((normal?, 1.0));
    }
    Ok(pairs)
}

/// Bytes that [`read`] and [`WeightedNormals`](crate::object::geometry::WeightedNormals) together
/// need for each normal.
pub const BYTES_PER_NORMAL: u64 = 64;

/// The unit normal, z >= 0, of each pixel of a map; `None` where there is no object.
///
/// A channel c in 0..=1 encodes the coordinate 2c - 1: red is x to the right, green is y up, blue
/// is z toward the camera. A pixel is background if its opacity is below one half, or if the length
/// of its vector is not within [`LENGTHS`], which excludes gray, black and white.
///
/// # Errors
///
/// Reports the first pixel that is not background, that counts according to `counts`, and that
/// points away from the camera by more than [`RIM`](eigenshade_model::inputs::normals::RIM) beyond
/// rounding. Such a pixel that does not count has no normal instead.
pub fn normals(map: &PngSamples, counts: &[bool]) -> Result<Vec<Option<[f64; 3]>>> {
    each(map, counts).collect()
}

/// Like [`normals`], one pixel at a time.
fn each(map: &PngSamples, counts: &[bool]) -> impl Iterator<Item = Result<Option<[f64; 3]>>> {
    let full = f64::from(map.full);
    let pixels = map.colors.iter().zip(&map.opacities).zip(counts).enumerate();
    pixels.map(move |(number, ((&color, &opacity), &counts))| {
        let found =
            if 2.0 * f64::from(opacity) < full { Ok(None) } else { normal(map, number, color) };
        if counts { found } else { Ok(found.unwrap_or_default()) }
    })
}

/// Like [`normals`], one pixel at a time, also of pixels whose opacity is below one half: their
/// coverage, the second number, is their opacity. Among these, those that point away from the
/// camera show nothing.
pub(crate) fn shown(map: &PngSamples) -> impl Iterator<Item = Result<Option<([f64; 3], f64)>>> {
    let full = f64::from(map.full);
    map.colors.iter().zip(&map.opacities).enumerate().map(move |(number, (&color, &opacity))| {
        let coverage = f64::from(opacity) / full;
        let found = match coverage {
            0.0 => Ok(None),
            ..0.5 => Ok(normal(map, number, color).unwrap_or_default()),
            _ => normal(map, number, color),
        };
        found.map(|normal| normal.map(|normal| (normal, coverage)))
    })
}

/// The normal of pixel `number`, whatever its opacity, if its vector has an allowed length.
fn normal(map: &PngSamples, number: usize, color: [u16; 3]) -> Result<Option<[f64; 3]>> {
    let vector = vector(color, map.full);
    let length = vector.iter().map(|c| c * c).sum::<f64>().sqrt();
    if !LENGTHS.contains(&length) {
        return Ok(None);
    }
    visible(vector).map(Some).map_err(|(what, _)| {
        let (column, row) = (number % map.width, number / map.width);
        Error::new(
            format!("pixel {column}, {row} (from 0): {what}"),
            "mask it, or make it transparent: only pixels that show the object may count",
        )
    })
}

/// The vector of a red, green and blue sample: 2c - 1 for each channel c = sample / `full`, not
/// normalized.
///
/// No sample encodes exactly 0, so a z less than one step below 0 is rounded to the rim.
fn vector(color: [u16; 3], full: u16) -> [f64; 3] {
    let full = f64::from(full);
    let [x, y, z] = color.map(|c| 2.0 * f64::from(c) / full - 1.0);
    [x, y, if z < 0.0 && z > -2.0 / full { 0.0 } else { z }]
}

/// Whether each pixel counts, which is where the mask is not black.
fn mask_of(file: InputFile, [width, height]: [usize; 2]) -> Result<Vec<bool>> {
    let file = file.with_bytes_beside(1);
    let mask = png_samples::read(file.clone())?;
    if (mask.width, mask.height) != (width, height) {
        let (w, h) = (mask.width, mask.height);
        let what = format!("the mask is {w} x {h}, the normal map {width} x {height}");
        return Err(Error::new(what, "give both the same size").in_file(file.path()));
    }
    Ok(mask.colors.iter().map(|color| color.iter().any(|&c| c > 0)).collect())
}
