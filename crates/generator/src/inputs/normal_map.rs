//! Normal maps: PNG of 8 or 16 bits a channel.

use crate::error::{Error, Result};
use crate::inputs::normals::RIM;
use image::codecs::png::PngDecoder;
use image::{DynamicImage, GenericImageView, ImageDecoder, Limits};
use std::io::Cursor;
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
    let map = decode(path)?;
    let mask = match mask {
        Some(mask_path) => {
            let mask = decode(mask_path)?;
            if mask.dimensions() != map.dimensions() {
                let ((w, h), (width, height)) = (mask.dimensions(), map.dimensions());
                let what = format!("the mask is {w} x {h}, the normal map {width} x {height}");
                return Err(Error::new(what, "make them alike").in_file(mask_path));
            }
            Some(mask.to_luma16())
        }
        None => None,
    };
    let pixels = map.to_rgba16();
    let mut pairs = Vec::new();
    for (column, row, pixel) in pixels.enumerate_pixels() {
        let masked = mask.as_ref().is_some_and(|mask| mask.get_pixel(column, row).0[0] == 0);
        let [r, g, b, alpha] = pixel.0;
        if masked || alpha < 1 << 15 {
            continue;
        }
        let normal = [r, g, b].map(|c| 2.0 * f64::from(c) / f64::from(u16::MAX) - 1.0);
        let length = normal.iter().map(|c| c * c).sum::<f64>().sqrt();
        if normal[2] < -RIM * length {
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

/// A PNG, its size believed only as far as its bytes go.
fn decode(path: &Path) -> Result<DynamicImage> {
    let bytes = std::fs::read(path).map_err(|error| Error::io(path, &error))?;
    let broken = |error: image::ImageError| {
        Error::new(format!("it is no whole PNG ({error})"), "export it again").in_file(path)
    };
    let mut decoder = PngDecoder::new(Cursor::new(&bytes)).map_err(broken)?;
    let (width, height) = decoder.dimensions();
    // Deflate packs at most 1032 bytes in one.
    let most = 1032 * bytes.len() as u64;
    if u64::from(width) * u64::from(height) / 8 > most {
        return Err(Error::new(
            format!("{width} x {height} pixels in {} bytes", bytes.len()),
            "its header is damaged: export it again",
        )
        .in_file(path));
    }
    let mut limits = Limits::default();
    limits.max_alloc = Some(1 << 30);
    decoder.set_limits(limits).map_err(broken)?;
    DynamicImage::from_decoder(decoder).map_err(broken)
}
