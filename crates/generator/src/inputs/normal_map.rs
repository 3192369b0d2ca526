//! Normal maps: PNG of 8 or 16 bits a channel.

use crate::error::{Error, Result};
use crate::inputs::normals::RIM;
use crate::inputs::png_samples;
use std::path::Path;

/// The normal of each pixel that counts, all of the same weight: under orthographic
/// view a pixel is a piece of projected area.
///
/// A channel c of 0..=1 says 2c - 1: red x to the right, green y up, blue z toward the
/// camera. Pixels that are transparent (alpha below one half), or black in the mask, do not
/// count. Lengths are normalised.
///
/// # Errors
///
/// A file that is no PNG or broken, a mask of another size, a pixel that counts and points
/// away from the camera by more than [`RIM`] or has no direction, no pixel that counts.
pub fn read(path: &Path, mask: Option<&Path>) -> Result<Vec<([f64; 3], f64)>> {
    let map = png_samples::read(path)?;
    let mask = match mask {
        Some(mask_path) => Some(mask_of(mask_path, [map.width, map.height])?),
        None => None,
    };
    let full = f64::from(map.full);
    let mut pairs = Vec::new();
    for (number, (colour, opacity)) in map.colours.iter().zip(&map.opacities).enumerate() {
        let is_masked = mask.as_ref().is_some_and(|mask| !mask[number]);
        if is_masked || 2.0 * f64::from(*opacity) < full {
            continue;
        }
        let normal = vector(*colour, map.full);
        let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        if normal[2] < -RIM * length {
            let (column, row) = (number % map.width, number / map.width);
            return Err(Error::new(
                format!(
                    "the normal of pixel {column}, {row} (from 0) points away, z = {:.3}",
                    normal[2]
                ),
                "mask it, or make it transparent: only pixels that show the object may count",
            )
            .in_file(path));
        }
        pairs.push((normal, 1.0));
    }
    Ok(pairs)
}

/// What a sample of red, green and blue says: 2c - 1 of each channel c = sample / `full`,
/// not normalised.
///
/// No sample says 0; a z less than a step below it is the rim, rounded.
#[must_use]
pub fn vector(colour: [u16; 3], full: u16) -> [f64; 3] {
    let full = f64::from(full);
    let [x, y, z] = colour.map(|c| 2.0 * f64::from(c) / full - 1.0);
    [x, y, if z < 0.0 && z > -2.0 / full { 0.0 } else { z }]
}

/// Whether each pixel counts: where the mask is not black.
fn mask_of(path: &Path, [width, height]: [usize; 2]) -> Result<Vec<bool>> {
    let mask = png_samples::read(path)?;
    if (mask.width, mask.height) != (width, height) {
        let (w, h) = (mask.width, mask.height);
        let what = format!("the mask is {w} x {h}, the normal map {width} x {height}");
        return Err(Error::new(what, "make them alike").in_file(path));
    }
    Ok(mask.colours.iter().map(|colour| colour.iter().any(|&c| c > 0)).collect())
}
